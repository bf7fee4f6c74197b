#include "image/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace airlight {
namespace {

constexpr ToneCurve curves[] = {ToneCurve::filmic, ToneCurve::reinhard, ToneCurve::square_root, ToneCurve::exponential};

/// The mean colour, undithered in effect, of a patch of one colour.
std::array<double, 3> shown(std::array<float, 3> rgb, ToneCurve curve, double ev = 0) {
  constexpr int side = 64;
  std::vector<float> row;
  for (int x = 0; x < side; ++x) row.insert(row.end(), rgb.begin(), rgb.end());
  std::vector<std::uint8_t> out(row.size());
  std::array<double, 3> mean{};
  for (int y = 0; y < side; ++y) {
    encode_row(row, y, ev, curve, out);
    for (std::size_t i = 0; i < out.size(); ++i) mean[i % 3] += out[i];
  }
  for (double& m : mean) m /= side * side;
  return mean;
}

double srgb(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

TEST(Tone, curves_are_what_they_say) {
  for (const float x : {0.001f, 0.02f, 0.18f, 0.5f, 1.0f, 3.0f, 20.0f}) {
    const double power = std::pow(double(x), 1.4), filmic = power / (power + std::pow(0.18, 1.4) * (1 / 0.18 - 1));
    const double reinhard = x * (1 + x / (64.0 * 64.0)) / (1 + x);
    // 0.05 of a step: the mean of the dither over 64 x 64 pixels.
    EXPECT_NEAR(shown({x, x, x}, ToneCurve::filmic)[1], srgb(filmic), 0.05) << x;
    EXPECT_NEAR(shown({x, x, x}, ToneCurve::reinhard)[1], srgb(reinhard), 0.05) << x;
    EXPECT_NEAR(shown({x, x, x}, ToneCurve::exponential)[1], srgb(1 - std::exp(-double(x))), 0.05) << x;
    EXPECT_NEAR(shown({x, x, x}, ToneCurve::square_root)[1], 255 * std::sqrt(std::min(double(x), 1.0)), 0.05) << x;
  }
}

TEST(Tone, exposure_is_a_factor_of_two_per_ev) {
  for (const ToneCurve curve : curves) EXPECT_EQ(shown({8192, 4096, 2048}, curve, -13), shown({4, 2, 1}, curve, -2));
}

TEST(Tone, greys_stay_grey_and_black_and_white_are_exact) {
  for (const ToneCurve curve : curves) {
    EXPECT_EQ(shown({0, 0, 0}, curve), (std::array<double, 3>{0, 0, 0}));
    EXPECT_EQ(shown({1.6e9f, 1.6e9f, 1.6e9f}, curve), (std::array<double, 3>{255, 255, 255}));
    const auto grey = shown({0.3f, 0.3f, 0.3f}, curve);
    EXPECT_EQ(grey[0], grey[1]);
    EXPECT_EQ(grey[1], grey[2]);
  }
}

TEST(Tone, more_light_never_looks_darker) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> component(0.0f, 1.0f);
  for (int i = 0; i < 5; ++i) {
    const std::array<float, 3> colour = {component(random), component(random), component(random)};
    for (const ToneCurve curve : curves) {
      double before = 0;
      for (double ev = -6; ev <= 10; ev += 1) {
        const auto now = shown(colour, curve, ev);
        const double largest = std::max({now[0], now[1], now[2]});
        EXPECT_GE(largest, before - 0.1) << "EV " << ev;  // twice the dither's error
        before = largest;
      }
    }
  }
}

TEST(Tone, sunset_keeps_its_hue_and_only_far_above_white_turns_white) {
  // Light 15 degrees from a setting sun. HSV's hue: where the middle component lies between the others (of linear
  // light).
  const auto linear = [](double v) {
    return v / 255 <= 0.04045 ? v / 255 / 12.92 : std::pow((v / 255 + 0.055) / 1.055, 2.4);
  };
  const auto hue_of = [&](std::array<double, 3> c) {
    return (linear(c[1]) - linear(c[2])) / (linear(c[0]) - linear(c[2]));
  };
  for (const double ev : {-4.0, -2.0, 0.0, 1.0, 2.0}) {
    const auto filmic = shown({1.0f, 0.45f, 0.1f}, ToneCurve::filmic, ev);
    EXPECT_NEAR(hue_of(filmic), 0.35 / 0.9, 0.01) << "EV " << ev;
    EXPECT_GT(filmic[0] - filmic[2], 0.3 * filmic[0]) << "EV " << ev << ": washed out";
  }
  for (const ToneCurve curve : curves) {
    const auto sun = shown({1.0f, 0.45f, 0.1f}, curve, 12);
    EXPECT_GT(sun[2], 250) << "the sun must not be an orange spot";
  }
}

TEST(Tone, aureole_is_no_flat_patch) {
  // Each doubling of light up to 6 stops above grey still shows: at least one step of 255 in the sum of the channels.
  for (const ToneCurve curve : curves)
    for (int stop = 0; stop < 6 && curve != ToneCurve::square_root;
         ++stop) {  // that one clips at 1, as its system does
      const float light = 0.18f * std::exp2(float(stop));
      const auto a = shown({light, 0.6f * light, 0.2f * light}, curve),
                 b = shown({2 * light, 1.2f * light, 0.4f * light}, curve);
      EXPECT_GT(b[0] + b[1] + b[2] - a[0] - a[1] - a[2], 1) << "stop " << stop;
    }
}

TEST(Tone, colours_outside_the_gamut_keep_their_luminance) {
  // Twilight's blue-green has negative red. Reinhard's curve works on luminance, so that of the shown colour is known.
  const std::array<float, 3> rgb = {-0.05f, 0.2f, 0.3f};
  const double luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const auto linear = [](double v) {
    return v / 255 <= 0.04045 ? v / 255 / 12.92 : std::pow((v / 255 + 0.055) / 1.055, 2.4);
  };
  const auto c = shown(rgb, ToneCurve::reinhard);
  EXPECT_EQ(c[0], 0) << "only as far towards grey as needed";
  EXPECT_NEAR(0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]), luminance / (1 + luminance),
              2e-3);  // 8 bits
}

TEST(Tone, anything_goes_in) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const ToneCurve curve : curves)
    for (const float v : {nan, inf, -inf, 1e38f, -1e38f, 1e-40f})
      shown({v, 1, v}, curve, 100);  // sanitizers watch the conversion
}

TEST(Tone, dither_hides_the_steps_of_a_smooth_sky) {
  // A ramp of four 8-bit steps over 1024 columns: without dither, means over 16 x 16 pixels would miss by up to half a
  // step.
  constexpr int width = 1024, height = 16, block = 16;
  std::vector<float> row;
  for (int x = 0; x < width; ++x) row.insert(row.end(), 3, 0.2f + 0.02f * float(x) / width);
  std::vector<double> sums(width / block);
  std::vector<std::uint8_t> out(row.size());
  int low = 255, high = 0;
  for (int y = 0; y < height; ++y) {
    encode_row(row, y, 0, ToneCurve::reinhard, out);
    for (int x = 0; x < width; ++x) {
      const int v = out[std::size_t(3 * x)];
      sums[std::size_t(x / block)] += v;
      low = std::min(low, v);
      high = std::max(high, v);
      const double light = row[std::size_t(3 * x)];
      ASSERT_LT(std::abs(v - srgb(light * (1 + light / 4096) / (1 + light))), 1.001) << "never more than one step off";
    }
  }
  EXPECT_GE(high - low, 3) << "the ramp must cross steps";
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double light = 0.2 + 0.02 * (double(i) + 0.5 - 0.5 / block) * block / width;
    EXPECT_NEAR(sums[i] / (block * height), srgb(light * (1 + light / 4096) / (1 + light)), 0.06)
        << i;  // 256 thresholds: 1/16
  }
}

// ---- automatic exposure ----

std::vector<float> patch(std::size_t pixels, float luminance) { return std::vector<float>(3 * pixels, luminance); }

TEST(AutomaticExposure, shows_day_as_light_and_night_as_dark) {
  const auto level = [](float luminance) {  // of 255
    const double ev = automatic_exposure(patch(100, luminance));
    return shown({luminance, luminance, luminance}, ToneCurve::filmic, ev)[1];
  };
  for (const float day : {300.0f, 3000.0f, 30000.0f}) {
    EXPECT_GT(level(day), 115) << day;
    EXPECT_LT(level(day), 165) << day;
  }
  EXPECT_GT(level(1), 60);  // civil twilight
  EXPECT_LT(level(1), 120);
  EXPECT_LT(level(1e-3f), 40);  // moonless night begins here
  EXPECT_LT(level(1e-4f), 8);
  EXPECT_LT(level(1e-6f), 0.01);
}

TEST(AutomaticExposure, stops_at_its_stated_limit) {
  EXPECT_EQ(automatic_exposure(patch(100, 1e-7f)), automatic_exposure_limit);
  EXPECT_EQ(automatic_exposure(patch(100, 0)), automatic_exposure_limit) << "a black picture";
  EXPECT_LE(automatic_exposure(patch(100, 1e-3f)), automatic_exposure_limit);
}

TEST(AutomaticExposure, black_surroundings_and_the_sun_have_no_say) {
  std::vector<float> picture = patch(1000, 3000);
  const double sky = automatic_exposure(picture);
  const std::vector<float> black = patch(9000, 0), dim = patch(9000, 1e-9f), sun = patch(100, 1.6e9f);
  picture.insert(picture.end(), black.begin(), black.end());
  EXPECT_EQ(automatic_exposure(picture), sky);
  picture.insert(picture.end(), sun.begin(), sun.end());
  EXPECT_EQ(automatic_exposure(picture), sky);
  picture.insert(picture.end(), dim.begin(), dim.end());
  EXPECT_NEAR(automatic_exposure(picture), sky, 0.01) << "the last wisps of an atmosphere's rim";
  EXPECT_LT(automatic_exposure(sun), -25) << "unless there is nothing but the sun";
}

TEST(AutomaticExposure, dark_ground_hardly_changes_it) {
  std::vector<float> picture = patch(1000, 3000);
  const double sky = automatic_exposure(picture);
  const std::vector<float> ground = patch(1000, 100);
  picture.insert(picture.end(), ground.begin(), ground.end());
  EXPECT_LT(automatic_exposure(picture) - sky, 1);  // the plain logarithmic mean would rise by 2.5
}

}  // namespace
}  // namespace airlight
