#include "optics/light_lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "optics/colour.h"
#include "optics/rgb_lift.h"
#include "optics/shipped_data.h"

namespace airlight {
namespace {

double ratio(const Atmosphere& air, const std::array<double, 4>& spectrum, std::size_t k) {
  return spectrum[k] / air.sun.irradiance.at(realtime_quad[k]);
}

TEST(LightLift, gives_every_colour_back) {
  for (const char* name : {"earth", "earth-hazy", "mars-clear"}) {
    const LightLift lift = light_lift(built_in_atmosphere(name), realtime_quad);
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> rgb{};
      rgb[c] = 1000;
      const auto back = lift.srgb(lift.spectrum(rgb));
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], rgb[i], 1e-9) << name;  // 1000 cd/m2 in doubles
    }
  }
}

TEST(LightLift, sunlight_comes_back_as_sunlight) {
  const Atmosphere air = built_in_atmosphere("earth");
  const LightLift lift = light_lift(air, realtime_quad);
  std::array<double, 4> sun{};
  for (std::size_t k = 0; k < 4; ++k) sun[k] = air.sun.irradiance.at(realtime_quad[k]);
  const auto spectrum = lift.spectrum(lift.srgb(sun));
  // It is perfectly smooth relative to itself, so that no other spectrum of its colour is chosen.
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(spectrum[k] / sun[k], 1, 1e-9);
}

TEST(LightLift, the_free_part_is_the_smoothest) {
  const Atmosphere air = built_in_atmosphere("earth");
  const LightLift lift = light_lift(air, realtime_quad);
  const auto bending = [&](const std::array<double, 4>& s) {
    double sum = 0;
    const auto slope = [&](std::size_t k) {
      return (ratio(air, s, k + 1) - ratio(air, s, k)) / (realtime_quad[k + 1] - realtime_quad[k]);
    };
    for (std::size_t k = 0; k < 2; ++k) sum += std::pow(slope(k + 1) - slope(k), 2);
    return sum;
  };
  // What a spectrum loses on its way through the colours has no colour: added, it makes any other spectrum of the same one.
  const auto green = lift.spectrum({0.1, 0.5, 0.2});
  std::array<double, 4> other{1, 2, 4, 3}, invisible{};
  const auto same = lift.spectrum(lift.srgb(other));
  for (std::size_t k = 0; k < 4; ++k) invisible[k] = other[k] - same[k];
  for (const double rgb : lift.srgb(invisible)) ASSERT_NEAR(rgb, 0, 1e-9);
  for (const double amount : {-1e-3, -1e-5, 1e-5, 1e-3}) {
    auto changed = green;
    for (std::size_t k = 0; k < 4; ++k) changed[k] += amount * invisible[k] * green[1];
    EXPECT_GT(bending(changed), bending(green)) << amount;
  }
}

/// Earth's air, and how deep it is.
struct RealSurfaces : testing::Test {
  const Atmosphere air = built_in_atmosphere("earth");
  const LightLift lift = light_lift(air, realtime_quad);
  std::array<double, 4> depth{};

  void SetUp() override {
    const Sky sky(air, "single");
    const Ray up{.altitude = 0, .view = {0, 0, 1}, .sun = {0, 0, 1}};
    sky.evaluate(Quantity::transmittance, {&up, 1}, realtime_quad, depth);
    for (double& d : depth) d = -std::log(d);
  }

  /// The worst error of a hazed colour, as part of the surface's brightest channel, where only the surface's colour was known: lit
  /// through 1 to `sun_mass` air masses and seen through up to `mass` of them.
  double worst(const std::array<double, 4>& albedo, double sun_mass, double mass) const {
    double error = 0;
    for (const double down : {1.0, sun_mass}) {
      for (const double part : {0.1, 0.3, 1.0}) {
        std::array<double, 4> light{}, seen{};
        for (std::size_t k = 0; k < 4; ++k)
          light[k] = albedo[k] * air.sun.irradiance.at(realtime_quad[k]) * std::exp(-down * depth[k]);
        auto lifted = lift.spectrum(lift.srgb(light));
        for (std::size_t k = 0; k < 4; ++k) {
          const double through = std::exp(-part * mass * depth[k]);
          seen[k] = light[k] * through;
          lifted[k] *= through;
        }
        const auto bare = lift.srgb(light), truth = lift.srgb(seen), answer = lift.srgb(lifted);
        for (std::size_t c = 0; c < 3; ++c)
          error = std::max(error, std::abs(answer[c] - truth[c]) / *std::ranges::max_element(bare));
      }
    }
    return error;
  }
};

TEST_F(RealSurfaces, keep_their_colour_through_haze) {
  const auto of = [](const std::array<double, 3>& rgb) {
    std::array<double, 4> albedo{};
    lift_rgb(rgb, realtime_quad, albedo);
    return albedo;
  };
  std::array<double, 4> grass{};
  for (std::size_t k = 0; k < 4; ++k)
    grass[k] = Spectrum(*shipped_spectrum("grass_albedo.csv", Sampling::bins)).at(realtime_quad[k]);
  const std::pair<const char*, std::array<double, 4>> surfaces[] = {{"rock", of({0.17, 0.15, 0.13})},
                                                                    {"snow", of({0.85, 0.87, 0.89})},
                                                                    {"water", of({0.02, 0.03, 0.04})},
                                                                    {"grass", grass},
                                                                    {"red paint", of({0.5, 0.1, 0.1})}};
  // The bounds are what four wavelengths cannot know of: measured 0.0020, 0.0007, 0.0030, 0.0151, 0.0064 through an air mass (grass
  // and paint have an edge between two of them), and twice that at sunset through three.
  const double bound[] = {0.004, 0.002, 0.005, 0.018, 0.009};
  for (std::size_t i = 0; i < std::size(surfaces); ++i) {
    EXPECT_LT(worst(surfaces[i].second, 2, 1), bound[i]) << surfaces[i].first;
    EXPECT_LT(worst(surfaces[i].second, 5, 3), 2.5 * bound[i]) << surfaces[i].first;
    EXPECT_GT(worst(surfaces[i].second, 2, 1), bound[i] / 10) << surfaces[i].first << ": is the colour lost at all?";
  }
}

TEST(LightLift, a_sun_without_colours_is_refused) {
  Atmosphere air = built_in_atmosphere("earth");
  air.sun.irradiance = Spectrum(0.0);
  EXPECT_THROW(light_lift(air, realtime_quad), InputError);
}

}  // namespace
}  // namespace airlight
