// Tables on disk: what is damaged, cut short or somebody else's is made anew, never used.
#include "engine/table_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>

#include "../scratch_folder.h"
#include "airlight/engine.h"

namespace airlight {
namespace {

constexpr Shape shape{7, 5, 3};

std::vector<double> numbers(double first) {
  std::vector<double> values(4 * shape.texels());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = first + 0.25 * double(i);
  return values;
}

/// Asks an engine for a table, and says whether it had to be made and what was said.
struct Asked {
  bool made = false;
  std::vector<std::string> messages;
  std::vector<double> values = std::vector<double>(4 * shape.texels());
};
Asked ask(const std::string& folder, const char* engine_name, double parameter) {
  Asked asked;
  const auto engine = make_engine(engine_name);
  engine->keep_on_disk(folder, [&](const std::string& message) { asked.messages.push_back(message); });
  const auto tables = engine->make_once("test", std::vector{parameter}, {}, [&] {
    asked.made = true;
    return std::vector<Table>{engine->lend(shape, numbers(parameter)), engine->lend(shape, numbers(parameter + 1))};
  });
  EXPECT_EQ(tables.size(), 2u);
  engine->read(tables[0], asked.values);
  return asked;
}

void write(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) found.push_back(entry.path().string());
  std::ranges::sort(found);
  return found;
}

TEST(TableFile, tables_outlive_the_engine_that_made_them) {
  for (const char* engine : {"double", "simd"}) {
    const Folder folder;
    EXPECT_TRUE(ask(folder / "kept", engine, 1).made);
    const Asked again = ask(folder / "kept", engine, 1);
    EXPECT_FALSE(again.made) << engine;
    EXPECT_EQ(again.values, numbers(1));
    EXPECT_TRUE(again.messages.empty());
    EXPECT_TRUE(ask(folder / "kept", engine, 2).made) << "another parameter";
  }
}

TEST(TableFile, an_engine_of_other_numbers_makes_its_own) {
  const Folder folder;
  ask(folder / "kept", "simd", 1);
  EXPECT_TRUE(ask(folder / "kept", "double", 1).made);
}

TEST(TableFile, whatever_is_wrong_with_a_file_it_is_made_anew_with_a_message) {
  const Folder folder;
  ask(folder / "kept", "simd", 1);
  ask(folder / "kept", "simd", 2);
  const auto files = files_in(folder / "kept");
  ASSERT_EQ(files.size(), 2u);
  const std::string good[] = {read_file(files[0]), read_file(files[1])};
  std::mt19937 random(20260621);
  for (int i = 0; i < 200; ++i) {
    std::string bad = good[0];
    const std::size_t at = random() % bad.size();
    switch (i % 5) {
      case 0:
        bad[at] = char(bad[at] ^ (1 << random() % 8));  // one bit
        break;
      case 1:
        bad.resize(at);  // cut short
        break;
      case 2:
        bad += std::string(8 * (1 + random() % 9), '\0');  // longer
        break;
      case 3:
        bad = good[1];  // another's
        break;
      default:
        for (std::size_t k = at; k < std::min(at + 64, bad.size()); ++k) bad[k] = char(random());
        break;
    }
    write(files[0], bad);
    int made = 0;
    for (const double parameter : {1.0, 2.0}) {
      const Asked asked = ask(folder / "kept", "simd", parameter);
      EXPECT_EQ(asked.values, numbers(parameter)) << "damage " << i;
      EXPECT_EQ(asked.messages.size(), asked.made ? 1u : 0u) << "damage " << i;
      made += asked.made;
    }
    EXPECT_EQ(made, 1) << "damage " << i;
    EXPECT_EQ(read_file(files[0]), good[0]) << "damage " << i;
  }
}

TEST(TableFile, processes_that_make_the_same_tables_do_not_disturb_each_other) {
  const Folder folder;
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    if (const pid_t child = fork(); child != 0) {
      children.push_back(child);
      continue;
    }
    // No engine: its threads do not survive a fork.
    const TableFile file{folder / "shared", 42, 4};
    bool good = true;
    for (int round = 0; round < 50; ++round) {
      std::string trouble = file.write({{shape, numbers(3)}});
      good = good && trouble.empty();
      const auto read = file.read(trouble);
      good = good && read && trouble.empty() && read->at(0).rgba == numbers(3);
    }
    _exit(good ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(folder.names().size(), 1u) << "temporary files are left behind";
}

TEST(TableFile, a_kill_while_writing_leaves_the_whole_file_or_none) {
  const Folder folder;
  const Shape large{128, 128, 4};
  const std::vector<TableFile::Values> tables{{large, std::vector<double>(4 * large.texels(), 0.5)}};
  std::mt19937 random(20260621);
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const TableFile file{folder / ("kept" + std::to_string(i % 4) + ".tables"), std::uint64_t(i % 4), 4};
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      for (;;) {  // over and over, so that the kill meets any stage
        [[maybe_unused]] const auto told = ::write(ready[1], "", 1);
        file.write(tables);
      }
    }
    char byte;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    usleep(unsigned(random() % 5000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ready[0]);
    close(ready[1]);
    std::string trouble;
    const auto found = file.read(trouble);
    EXPECT_EQ(trouble, "") << "kill " << i;
    if (!found) continue;
    ++whole;
    EXPECT_EQ(found->at(0).rgba, tables[0].rgba) << "kill " << i;
  }
  EXPECT_GT(whole, 0) << "no kill came after a write: nothing was tested";
  // What the killed have left is removed when nobody can be writing it any more.
  for (const auto& name : files_in(folder / "")) {
    if (name.find(".partial-") != std::string::npos)
      std::filesystem::last_write_time(name, std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
  }
  TableFile{folder / "kept0.tables", 1, 4}.write(tables);
  for (const auto& name : files_in(folder / "")) EXPECT_EQ(name.find(".partial-"), std::string::npos) << name;
}

TEST(TableFile, a_folder_that_cannot_be_written_costs_a_message_only) {
  const Folder folder;
  write(folder / "file", "in the way");
  const Asked asked = ask(folder / "file", "simd", 1);
  EXPECT_TRUE(asked.made);
  EXPECT_EQ(asked.messages.size(), 1u);
  EXPECT_EQ(asked.values, numbers(1));
}

}  // namespace
}  // namespace airlight
