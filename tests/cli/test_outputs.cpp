// Whatever goes wrong, an output file is whole or absent, and an old one stays as it was.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "run_program.h"

namespace airlight {
namespace {

using namespace std::chrono_literals;
using Names = std::vector<std::string>;

const std::vector<std::string> picture{"sky", "--sun-elevation", "30", "--size", "256x128", "--float", "-o"};

std::vector<std::string> picture_to(const std::string& file) {
  auto words = picture;
  words.push_back(file);
  return words;
}

TEST(Outputs, a_full_disk_is_exit_code_1_and_leaves_nothing) {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "full.exr");
  const Outcome outcome = run(folder, picture_to("full.exr"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("No space left"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), Names{"full.exr"});

  const Outcome text = run(folder, {"planets", "-o", "/dev/full"});
  EXPECT_EQ(text.code, 2);  // lists go to standard output only
  const Outcome probe = run(folder, {"probe", "--sun-elevation", "30", "-o", "/dev/full"});
  EXPECT_EQ(probe.code, 1);
  EXPECT_NE(probe.err.find("/dev/full"), std::string::npos) << probe.err;
}

TEST(Outputs, a_file_size_limit_is_exit_code_1_and_the_old_file_stays) {
  for (const char* file : {"old.exr", "old.png", "old.hdr"}) {
    const Folder folder;
    write_file(folder / file, "precious");
    const Outcome outcome = run(folder, picture_to(file), {.file_size_limit = 4096});
    EXPECT_EQ(outcome.code, 1) << file;
    EXPECT_NE(outcome.err.find(file), std::string::npos) << outcome.err;
    EXPECT_EQ(read_file(folder / file), "precious");
    EXPECT_EQ(folder.names(), Names{file});
  }
}

TEST(Outputs, a_folder_in_place_of_a_file_is_refused_before_the_work) {
  const Folder folder;
  std::filesystem::create_directory(folder / "taken.exr");
  const Outcome outcome = run(folder, picture_to("taken.exr"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("taken.exr"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), Names{"taken.exr"});
}

TEST(Outputs, an_old_file_is_replaced_when_all_goes_well) {
  const Folder folder;
  write_file(folder / "old.png", "old");
  EXPECT_EQ(run(folder, picture_to("old.png")).code, 0);
  EXPECT_EQ(read_file(folder / "old.png").substr(1, 3), "PNG");
  EXPECT_EQ(folder.names(), Names{"old.png"});
}

TEST(Outputs, one_bad_output_of_two_writes_neither) {
  const Folder folder;
  auto words = picture_to("good.exr");
  words.insert(words.end(), {"-o", "bad.tif"});
  EXPECT_EQ(run(folder, words).code, 2);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Outputs, a_pipe_is_written_directly) {
  const Folder folder;
  const std::string pipe = folder / "pipe.png";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Program program(folder, picture_to("pipe.png"));
  std::string bytes;
  std::thread reader([&] { bytes = read_file(pipe); });
  const Outcome outcome = program.wait();
  if (outcome.code != 0) {  // let the reader go
    const int end = open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
    if (end >= 0) close(end);
  }
  reader.join();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_TRUE(S_ISFIFO([&] {
    struct stat about = {};
    stat(pipe.c_str(), &about);
    return about.st_mode;
  }()));
}

TEST(Outputs, standard_output_that_is_full_is_exit_code_1) {
  const Folder folder;
  // The command's standard output is a file in Program; a size limit of nothing fills it at once.
  const Outcome outcome = run(folder, {"models"}, {.file_size_limit = 0});
  EXPECT_EQ(outcome.code, 1);
}

TEST(Outputs, an_interrupt_in_the_middle_is_130_and_leaves_nothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder folder;
    write_file(folder / "old.exr", "precious");
    // Large enough to take many seconds on any machine.
    Program program(folder, {"sky", "--sun-elevation", "3", "--model", "single", "--engine", "double", "--wavelengths",
                             "40", "--size", "16384x8192", "-o", "old.exr", "-o", "new.png"});
    const auto patience = std::chrono::steady_clock::now() + 20s;
    while (folder.names().size() < 3 && std::chrono::steady_clock::now() < patience) std::this_thread::sleep_for(5ms);
    ASSERT_EQ(folder.names().size(), 3u) << "two temporary files beside the old one";
    std::this_thread::sleep_for(300ms);  // well into the rendering
    ASSERT_TRUE(program.running());
    program.signal(signal);
    const Outcome outcome = program.wait(20);
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos);
    EXPECT_EQ(folder.names(), Names{"old.exr"});
    EXPECT_EQ(read_file(folder / "old.exr"), "precious");
  }
}

TEST(Outputs, an_interrupt_while_tables_are_made_is_130_at_once_and_keeps_none) {
  const Folder folder;
  // Tables of forty wavelengths: a minute on any machine.
  Program program(folder, {"probe", "--model", "precomputed", "--sun-elevation", "3"},
                  {.environment = {"AIRLIGHT_CACHE=" + (folder / "cache")}});
  std::this_thread::sleep_for(700ms);
  ASSERT_TRUE(program.running());
  program.signal(SIGINT);
  const Outcome outcome = program.wait(20);
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  // Where nobody heeds it for a second, the program ends on the spot with another message.
  EXPECT_NE(outcome.err.find("interrupted; nothing was written"), std::string::npos) << outcome.err;
  if (std::filesystem::exists(folder / "cache")) {
    for (const auto& file : std::filesystem::directory_iterator(folder / "cache"))
      EXPECT_EQ(file.path().extension(), ".tables") << "half a file: " << file.path();
  }
}

TEST(Outputs, an_interrupt_while_waiting_for_input_is_130) {
  const Folder folder;
  const std::string pipe = folder / "in.jsonl";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Program program(folder, {"probe", "--batch", "in.jsonl", "-o", "out.jsonl"});
  const int writer = open(pipe.c_str(), O_WRONLY);  // returns when the command has opened its end
  ASSERT_GE(writer, 0);
  std::this_thread::sleep_for(200ms);
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(10).code, 130);
  close(writer);
  EXPECT_EQ(folder.names(), Names{"in.jsonl"});
}

TEST(Outputs, nothing_is_drawn_on_standard_error_that_is_no_terminal) {
  const Folder folder;
  const Outcome outcome = run(folder, picture_to("a.exr"));
  EXPECT_EQ(outcome.err.find('\r'), std::string::npos);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\033'), 0);
}

}  // namespace
}  // namespace airlight
