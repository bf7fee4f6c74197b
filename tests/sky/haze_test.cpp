// The air before points in view, from the tables of aerial perspective, against rays marched one by one; shadows of land in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "airlight/error.h"
#include "airlight/sky.h"

namespace airlight {
namespace {

constexpr double deg = std::numbers::pi / 180;
const std::vector<double> wavelengths{440, 550, 610, 680};

struct Haze {
  std::vector<double> inscatter, transmittance;
};
Haze haze(const Sky& sky, double altitude, const Direction& sun, std::span<const Sight> points,
          const AirShadows* shadows = nullptr) {
  Haze h{std::vector<double>(points.size() * wavelengths.size()),
         std::vector<double>(points.size() * wavelengths.size())};
  sky.haze(altitude, sun, points, wavelengths, shadows, h.inscatter, h.transmittance);
  return h;
}

// Points from 1 m to 200 km, as land has them: within 10 degrees of the horizontal, and before the ground sphere.
std::vector<Sight> land_sights(double altitude, int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Sight> points;
  while (int(points.size()) < count) {
    const double elevation = (unit(random) - 0.6) * 20 * deg;
    const Sight s{direction(2 * std::numbers::pi * unit(random), elevation), std::pow(10, 5.3 * unit(random)), 0.5};
    const double r = 6.371e6 + altitude,
                 end = std::hypot(r + s.distance * s.view[2], s.distance * std::hypot(s.view[0], s.view[1]));
    if (end > 6.371e6 && std::sin(elevation) * r * s.distance > -1e12) points.push_back(s);
  }
  return points;
}

double median(std::vector<double> v) {
  std::ranges::sort(v);
  return v[v.size() / 2];
}

TEST(haze, the_tables_agree_with_marched_rays) {
  for (const char* air : {"earth", "earth-hazy"}) {
    const Sky sky(built_in_atmosphere(air), "skyview");
    for (const double altitude : {2.0, 1500.0, 12000.0}) {
      for (const double elevation : {45.0, 10.0, 1.0, -3.0}) {
        const Direction sun = direction(0.5, elevation * deg);
        const std::vector<Sight> points = land_sights(altitude, 400, 7);
        const Haze h = haze(sky, altitude, sun, points);
        std::vector<Ray> rays;
        for (const Sight& s : points) rays.push_back({altitude, s.view, sun, s.distance});
        std::vector<double> light(points.size() * 4), through(light.size());
        sky.evaluate(Quantity::path_radiance, rays, wavelengths, light);
        sky.evaluate(Quantity::transmittance, rays, wavelengths, through);
        std::vector<double> errors;
        double worst_through = 0;
        for (std::size_t i = 0; i < light.size(); ++i) {
          errors.push_back(std::abs(h.inscatter[i] / light[i] - 1));
          worst_through = std::max(worst_through, std::abs(h.transmittance[i] - through[i]));
        }
        std::ranges::sort(errors);
        const double middle = errors[errors.size() / 2], most = errors[errors.size() * 95 / 100];
        std::printf(
            "%-11s %6.0f m, sun %5.1f: path radiance median %.2f %%, 95 %% below %.2f %%, worst %.1f %%; transmittance "
            "worst %.4f\n",
            air, altitude, elevation, 100 * middle, 100 * most, 100 * errors.back(), worst_through);
        EXPECT_LT(middle, 0.01);
        EXPECT_LT(most, 0.05);
        EXPECT_LT(worst_through, 0.01);
      }
    }
  }
}

// Marched rays that end on the ground sphere, give or take a rounding, or are said to end beyond it, bring the air's light alone: that of the
// ground is the caller's. Rays without an end bring all there is. All are asked at once.
TEST(haze, of_marched_rays_leaves_the_ground_out) {
  constexpr double altitude = 400'000, radius = 6.371e6;
  const Direction sun = direction(0.5, 20 * deg);
  const std::pair<const char*, Parameters> models[] = {
      {"single", {}}, {"skyview", {}}, {"precomputed", {{"detail", "draft"}}}};
  for (const auto& [model, parameters] : models) {
    Atmosphere air = built_in_atmosphere("earth");
    air.planet.ground_radius = radius;
    const Sky sky(air, model, make_engine("simd"), parameters);
    std::vector<Sight> points;
    std::vector<Ray> rays;
    for (int i = 0; i < 64; ++i) {
      const Direction view = direction(0.1 * i, -(30 + 0.9 * i) * deg);
      const double along = -(radius + altitude) * view[2];
      const double ground = along - std::sqrt(along * along - altitude * (2 * radius + altitude));
      for (const double distance :
           {ground * (1 - 1e-6), ground, ground * (1 + 1e-6), 1.5 * ground, std::numeric_limits<double>::infinity()}) {
        points.push_back({view, distance});
        rays.push_back({altitude, view, sun, distance});
      }
    }
    const Haze h = haze(sky, altitude, sun, points);
    std::vector<double> path(h.inscatter.size()), whole(h.inscatter.size());
    sky.evaluate(Quantity::path_radiance, rays, wavelengths, path);
    sky.evaluate(Quantity::radiance, rays, wavelengths, whole);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool ends = std::isfinite(points[i / wavelengths.size()].distance);
      // The same kernel, lane for lane but for the place among lanes.
      EXPECT_NEAR(h.inscatter[i] / (ends ? path[i] : whole[i]), 1, 1e-5) << model << ' ' << i;
      if (!ends) {
        EXPECT_GT(whole[i], 1.03 * path[i]);
        // Between the ends that are said of one line there is no air, or a metre of eight kilometres.
        for (std::size_t said = 1; said <= 4; ++said)
          EXPECT_NEAR(h.inscatter[i - said * wavelengths.size()] / path[i], 1, 1e-3)
              << model << ' ' << i << ' ' << said;
      }
    }
  }
}

// One cell is as good as many: shadow everywhere, or nowhere.
AirShadows everywhere(float dark_below) {
  std::vector<float> edges;
  for (int i = 0; i < 4; ++i) edges.insert(edges.end(), {dark_below, dark_below + 1});
  return {
      2, 2, std::make_shared<const std::vector<float>>(edges), {1e-7, 0, 0, 0.5}, {0, 1e-7, 0, 0.5}, dark_below + 1.0,
      64};
}

TEST(haze, shadows_that_reach_nothing_change_nothing) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const Direction sun = direction(0.5, 3 * deg);
  const std::vector<Sight> points = land_sights(500, 500, 3);
  AirShadows low = everywhere(-2000);
  low.highest = 1e4;  // looked at everywhere, found nowhere
  const Haze open = haze(sky, 500, sun, points), shaded = haze(sky, 500, sun, points, &low);
  for (std::size_t i = 0; i < open.inscatter.size(); ++i) {
    ASSERT_NEAR(shaded.inscatter[i], open.inscatter[i], 1e-5 * open.inscatter[i]);
    ASSERT_EQ(shaded.transmittance[i], open.transmittance[i]);
  }
}

TEST(haze, whole_shadow_leaves_the_light_of_higher_orders) {
  const Atmosphere air = built_in_atmosphere("earth-hazy");
  const Sky sky(air, "skyview"), once(air, "single");
  const Direction sun = direction(0.5, 20 * deg);
  const std::vector<Sight> points = land_sights(500, 300, 5);
  const AirShadows all = everywhere(40000);
  const Haze open = haze(sky, 500, sun, points), shaded = haze(sky, 500, sun, points, &all),
             first = haze(once, 500, sun, points);
  std::vector<double> errors;
  for (std::size_t i = 0; i < open.inscatter.size(); ++i) {
    ASSERT_GT(shaded.inscatter[i], 0);
    // open = first order + higher orders, and the shadow takes just the first; the table's own errors remain.
    errors.push_back(std::abs((open.inscatter[i] - shaded.inscatter[i]) / first.inscatter[i] - 1));
  }
  EXPECT_LT(median(errors), 0.01);
}

// A wall of shadow to the north of a plane x = const: rays that cross it halve their light in proportion to the paths.
TEST(haze, a_shadow_over_half_of_a_ray_takes_that_half) {
  const Atmosphere air = built_in_atmosphere("earth");
  const Sky sky(air, "skyview");
  const Direction sun = direction(90 * deg, 30 * deg);
  // The map: dark beyond 10 km to the east, over 400 cells of 100 m; the edge is a cell wide.
  std::vector<float> edges;
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < 400; ++i) {
      const float edge = (i + 0.5) * 100 - 20000 > 10000 ? 4000.0f : -1000.0f;
      edges.insert(edges.end(), {edge, edge + 1});
    }
  }
  const AirShadows wall{
      400, 2, std::make_shared<const std::vector<float>>(edges), {1.0 / 40000, 0, 0, 0.5}, {0, 1e-6, 0, 0.5}, 5000, 64};
  const std::vector<Sight> near{{direction(90 * deg, 0), 10000, 0.5}}, far{{direction(90 * deg, 0), 20000, 0.5}};
  const Haze lit = haze(sky, 500, sun, near), whole = haze(sky, 500, sun, far),
             shaded = haze(sky, 500, sun, far, &wall);
  AirShadows all = everywhere(40000);
  const Haze dark = haze(sky, 500, sun, far, &all), dark_near = haze(sky, 500, sun, near, &all);
  for (std::size_t k = 0; k < 4; ++k) {
    // What is left: all higher orders, and the first order of the near half. 64 points on 20 km put the edge to 300 m: 3 %.
    const double expected = dark.inscatter[k] + (lit.inscatter[k] - dark_near.inscatter[k]);
    EXPECT_NEAR(shaded.inscatter[k], expected, 0.03 * whole.inscatter[k]);
    EXPECT_LT(shaded.inscatter[k], 0.9 * whole.inscatter[k]);
  }
}

TEST(haze, the_sky_behind_is_that_of_the_picture) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const Direction sun = direction(0.5, 8 * deg);
  std::vector<Sight> points;
  for (double e = 1; e < 90; e += 4) points.push_back({direction(e, e * deg)});
  const Haze h = haze(sky, 100, sun, points);
  std::vector<Ray> rays;
  for (const Sight& s : points) rays.push_back({100, s.view, sun});
  std::vector<double> light(points.size() * 4);
  sky.evaluate(Quantity::radiance, rays, wavelengths, light);
  for (std::size_t i = 0; i < light.size(); ++i) EXPECT_NEAR(h.inscatter[i], light[i], 0.02 * light[i]) << i / 4;
}

TEST(haze, shadows_are_for_eyes_low_in_the_air) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  EXPECT_TRUE(sky.shades_air(-400));
  EXPECT_TRUE(sky.shades_air(12'000));
  EXPECT_FALSE(sky.shades_air(400'000));
  EXPECT_FALSE(Sky(built_in_atmosphere("earth"), "single").shades_air(0));
  EXPECT_FALSE(Sky(built_in_atmosphere("earth"), "hoffman_preetham").shades_air(0));
  EXPECT_THROW(sky.shades_air(std::nan("")), InputError);
}

TEST(haze, bad_questions_are_named) {
  const Sky sky(built_in_atmosphere("earth"), "skyview"), once(built_in_atmosphere("earth"), "single");
  const Direction sun = direction(0, 0.5);
  const std::vector<Sight> good{{direction(0, 0), 1000}}, negative{{direction(0, 0), -1}},
      aside{{direction(0, 0), 1000, 1.5}};
  EXPECT_THROW(haze(sky, 2, sun, negative), InputError);
  EXPECT_THROW(haze(sky, 2, sun, aside), InputError);
  AirShadows map = everywhere(0);
  EXPECT_THROW(haze(once, 2, sun, good, &map), InputError);
  std::vector<float> edges = *map.edges;
  edges[3] = NAN;
  map.edges = std::make_shared<const std::vector<float>>(edges);
  EXPECT_THROW(haze(sky, 2, sun, good, &map), InputError);
  edges.pop_back();
  map.edges = std::make_shared<const std::vector<float>>(edges);
  EXPECT_THROW(haze(sky, 2, sun, good, &map), InputError);
  map.edges = nullptr;
  EXPECT_THROW(haze(sky, 2, sun, good, &map), InputError);
}

}  // namespace
}  // namespace airlight
