// Frames that one picture gathers: how they are mixed, and that their noise goes away by it.
#include "sky/frame_blend.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace airlight::test {
namespace {

float mixed(const Gathering& how, const std::vector<float>& frames) {
  FrameBlend blend(how);
  for (const float f : frames) blend.add(std::vector<float>{f});
  float out = 0;
  blend.read({&out, 1});
  return out;
}

TEST(FrameBlend, is_a_mean_in_linear_light_or_forgets_evenly) {
  EXPECT_FLOAT_EQ(mixed({4, 0, false}, {1, 2, 3, 6}), 3);
  // The first frame has no others to be weighed against; each later one takes 0.3 of all.
  EXPECT_FLOAT_EQ(mixed({3, 0.3, false}, {1, 0, 0}), 0.49f);
  EXPECT_FLOAT_EQ(mixed({3, 0.3, false}, {0, 0, 1}), 0.3f);
}

TEST(FrameBlend, mixes_roots_where_the_display_does) {
  // 0.7 * 4 + 0.3 * 9 of the roots of 16 and 81.
  EXPECT_FLOAT_EQ(mixed({2, 0.3, true}, {16, 81}), 5.5f * 5.5f);
  EXPECT_FLOAT_EQ(mixed({2, 0.3, true}, {16, 16}), 16);
}

// ---- Jetlag's pictures ----

const Camera window{.projection = Projection::perspective,
                    .width = 24,
                    .height = 14,
                    .altitude = 200,
                    .azimuth = 135 * degree,
                    .elevation = 12 * degree};

std::vector<float> picture(Parameters parameters, const Camera& camera = window) {
  // 40 frames a second: 1e5 / 40 is whole, so the published random numbers are the table's own, not means of its neighbours.
  parameters.insert({{"still", std::vector{1.0}}, {"frame_rate", std::vector{40.0}}});
  static const auto engine = make_engine("simd");  // the noise is uploaded once
  return draw(Sky(built_in_atmosphere("earth"), "jetlag", engine, parameters), camera, toward(135, 8));
}

/// Noise of a picture, as encoded by a root or in linear light: the deviation of eight of other random numbers.
double noise(Parameters parameters, bool encoded) {
  constexpr int pictures = 8;
  std::vector<double> sums, squares;
  for (int k = 0; k < pictures; ++k) {
    // A thousand frames later by the count, and so with other numbers; a hundredth of a second later by the clouds' clock, which stand.
    const double frame = 1000.0 * k;
    parameters["frame"] = std::vector{frame};
    parameters["time"] = std::vector{300 - frame / 40 + 0.01013 * k};
    const std::vector<float> drawn = picture(parameters);
    sums.resize(drawn.size()), squares.resize(drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const double value = encoded ? std::sqrt(double(drawn[i])) : double(drawn[i]);
      sums[i] += value, squares[i] += value * value;
    }
  }
  double variance = 0;
  for (std::size_t i = 0; i < sums.size(); ++i)
    variance += (squares[i] - sums[i] * sums[i] / pictures) / (pictures - 1) / double(sums.size());
  return std::sqrt(variance);
}
Parameters mean_of(double frames) { return {{"frames", std::vector{frames}}, {"blend", std::vector{0.0}}}; }

// A quarter: the spread of such estimates from 336 pixels, of which some are much noisier than most.
TEST(JetlagNoise, falls_with_the_root_of_the_frames_that_gather) {
  const double one = noise(mean_of(1), false);
  ASSERT_GT(one, 0);
  EXPECT_NEAR(noise(mean_of(9), false) / one, 1 / 3.0, 0.25 / 3);
  EXPECT_NEAR(noise(mean_of(64), false) / one, 1 / 8.0, 0.25 / 8);
}

// Weights w (1 - w)^k: the sum of their squares is w / (2 - w), however many frames there are.
TEST(JetlagNoise, of_blended_frames_ends_where_their_weights_do) {
  const double limit = std::sqrt(0.3 / 1.7), one = noise({}, true);
  EXPECT_NEAR(noise({{"frames", std::vector{12.0}}}, true) / one, limit, 0.25 * limit);
  EXPECT_NEAR(noise({{"frames", std::vector{24.0}}}, true) / one, limit, 0.25 * limit);
}

TEST(JetlagPicture, shows_its_parts) {
  const auto shown = [](const char* what) {
    return picture({{"show", what}, {"jitter", std::vector{0.0}}, {"ground_reach", std::vector{0.0}}});
  };
  const auto all = shown("picture"), molecules = shown("molecules"), haze = shown("haze"), clouds = shown("clouds"),
             depth = shown("light_depth"), through = shown("transmittance");
  double sky = 0, cloud = 0, deep = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 4 == 3) continue;
    EXPECT_NEAR(molecules[i] + haze[i], all[i], 2e-6 * all[i] + 1e-3) << i;  // a sum in float
    EXPECT_GE(through[i], 0);
    EXPECT_LE(through[i], 1.33e4f);  // cd/m^2 of 1
    sky = std::max(sky, double(all[i]));
    cloud = std::max(cloud, double(clouds[i]));
    deep = std::max(deep, double(depth[i]));
  }
  EXPECT_GT(sky, 0);
  EXPECT_GT(cloud, 0);
  EXPECT_GT(deep, 1.33e4) << "no cloud hides the Sun";
}

TEST(JetlagPicture, fades_in_over_32_seconds) {
  const auto at = [](double time, double fade) {
    return picture({{"time", std::vector{time}}, {"jitter", std::vector{0.0}}, {"fade_in", std::vector{fade}}});
  };
  const auto half = at(16, 1), whole = at(16, 0), after = at(40, 1), as_well = at(40, 0), before = at(0, 1);
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (i % 4 == 3) continue;
    EXPECT_NEAR(half[i], 0.5 * whole[i], 1e-6 * whole[i]);
    EXPECT_EQ(after[i], as_well[i]);
    EXPECT_EQ(before[i], 0);
  }
}

}  // namespace
}  // namespace airlight::test
