#include "optics/rgb_lift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "airlight/sky.h"
#include "optics/colour.h"

namespace airlight {
namespace {

std::array<double, 3> seen(const std::vector<Xyz>& weights, const std::vector<double>& wavelengths,
                           const Atmosphere& air, const std::vector<double>& albedo) {
  Xyz xyz{};
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) xyz[k] += weights[i][k] * albedo[i] * air.sun.irradiance.at(wavelengths[i]);
  }
  return xyz_to_srgb(xyz);
}

/// Root mean square over channels and random colours of what comes back less what was given.
double error(const std::vector<double>& wavelengths, double most_colourful) {
  const Atmosphere air = built_in_atmosphere("earth");
  const auto weights = colour_weights(air, wavelengths);
  const auto white = seen(weights, wavelengths, air, std::vector<double>(wavelengths.size(), 1.0));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1), tint(-1, 1);
  double sum = 0;
  constexpr int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double gray = unit(random);
    std::array<double, 3> rgb{};
    for (double& c : rgb) c = std::clamp(gray * (1 + most_colourful * tint(random)), 0.0, 1.0);
    std::vector<double> albedo(wavelengths.size());
    lift_rgb(rgb, wavelengths, albedo);
    const auto back = seen(weights, wavelengths, air, albedo);
    for (std::size_t k = 0; k < 3; ++k) sum += std::pow(back[k] / white[k] - rgb[k], 2) / 3;
  }
  return std::sqrt(sum / count);
}

TEST(RgbLift, is_a_partition_of_one_and_stays_in_it) {
  for (double w = 300; w < 900; w += 1) {
    const auto weights = lift_weights(w);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12) << "gray would not stay gray";
    for (const double part : weights) {
      EXPECT_GE(part, 0);
      EXPECT_LE(part, 1);
    }
  }
  const double wavelengths[] = {445, 515, 565, 635};
  double albedo[4];
  lift_rgb({-1, 0.5, 7}, wavelengths, albedo);
  for (const double a : albedo) {
    EXPECT_GE(a, 0);
    EXPECT_LE(a, 1);
  }
}

TEST(RgbLift, colours_come_back) {
  // With the whole spectrum the lift is fitted to 0.010 over all colours; natural ones are ten times less colourful.
  EXPECT_LT(error(photometric_wavelengths(), 1), 0.012);
  EXPECT_LT(error(photometric_wavelengths(), 0.35), 0.005);
  // Four wavelengths know nothing of what lies between them: 0.045 and 0.018 (docs/scene_file.md).
  const std::vector<double> quad(realtime_quad.begin(), realtime_quad.end());
  RecordProperty("four_wavelengths_all", std::to_string(error(quad, 1)));
  RecordProperty("four_wavelengths_natural", std::to_string(error(quad, 0.35)));
  EXPECT_LT(error(quad, 1), 0.05);
  EXPECT_LT(error(quad, 0.35), 0.02);
}

}  // namespace
}  // namespace airlight
