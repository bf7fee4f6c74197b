#include "image/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "../scratch_folder.h"
#include "airlight/error.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

/// The message of the WorkError that some work ends in; empty: it ended well.
template <class Work>
std::string failure(Work work) {
  try {
    work();
  } catch (const WorkError& error) {
    return error.what();
  }
  return "";
}

TEST(OutputFile, target_appears_only_with_commit) {
  const Folder folder;
  const std::string path = folder / "a.txt";
  put(path, "old");
  OutputFile file(path);
  EXPECT_EQ(fs::path(file.temporary()).extension(), ".txt");
  EXPECT_EQ(fs::path(file.temporary()).parent_path(), fs::path(path).parent_path()) << "a rename must stay on one disk";
  file.write("new ");
  file.write("text");
  EXPECT_EQ(read_file(path), "old");
  file.commit();
  EXPECT_EQ(read_file(path), "new text");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, a_stream_may_write_the_temporary_file) {
  const Folder folder;
  OutputFile file(folder / "a.jsonl");
  put(file.temporary(), "{}\n");
  file.commit();
  EXPECT_EQ(read_file(folder / "a.jsonl"), "{}\n");
}

TEST(OutputFile, leaving_without_commit_changes_nothing) {
  const Folder folder;
  put(folder / "a.txt", "old");
  {
    OutputFile file(folder / "a.txt");
    file.write("half a resu");
  }
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, two_at_once_do_not_meet) {
  const Folder folder;
  OutputFile first(folder / "a.txt"), second(folder / "a.txt");
  first.write("first");
  second.write("second, longer");
  first.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "first");
  second.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "second, longer");
}

TEST(OutputFile, file_limit_is_an_error_and_not_a_death) {
  const Folder folder;
  put(folder / "a.txt", "old");
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = failure([&] {
      OutputFile file(folder / "a.txt");
      file.write(std::string(10000, 'x'));
      file.commit();
    });
    const bool named =
        message.find("a.txt") != std::string::npos && message.find("File too large") != std::string::npos;
    _exit(named ? 7 : 8);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 7) << "no WorkError that names file and reason";
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, new_files_obey_umask_and_old_ones_keep_their_mode) {
  const Folder folder;
  const mode_t before = umask(027);
  OutputFile(folder / "new.txt").commit();
  put(folder / "old.txt", "old");
  chmod((folder / "old.txt").c_str(), 0604);
  OutputFile(folder / "old.txt").commit();
  umask(before);
  EXPECT_EQ(int(fs::status(folder / "new.txt").permissions()), 0640);
  EXPECT_EQ(int(fs::status(folder / "old.txt").permissions()), 0604);
}

TEST(OutputFile, links_are_followed_and_stay) {
  const Folder folder;
  fs::create_directory(folder / "there");
  put(folder / "there/real.txt", "old");
  fs::create_symlink("there/real.txt", folder / "link.txt");
  fs::create_symlink("there/missing.txt", folder / "dangling.txt");
  for (const char* name : {"link.txt", "dangling.txt"}) {
    OutputFile file(folder / name);
    file.write("new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder / name)) << name;
    EXPECT_EQ(read_file(folder / name), "new");
  }
  EXPECT_EQ(read_file(folder / "there/real.txt"), "new");
  fs::create_symlink("loop.txt", folder / "loop.txt");
  EXPECT_THROW(OutputFile(folder / "loop.txt"), InputError);
}

TEST(OutputFile, full_device_is_an_error) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Folder folder;
  fs::create_symlink("/dev/full", folder / "full.exr");
  for (const std::string& path : {std::string("/dev/full"), folder / "full.exr"}) {
    std::string temporary;
    const std::string message = failure([&] {
      OutputFile file(path);
      temporary = file.temporary();
      EXPECT_TRUE(file.direct());
      EXPECT_TRUE(fs::exists(temporary));
      file.write("bytes");
      file.commit();
    });
    EXPECT_NE(message.find(path), std::string::npos) << message;
    EXPECT_NE(message.find("No space left"), std::string::npos) << message;
    EXPECT_FALSE(fs::exists(temporary));
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device itself must stay";
}

TEST(OutputFile, pipe_gets_every_byte) {
  const Folder folder;
  const std::string path = folder / "pipe.txt";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const std::string sent(300'000, 'p');  // more than a pipe holds
  std::string received;
  std::thread reader([&] { received = read_file(path); });
  OutputFile file(path);
  file.write(sent);
  file.commit();
  reader.join();
  EXPECT_TRUE(received == sent) << received.size() << " bytes";
  EXPECT_TRUE(fs::is_fifo(path));
  EXPECT_FALSE(fs::exists(file.temporary()));
}

TEST(OutputFile, reader_that_goes_away_is_an_error) {
  const Folder folder;
  const std::string path = folder / "pipe.txt";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  OutputFile file(path);
  file.write(std::string(1 << 20, 'p'));
  std::thread reader([&] { ::close(::open(path.c_str(), O_RDONLY)); });
  EXPECT_NE(failure([&] { file.commit(); }).find("Broken pipe"), std::string::npos);
  reader.join();
  EXPECT_FALSE(fs::exists(file.temporary()));
}

TEST(OutputFile, descriptor_is_written_where_it_stands) {
  const Folder folder;
  const std::string path = folder / "redirected.txt";
  const int out = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::write(out, "before ", 7), 7);  // what an earlier command of the same redirection wrote
  OutputFile file("/dev/fd/" + std::to_string(out));
  file.write("picture");
  file.commit();
  ::close(out);
  EXPECT_EQ(read_file(path), "before picture");
  EXPECT_THROW(OutputFile("/dev/fd/" + std::to_string(out)), InputError) << "no longer open";
}

TEST(OutputFile, what_cannot_be_written_is_refused_at_once) {
  const Folder folder;
  put(folder / "file", "");
  const auto message = [](const std::string& path) -> std::string {
    try {
      OutputFile file(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  for (const std::string& path :
       {std::string(), folder / "missing/a.exr", folder / "", folder / "file/a.exr", std::string("/proc/a.exr")})
    EXPECT_NE(message(path).find("'" + path + "'"), std::string::npos) << path << ": " << message(path);
  if (geteuid() != 0) {
    fs::create_directory(folder / "closed");
    chmod((folder / "closed").c_str(), 0555);
    EXPECT_NE(message(folder / "closed/a.exr").find("Permission denied"), std::string::npos);
    chmod((folder / "file").c_str(), 0444);
    EXPECT_NE(message(folder / "file").find("Permission denied"), std::string::npos)
        << "a read-only file is not to be replaced";
  }
}

TEST(OutputFile, names_may_be_as_long_as_the_disk_allows) {
  const Folder folder;
  const std::string name = std::string(251, 'n') + ".exr";
  OutputFile(folder / name).commit();
  EXPECT_TRUE(fs::exists(folder / name));
}

TEST(OutputFile, an_interrupt_removes_the_temporary_files_of_all) {
  const Folder folder;
  OutputFile first(folder / "a.txt"), second(folder / "b.txt");
  {
    OutputFile done(folder / "c.txt");
    done.commit();
  }
  OutputFile::remove_all();
  EXPECT_EQ(folder.names().size(), 1u) << "c.txt alone: it was whole";
}

}  // namespace
}  // namespace airlight
