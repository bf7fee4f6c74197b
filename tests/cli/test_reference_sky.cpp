// `airlight sky --model reference`: random walks as pictures, which an interruption does not change.
#include <gtest/gtest.h>

#include <cmath>

#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

using Words = std::vector<std::string>;

Words sky(const std::string& projection, const std::string& size, const std::string& output, Words more) {
  Words words{"sky", "--projection", projection, "--size", size, "-o", output, "--float"};
  for (const char* word : {"--planet", "earth-bruneton", "--sun-elevation", "35", "--sun-azimuth", "130"})
    words.push_back(word);
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const Words walks{"--model", "reference", "--target-error", "0.05"};

// Ten times the error that was asked for: 0.05 of walks, some percent of the model.
void expect_alike(const Picture& reference, const Picture& model) {
  ASSERT_EQ(reference.width, model.width);
  ASSERT_EQ(reference.height, model.height);
  for (int y = 0; y < model.height; ++y)
    for (int x = 0; x < model.width; ++x) {
      const float expected = model.luminance(x, y);
      EXPECT_NEAR(reference.luminance(x, y), expected, 0.3f * expected) << x << ", " << y;
    }
}

// Each face looks where a cube's face of the real-time model looks: neighbours differ by far more than the tolerance.
TEST(ReferenceSky, draws_the_six_faces_of_a_cube) {
  const Folder folder;
  Outcome outcome = run(folder, sky("cube", "3", "walked.exr", walks));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(run(folder, sky("cube", "3", "model.exr", {"--no-sun"})).code, 0);
  const Picture picture = read_picture(folder / "walked.exr");
  EXPECT_EQ(picture.width, 18);
  expect_alike(picture, read_picture(folder / "model.exr"));
  EXPECT_NE(picture.header.find("east west north south up down"), std::string::npos);
  const Picture error = read_picture(folder / "walked.error.exr");
  EXPECT_EQ(error.width, 18);
  for (int x = 0; x < 18; ++x) EXPECT_GT(error.luminance(x, 1), 0) << x;
}

TEST(ReferenceSky, draws_a_fisheye_that_is_black_outside_its_circle) {
  const Folder folder;
  const Outcome outcome = run(folder, sky("fisheye", "8", "walked.exr", walks));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(run(folder, sky("fisheye", "8", "model.exr", {"--no-sun"})).code, 0);
  const Picture picture = read_picture(folder / "walked.exr");
  expect_alike(picture, read_picture(folder / "model.exr"));
  EXPECT_EQ(picture.luminance(0, 0), 0);
  EXPECT_GT(picture.luminance(4, 4), 0);
}

TEST(ReferenceSky, goes_on_after_a_kill_to_identical_files) {
  const Folder whole, killed;
  const Words words = sky("equirectangular", "12x6", "a.exr", {"--model", "reference", "--target-error", "0.02"});
  ASSERT_NO_FATAL_FAILURE(run_through_and_after_a_kill(whole, killed, words));
  EXPECT_EQ(whole.names(), (Words{"a.error.exr", "a.exr"}));
  for (const char* name : {"a.exr", "a.error.exr"}) {
    const std::string bytes = read_file(whole / name);
    EXPECT_GT(bytes.size(), 200u) << name;
    EXPECT_TRUE(bytes == read_file(killed / name)) << name;
  }
}

// Walks of one picture are not added to those of another.
TEST(ReferenceSky, refuses_the_walks_of_another_picture) {
  const Folder folder;
  write_file(folder / "a.walks", "something else\n");
  const Outcome outcome = run(folder, sky("equirectangular", "4x2", "a.exr", walks));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("a.walks: holds the walks of another picture"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_file(folder / "a.walks"), "something else\n");
}

}  // namespace
}  // namespace airlight
