#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scenes.h"

namespace airlight::test {
namespace {

/// @param ground_radius  [m]
Atmosphere random_planet(std::mt19937& random, double ground_radius) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto logarithmic = [&](double low, double high) { return low * std::pow(high / low, unit(random)); };
  Atmosphere a = built_in_atmosphere(unit(random) < 0.5 ? "earth-bruneton" : "mars-clear");
  a.name = "random";
  a.planet.ground_radius = ground_radius;
  a.planet.top_altitude = std::min(logarithmic(1e3, 2e5), 5 * a.planet.ground_radius);
  a.planet.albedo = unit(random);
  a.sun.angular_radius = logarithmic(1e-4, 0.05);
  for (Constituent& c : a.constituents) {
    if (std::holds_alternative<ExponentialProfile>(c.profile))
      c.profile = ExponentialProfile{logarithmic(10, a.planet.top_altitude)};
    c.absorption = 1e-6 * unit(random);
    c.scattering = c.scattering.scaled(logarithmic(1e-2, 1e3));  // from nearly nothing to dense fog
  }
  return a;
}

constexpr double wavelengths[] = {400, 500, 600, 750};
/// The lowest observers are so deep below the ground sphere [m]: each altitude there has a ground, and tables, of its own.
double deepest(const Atmosphere& a) { return std::min(1000.0, 0.5 * a.planet.ground_radius); }

/// The air with so little of it that its optical depth, straight down through it all, is below 2.
Atmosphere thinned(Atmosphere a) {
  const auto scale = [](Atmosphere air, double factor) {
    for (Constituent& c : air.constituents) c.scattering = c.scattering.scaled(factor);
    return air;
  };
  const Ray up{.altitude = -deepest(a), .view = {0, 0, 1}};
  std::vector<double> left(4);
  Sky(scale(a, 1e-3), "single", make_engine("double")).evaluate(Quantity::transmittance, {&up, 1}, wavelengths, left);
  return scale(a, std::min(1.0, 1.5e-3 / -std::log(*std::ranges::min_element(left))));
}

// Altitudes from 1 km below the ground sphere to a million km, views and suns anywhere, segments from a millimetre.
std::vector<Ray> random_rays(std::mt19937& random, const Atmosphere& a, int count) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  const auto anywhere = [&] {
    const double x = normal(random), y = normal(random), z = normal(random), n = std::sqrt(x * x + y * y + z * z);
    return Direction{x / n, y / n, z / n};
  };
  std::vector<Ray> rays;
  const double depths[] = {-deepest(a), -1e-3};
  for (int i = 0; i < count; ++i) {
    Ray r;
    const double kind = unit(random);
    r.altitude = kind < 0.1    ? 0
                 : kind < 0.15 ? depths[i % 2]
                 : kind < 0.2  ? a.planet.top_altitude
                               : std::pow(10, -3 + 12 * unit(random));
    r.view = anywhere();
    r.sun = anywhere();
    if (unit(random) < 0.1) r.sun = r.view;
    if (unit(random) < 0.1) r.sun = {-r.view[0], -r.view[1], -r.view[2]};
    if (unit(random) < 0.05) r.view = {0, 0, unit(random) < 0.5 ? 1.0 : -1.0};
    if (unit(random) < 0.05) r.view = {1, 0, 0};
    if (unit(random) < 0.05) r.sun = {0, 1, 0};
    if (unit(random) < 0.4) r.distance = std::pow(10, -3 + 10 * unit(random));
    if (unit(random) < 0.02) r.distance = 0;
    rays.push_back(r);
  }
  return rays;
}

class Robustness : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Robustness, random_views_are_finite_and_never_negative) {
  const auto [engine_name, model] = GetParam();
  if (std::string_view(engine_name) == "gl" && !has_gl()) GTEST_SKIP() << "no OpenGL 4.5 here";
  constexpr unsigned seed = 20261122;
  std::mt19937 random(seed);
  const auto engine = make_engine(engine_name);
  const bool has_orders = std::string_view(model) == "precomputed";
  // Three grounds a planet are three sets of tables for precomputed, of one or two seconds each on the slower engines.
  const bool fast = std::string_view(engine_name) == "simd";
  const int planets = has_orders ? (fast ? 5 : 2) : fast ? 10 : 5;
  const int views = has_orders ? 500 : 2000;
  for (int p = 0; p < planets; ++p) {
    // From a rock to a giant.
    Atmosphere a = random_planet(random, 1e3 * std::pow(1e5, p / (planets - 1.0)));
    Parameters parameters;
    if (has_orders) {
      a = thinned(a);
      parameters["detail"] = "draft";
    }
    const Sky sky(a, model, engine, parameters);
    const auto rays = random_rays(random, a, views);
    std::vector<double> out(4 * rays.size());
    for (Quantity q : {Quantity::radiance, Quantity::path_radiance, Quantity::transmittance}) {
      sky.evaluate(q, rays, wavelengths, out);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const Ray& r = rays[i / 4];
        ASSERT_TRUE(std::isfinite(out[i]) && out[i] >= 0 && out[i] < 1e4)
            << out[i] << " for quantity " << int(q) << ", planet " << p << " (radius " << a.planet.ground_radius
            << ", top " << a.planet.top_altitude << "), altitude " << r.altitude << ", view " << r.view[0] << ' '
            << r.view[1] << ' ' << r.view[2] << ", sun " << r.sun[0] << ' ' << r.sun[1] << ' ' << r.sun[2]
            << ", distance " << r.distance << ", seed " << seed;
        if (q == Quantity::transmittance) {
          ASSERT_LE(out[i], 1);
        }
      }
    }
    const std::vector<Ray> few(rays.begin(), rays.begin() + 20);
    std::vector<double> light(80);
    for (Quantity q : {Quantity::sun_irradiance, Quantity::sky_irradiance}) {
      sky.evaluate(q, few, wavelengths, light);
      for (double v : light) ASSERT_TRUE(std::isfinite(v) && v >= 0) << v << ", planet " << p;
    }
    Camera camera;
    camera.width = 64;
    camera.height = 32;
    camera.altitude = rays[std::size_t(p)].altitude;
    for (float v : draw(sky, camera, rays[std::size_t(p)].sun)) ASSERT_TRUE(std::isfinite(v)) << "planet " << p;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Robustness,
                         testing::Combine(testing::Values("double", "simd", "gl"),
                                          testing::Values("single", "skyview", "precomputed")),
                         [](const auto& parameter) {
                           return std::string(std::get<0>(parameter.param)) + "_" + std::get<1>(parameter.param);
                         });

}  // namespace
}  // namespace airlight::test
