// `airlight compare`: the table says what the pictures show, and bad words are refused before anything is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mountains.h"
#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

const std::string scene_text = mountains("height_above_ground = 300");

/// The row of a model, numbers in the order of the table's head.
std::vector<double> row_of(const std::string& csv, const std::string& model) {
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(model + ",")) continue;
    std::vector<double> numbers;
    std::istringstream fields(line.substr(model.size() + 1));
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::stod(field));
    return numbers;
  }
  return {};
}

TEST(Compare, the_table_tells_the_pictures_differences) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const Outcome outcome = run(folder, {"compare", "scene.toml", "--models", "skyview", "-o", "out", "--float"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"single.exr", "single.png", "skyview.exr", "skyview.png", "skyview_difference.png",
                           "contact_sheet.png", "compare.csv", "compare.md"})
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("out/") + file))) << file;
  const Picture single = read_picture(folder / "out/single.exr"), skyview = read_picture(folder / "out/skyview.exr");
  double brightest = 0;
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 64; ++x) brightest = std::max(brightest, double(single.luminance(x, y)));
  std::vector<double> errors;
  double sum = 0;
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double b = double(single.luminance(x, y));
      errors.push_back((double(skyview.luminance(x, y)) - b) / std::max(b, 1e-4 * brightest));
      sum += errors.back();
    }
  }
  for (double& e : errors) e = std::abs(e);
  std::sort(errors.begin(), errors.end());
  const std::string csv = read_file(folder / "out/compare.csv");
  const std::vector<double> own = row_of(csv, "single"), other = row_of(csv, "skyview");
  ASSERT_EQ(own.size(), 9u);
  ASSERT_EQ(other.size(), 9u);
  EXPECT_EQ(other[8], 1) << "absolute units are compared as they are";
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(own[i], 0) << "the yardstick differs not from itself";
  // The table is rounded to 0.01; the index of a quantile of 2304 values is exact.
  EXPECT_NEAR(other[0], 100 * errors[std::size_t(0.5 * double(errors.size() - 1))], 0.011);
  EXPECT_NEAR(other[1], 100 * errors[std::size_t(0.95 * double(errors.size() - 1))], 0.011);
  EXPECT_NEAR(other[2], 100 * errors.back(), 0.011);
  EXPECT_NEAR(other[3], 100 * sum / double(errors.size()), 0.011);
  EXPECT_GT(other[3], 5) << "light of higher orders is missing from single";
  EXPECT_GT(other[7], 0);
  // Two rows of two pictures, words below.
  const Picture sheet = read_picture(folder / "out/contact_sheet.png");
  EXPECT_GT(sheet.width, 2 * 64);
  EXPECT_GT(sheet.height, 2 * 36 + 2 * 30);
  EXPECT_TRUE(read_file(folder / "out/compare.md").starts_with("| model "));
}

// Relative colours are brought to the yardstick's sky: the geometric mean of its luminance is the same.
TEST(Compare, scales_relative_colours_once) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const Outcome outcome =
      run(folder, {"compare", "scene.toml", "--models", "hoffman_preetham,jetlag", "-o", "out", "--float", "--no-sun"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(run(folder, {"render", "scene.toml", "-o", "depth.exr", "--aov", "depth"}).code, 0);
  const std::vector<float> depth = read_picture(folder / "depth.exr").layers.at("Z");
  const Picture yardstick = read_picture(folder / "out/single.exr");
  const std::string csv = read_file(folder / "out/compare.csv");
  for (const char* model : {"hoffman_preetham", "jetlag"}) {
    const Picture picture = read_picture(folder / (std::string("out/") + model + ".exr"));
    double sum = 0, sky = 0;
    for (int y = 0; y < 36; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (!std::isinf(depth[std::size_t(64 * y + x)])) continue;
        sum += std::log(double(picture.luminance(x, y)) / double(yardstick.luminance(x, y)));
        ++sky;
      }
    }
    ASSERT_GT(sky, 100);
    EXPECT_NEAR(sum / sky, 0, 1e-4) << model;
    EXPECT_NE(row_of(csv, model).at(8), 1) << model;
  }
}

// Where there is no land, errors are of what lies above the horizon: half of this picture.
TEST(Compare, counts_the_sky_alone_where_a_scene_has_no_land) {
  const Folder folder;
  write_file(folder / "bare.toml",
             "place = \"46.6, 7.9\"\n[sun]\nelevation = 5\nazimuth = 250\n"
             "[camera]\nwidth = 32\nheight = 18\nfield_of_view = 90\nazimuth = 235\n[picture]\nair_shadows = false\n");
  const Outcome outcome =
      run(folder, {"compare", "bare.toml", "--models", "codeflow", "-o", "out", "--float", "--no-sun"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture single = read_picture(folder / "out/single.exr"), codeflow = read_picture(folder / "out/codeflow.exr");
  double worst = 0, below = 0;
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 32; ++x) {
      const double b = double(single.luminance(x, y)), error = std::abs(double(codeflow.luminance(x, y)) / b - 1);
      if (y < 9) worst = std::max(worst, error);
      if (y >= 9) below = std::max(below, error);
    }
  }
  EXPECT_NEAR(row_of(read_file(folder / "out/compare.csv"), "codeflow").at(2), 100 * worst, 0.02);
  EXPECT_GT(below, 2 * worst) << "codeflow's ground is no ground";
  const Picture map = read_picture(folder / "out/codeflow_difference.png");
  EXPECT_EQ(map.rgb[3 * (17 * 32)], map.rgb[3 * (17 * 32) + 1]);
}

TEST(Compare, bad_words_are_named_and_nothing_is_written) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const auto refused = [&](std::vector<std::string> words, const std::string& why) {
    words.insert(words.begin(), {"compare", "scene.toml", "-o", "out"});
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names().size(), 1u);
  };
  refused({"--models", "single,skyveiw"}, "skyview");
  refused({"--models", "single,"}, "--models");
  refused({"--models", "skyview,skyview"}, "twice");
  refused({"--yardstick", "truth"}, "--yardstick");
  refused({"--scale", "0"}, "--scale");
}

}  // namespace
}  // namespace airlight
