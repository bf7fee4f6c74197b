// Light on surfaces, against sums over the sky's own rays.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "airlight/error.h"
#include "airlight/sky.h"

namespace airlight {
namespace {

constexpr double pi = std::numbers::pi, deg = pi / 180;
const std::vector<double> wavelengths{440, 550, 610, 680};

struct Lit {
  std::vector<double> radiance, skylight;
};
Lit light(const Sky& sky, const std::vector<SurfacePoint>& points, double albedo, double mu_s) {
  const std::size_t n = points.size() * wavelengths.size();
  Lit lit{std::vector<double>(n), std::vector<double>(n)};
  sky.surface(points, mu_s, wavelengths, std::vector<double>(n, albedo), lit.radiance, lit.skylight);
  return lit;
}

TEST(surface, a_level_place_gets_the_sky_s_irradiance_and_the_sun_s) {
  for (const char* model : {"single", "skyview"}) {
    const Sky sky(built_in_atmosphere("earth"), model);
    for (const double altitude : {0.0, 700.0, 2500.0, 6000.0}) {
      for (const double elevation : {50.0, 12.0, 2.0, -3.0}) {
        const double mu_s = std::sin(elevation * deg);
        const Lit lit = light(sky, {{altitude, mu_s, mu_s}}, 0.5, mu_s);
        const Ray ray{altitude, {0, 0, 1}, direction(0, elevation * deg)};
        std::vector<double> skylight(4), sun(4);
        sky.evaluate(Quantity::sky_irradiance, std::span(&ray, 1), wavelengths, skylight);
        sky.evaluate(Quantity::sun_irradiance, std::span(&ray, 1), wavelengths, sun);
        for (std::size_t k = 0; k < 4; ++k) {
          // The same sum, interpolated between altitudes and Suns.
          EXPECT_NEAR(lit.skylight[k], skylight[k], 0.02 * skylight[k])
              << model << ' ' << altitude << " m, sun " << elevation;
          const double expected = 0.5 / pi * (lit.skylight[k] + sun[k] * std::max(mu_s, 0.0));
          EXPECT_NEAR(lit.radiance[k], expected, 2e-3 * expected);
        }
      }
    }
  }
}

// 256 directions, against 20000 in rings about the Sun, where dust and droplets glow: from the horizon to the zenith.
TEST(surface, skylight_holds_the_glow_about_the_sun) {
  for (const char* air : {"earth", "earth-hazy", "mars-clear"}) {
    const Sky sky(built_in_atmosphere(air), "single");
    for (const double elevation : {3.0, 10.0, 30.0, 60.0, 80.0, 90.0}) {
      const double sine = std::sin(elevation * deg), cosine = std::cos(elevation * deg);
      const Direction sun{cosine, 0, sine};
      std::vector<Ray> rays;
      std::vector<double> weights;
      constexpr int rings = 200, spokes = 100;
      for (int i = 0; i < rings; ++i) {
        // Angles from the Sun are squares: the first of 200 is a thousandth of a degree.
        const double root = (i + 0.5) / rings, angle = pi * root * root;
        for (int j = 0; j < spokes; ++j) {
          const double around = (j + 0.5) * pi / spokes, up = std::sin(angle) * std::cos(around);
          const Direction view{std::cos(angle) * cosine - up * sine, std::sin(angle) * std::sin(around),
                               std::cos(angle) * sine + up * cosine};
          if (view[2] < 1e-6) continue;
          rays.push_back({0, view, sun});
          weights.push_back(view[2] * std::sin(angle) * 2 * pi * root / rings * 2 * pi / spokes);
        }
      }
      std::vector<double> light(4 * rays.size()), got(4);
      sky.evaluate(Quantity::path_radiance, rays, wavelengths, light);
      const Ray level{0, {0, 0, 1}, sun};
      sky.evaluate(Quantity::sky_irradiance, {&level, 1}, wavelengths, got);
      for (std::size_t k = 0; k < 4; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) sum += weights[i] * light[4 * i + k];
        // Next to the horizon the sky changes within a ring of the 16, which costs 0.35 %.
        EXPECT_NEAR(got[k] / sum, 1, 0.005) << air << ", sun " << elevation << ", value " << k;
      }
    }
  }
}

// A wall, against the light of all directions before it.
TEST(surface, a_wall_gets_the_light_of_its_half_of_the_sky) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const double elevation = 20 * deg, mu_s = std::sin(elevation);
  for (const double side : {1.0, -1.0}) {  // towards the sun, away from it
    const SurfacePoint wall{0, mu_s, side * std::cos(elevation), {side, 0, 0}, 0, 0.5};
    const Lit lit = light(sky, {wall}, 0.3, mu_s);
    std::vector<Ray> rays;
    std::vector<double> weights;
    constexpr int rings = 60, spokes = 120;
    for (int i = 0; i < rings; ++i) {
      for (int j = 0; j < spokes; ++j) {
        const double z = (i + 0.5) / rings, azimuth = 2 * pi * (j + 0.5) / spokes, across = std::sqrt(1 - z * z);
        const Direction view{across * std::cos(azimuth), across * std::sin(azimuth), z};
        if (side * view[0] <= 0) continue;
        rays.push_back({0, view, {std::cos(elevation), 0, mu_s}});
        weights.push_back(side * view[0] * 2 * pi / rings / spokes);
      }
    }
    std::vector<double> radiance(rays.size() * 4), level(4), sun(4);
    sky.evaluate(Quantity::radiance, rays, wavelengths, radiance);
    sky.evaluate(Quantity::sky_irradiance, std::span(rays).first(1), wavelengths, level);
    sky.evaluate(Quantity::sun_irradiance, std::span(rays).first(1), wavelengths, sun);
    for (std::size_t k = 0; k < 4; ++k) {
      double expected = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) expected += weights[i] * radiance[4 * i + k];
      expected += 0.5 * 0.1 * (level[k] + sun[k] * mu_s);  // the ground before the wall: earth's albedo is 0.1
      std::printf("side %+.0f at %.0f nm: %.4g, summed %.4g\n", side, wavelengths[k], lit.skylight[k], expected);
      // 256 directions see the bright horizon and the aureole coarsely.
      EXPECT_NEAR(lit.skylight[k], expected, 0.03 * expected);
    }
  }
}

TEST(surface, what_faces_away_or_lies_in_shadow_gets_skylight_alone) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const double mu_s = 0.5;
  const SurfacePoint level{0, mu_s, mu_s}, shadowed{0, mu_s, mu_s, {0, 0, 1}, 0}, half{0, mu_s, mu_s, {0, 0, 1}, 0.5},
      away{0, mu_s, -0.2};
  const Lit lit = light(sky, {level, shadowed, half, away}, 1, mu_s);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(lit.radiance[4 + k], lit.skylight[k] / pi, 1e-5 * lit.radiance[k]);
    EXPECT_NEAR(lit.radiance[12 + k], lit.skylight[k] / pi, 1e-5 * lit.radiance[k]);
    EXPECT_NEAR(2 * lit.radiance[8 + k], lit.radiance[k] + lit.radiance[4 + k], 1e-5 * lit.radiance[k]);
  }
}

TEST(surface, bad_questions_are_named) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const SurfacePoint good{};
  SurfacePoint bright = good, nowhere = good, long_normal = good;
  bright.sun_visibility = 2;
  nowhere.altitude = NAN;
  long_normal.normal = {0, 0, 2};
  for (const SurfacePoint& bad : {bright, nowhere, long_normal}) EXPECT_THROW(light(sky, {bad}, 0.5, 1), InputError);
  EXPECT_THROW(light(sky, {good}, 1.5, 1), InputError);
  EXPECT_THROW(light(sky, {good}, 0.5, 1.5), InputError);
}

}  // namespace
}  // namespace airlight
