// Sequences of systems that blend each frame with those before it: Jetlag's.
#include <gtest/gtest.h>

#include <cmath>

#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

// Without clouds a frame takes little time.
constexpr char scene[] = R"(
[sun]
azimuth = 135
elevation = 8
[camera]
width = 16
height = 10
azimuth = 135
elevation = 12
altitude = 200
[picture]
model = "jetlag"
[jetlag]
mode = "clear"
)";

double root_mean_square(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(std::sqrt(a.rgb[i]) - std::sqrt(b.rgb[i]), 2);
  return std::sqrt(sum / double(a.rgb.size()));
}

TEST(BlendedFrames, of_a_part_made_alone_are_those_of_the_whole) {
  const Folder whole, part;
  for (const Folder* folder : {&whole, &part}) write_file(*folder / "scene.toml", scene);
  ASSERT_EQ(run(whole, {"sequence", "scene.toml", "--frames", "6", "-o", "%d.exr", "--float"}).code, 0);
  const Outcome outcome = run(part, {"sequence", "scene.toml", "--frames", "5:5", "-o", "%d.exr", "--float"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture a = read_picture(whole / "5.exr"), b = read_picture(part / "5.exr"),
                before = read_picture(whole / "4.exr");
  // What is left of the run-in's first frame, which stands for all before it: 0.7^32 = 1e-5 of its noise.
  EXPECT_LT(root_mean_square(a, b), 1e-4 * root_mean_square(a, before));
  // Random numbers move on, and most of a picture is of the frames before.
  const Outcome single = run(part, {"render", "scene.toml", "-o", "single.exr", "--float"});
  const Picture alone = read_picture(part / "single.exr"), first = read_picture(whole / "0.exr");
  EXPECT_GT(root_mean_square(a, before), 0);
  EXPECT_LT(root_mean_square(a, before), 0.7 * root_mean_square(alone, first));
}

TEST(BlendedFrames, are_made_anew_where_a_frame_before_them_is_another) {
  const Folder folder;
  const std::string animated =
      std::string(scene) + "[[animate]]\nkey = \"camera.elevation\"\nframes = [0, 1]\nvalues = [12, 13]\n";
  write_file(folder / "scene.toml", animated);
  const std::vector<std::string> words{"sequence", "scene.toml", "--frames", "2:2", "-o", "%d.exr"};
  ASSERT_EQ(run(folder, words).code, 0);
  EXPECT_NE(run(folder, words).err.find("0 made, 1 there already"), std::string::npos);
  std::string other = animated;
  other.replace(other.find("[12, 13]"), 8, "[20, 13]");  // of frame 2 itself nothing changes
  write_file(folder / "scene.toml", other);
  EXPECT_NE(run(folder, words).err.find("1 made, 0 there already"), std::string::npos);
}

TEST(Accumulate, takes_a_mean_of_many_frames_of_systems_that_have_them) {
  const Folder folder;
  write_file(folder / "scene.toml", scene);
  for (const char* name : {"a.exr", "b.exr"}) {
    const Outcome outcome =
        run(folder, {"render", "scene.toml", "--accumulate", name[0] == 'a' ? "200" : "1", "-o", name});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  EXPECT_GT(root_mean_square(read_picture(folder / "a.exr"), read_picture(folder / "b.exr")), 0);
  const auto complaint = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"render", "scene.toml", "-o", "c.exr"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_NE(complaint({"--accumulate", "0"}).find("jetlag.frames = 0: expected 1 .. 65536"), std::string::npos);
  EXPECT_NE(
      complaint({"--accumulate", "4", "--model", "codeflow"}).find("model codeflow draws each picture in one frame"),
      std::string::npos);
}

}  // namespace
}  // namespace airlight
