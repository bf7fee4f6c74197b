// `airlight sequence`: frames that depend on nothing but their number, whatever happens while they are made.
#include <gtest/gtest.h>

#include <cstdlib>

#include "airlight/error.h"
#include "digest.h"
#include "frame_names.h"
#include "run_program.h"

namespace airlight {
namespace {

// A bare planet: a frame takes little time.
constexpr char scene[] = R"(
place = "46.6,7.9"
[camera]
width = 16
height = 10
field_of_view = 60
altitude = 300
[sun]
time = "2026-06-21T10:00Z"
[picture]
air_shadows = false
[[animate]]
key = "camera.azimuth"
frames = [0, 3]
values = [30, 120]
interpolation = "smooth"
)";

std::vector<std::string> sequence(const std::string& frames, const std::vector<std::string>& outputs) {
  std::vector<std::string> words{"sequence", "scene.toml", "--from", "04:30", "--to", "12:30", "--frames", frames};
  for (const std::string& output : outputs) words.insert(words.end(), {"-o", output});
  return words;
}

TEST(Sequence, resumes_after_a_kill_to_identical_files) {
  const Folder whole, killed;
  for (const Folder* folder : {&whole, &killed}) write_file(*folder / "scene.toml", scene);
  const std::vector<std::string> words = sequence("3", {"f_%04d.exr", "g_%d.png"});
  ASSERT_NO_FATAL_FAILURE(run_through_and_after_a_kill(whole, killed, words));
  for (int frame = 0; frame < 3; ++frame) {
    for (const std::string& name : {"f_000" + std::to_string(frame) + ".exr", "g_" + std::to_string(frame) + ".png"}) {
      const std::string bytes = read_file(whole / name);
      EXPECT_GT(bytes.size(), 500u) << name;
      EXPECT_TRUE(bytes == read_file(killed / name)) << name;
    }
  }
  EXPECT_FALSE(read_file(whole / "f_0000.exr") == read_file(whole / "f_0001.exr"));
  // Nothing is left to do, and it says so.
  EXPECT_NE(run(killed, words).err.find("0 made, 3 there already"), std::string::npos);
}

TEST(Sequence, a_part_made_elsewhere_is_the_same_and_another_scene_is_not_taken_for_it) {
  const Folder whole, part;
  for (const Folder* folder : {&whole, &part}) write_file(*folder / "scene.toml", scene);
  ASSERT_EQ(run(whole, sequence("3", {"%d.png"})).code, 0);
  // The exposure is that of frame 0 here, too, though it is not made.
  ASSERT_EQ(run(part, sequence("1:1/3", {"%d.png"})).code, 0);
  EXPECT_EQ(part.names(), (std::vector<std::string>{"1.png", "scene.toml"}));
  const std::string frame = read_file(part / "1.png");
  EXPECT_TRUE(frame == read_file(whole / "1.png"));

  std::string other = scene;
  other.replace(other.find("altitude = 300"), 14, "altitude = 900");
  write_file(part / "scene.toml", other);
  const Outcome outcome = run(part, sequence("1:1/3", {"%d.png"}));
  EXPECT_NE(outcome.err.find("1 made, 0 there already"), std::string::npos) << outcome.err;
  EXPECT_FALSE(frame == read_file(part / "1.png"));
}

TEST(Sequence, movies_are_encoded_and_their_frames_go) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
  const Folder folder;
  write_file(folder / "scene.toml", scene);
  const Outcome outcome = run(folder, sequence("2", {"day.mp4"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"day.mp4", "scene.toml"}));
  EXPECT_EQ(read_file(folder / "day.mp4").substr(4, 4), "ftyp");  // of an ISO base media file
}

TEST(Sequence, movies_without_ffmpeg_say_what_is_missing) {
  const Folder folder;
  write_file(folder / "scene.toml", scene);
  const Outcome outcome = run(folder, sequence("2", {"day.mp4"}), {.environment = {"PATH=/nowhere"}});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("ffmpeg"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.toml"});
}

TEST(Sequence, bad_words_are_named_and_nothing_is_written) {
  const Folder folder;
  write_file(folder / "scene.toml", scene);
  std::string text = scene;
  text.replace(text.find("[30, 120]"), 9, "[30, 400]");
  write_file(folder / "turn.toml", text);
  const auto before = folder.names();
  const struct {
    std::vector<std::string> words;
    const char* says;
  } cases[] = {{{"scene.toml", "--frames", "5", "-o", "a.exr"}, "frames_%04d.exr"},
               {{"scene.toml", "--frames", "5", "-o", "%d_%d.exr"}, "one place"},
               {{"scene.toml", "--frames", "5", "-o", "%4d.exr"}, "one place"},
               {{"scene.toml", "--frames", "5", "-o", "%d.hdr"}, ".hdr"},
               {{"scene.toml", "--frames", "0", "-o", "%d.exr"}, "--frames"},
               {{"scene.toml", "--frames", "3:2", "-o", "%d.exr"}, "3:2"},
               {{"scene.toml", "--frames", "1:5/5", "-o", "%d.exr"}, "1:5/5"},
               {{"scene.toml", "--frames", "1:2", "--from", "04:30", "--to", "05:30", "-o", "%d.exr"}, "1:2/N"},
               {{"scene.toml", "--frames", "5", "--from", "04:30", "-o", "%d.exr"}, "--to"},
               {{"scene.toml", "--frames", "5", "--from", "4.30", "--to", "05:30", "-o", "%d.exr"}, "4.30"},
               {{"scene.toml", "--frames", "5", "--size", "15x10", "-o", "a.mp4"}, "even"},
               {{"turn.toml", "--frames", "2", "-o", "%d.exr"}, "camera.azimuth = 400"}};
  for (const auto& c : cases) {
    std::vector<std::string> words{"sequence"};
    words.insert(words.end(), c.words.begin(), c.words.end());
    const Outcome outcome = run(folder, words);
    // Where a movie is asked for and there is no ffmpeg, that is told first.
    const bool no_ffmpeg = outcome.code == 1 && outcome.err.find("ffmpeg") != std::string::npos;
    EXPECT_TRUE(no_ffmpeg || outcome.code == 2) << outcome.err;
    EXPECT_TRUE(no_ffmpeg || outcome.err.find(c.says) != std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(Sequence, frames_and_names_are_read) {
  EXPECT_EQ(cli::parse_frames("240").last, 239);
  EXPECT_EQ(cli::parse_frames("100:199").count(), 100);
  EXPECT_EQ(cli::parse_frames("100:199/240").total, 240);
  EXPECT_EQ(cli::FrameNames("a/f_%04d.exr").name(37), "a/f_0037.exr");
  EXPECT_EQ(cli::FrameNames("%d.png").name(12345), "12345.png");
  EXPECT_THROW(cli::FrameNames("%s.png"), InputError);
}

TEST(Sequence, digests_tell_pieces_apart) {
  cli::Digest a, b, c;
  a.add("ab"), a.add("c");
  b.add("a"), b.add("bc");
  c.add("ab"), c.add("c");
  EXPECT_NE(a.text(), b.text());
  EXPECT_EQ(a.text(), c.text());
  EXPECT_EQ(a.text().size(), 16u);
}

}  // namespace
}  // namespace airlight
