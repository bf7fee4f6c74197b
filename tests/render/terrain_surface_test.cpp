// Land under random walks.
#include "render/terrain_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "airlight/error.h"
#include "reference/monte_carlo.h"
#include "scenes.h"

namespace airlight::test {
namespace {

using reference::MonteCarlo;
using reference::Place;
using reference::Vector;

/// Passed by chance in 1 of 1e5 comparisons.
constexpr double far = 4.5;
constexpr double endless = std::numeric_limits<double>::infinity();

std::shared_ptr<const Terrain> terrain_of(std::shared_ptr<const Land> land, double eye_altitude) {
  return std::make_shared<const Terrain>(std::move(land), LevelOfDetail{.eye = {0, 0, eye_altitude}});
}

Atmosphere air(double ground_radius, double raised, double albedo) {
  const double height = 8e3, lift = std::exp(raised / height);
  Atmosphere atmosphere;
  atmosphere.planet = {.ground_radius = ground_radius, .top_altitude = 80e3 + raised, .albedo = albedo};
  atmosphere.sun.irradiance = 1;
  atmosphere.constituents.push_back({"air", ExponentialProfile{height}, 3e-5 * lift, 2e-6 * lift, RayleighPhase{0.03}});
  return atmosphere;
}

// A plain 800 m above black ground is the ground of a planet 800 m larger.
TEST(TerrainSurface, a_plain_is_a_planets_ground) {
  LandSettings settings;
  settings.extent = 10'000;
  settings.plain_altitude = 800;
  const auto land = std::make_shared<const Land>(settings);
  const double wavelength = 550, radius = land->frame().radius();
  const MonteCarlo expected(air(radius + 800, 0, 0.6), {&wavelength, 1}, {.seed = 1, .random_first_order = true});
  const MonteCarlo solver(
      air(radius, 800, 0.0), {&wavelength, 1},
      {.seed = 2, .surface = std::make_shared<TerrainSurface>(terrain_of(land, 802), std::vector{0.6})});
  for (const double elevation : {30.0, -40.0, 4.0}) {
    Ray ray{.altitude = 20, .view = direction(0.5, elevation * deg), .sun = direction(0, 35 * deg)};
    const auto a = expected.radiance(ray, {.walks = 4096});
    ray.altitude += 800;
    const auto b = solver.radiance(ray, {.walks = 4096});
    const double error = std::hypot(a.total.standard_error[0], b.total.standard_error[0]);
    EXPECT_NEAR(a.total.mean[0], b.total.mean[0], far * error) << elevation;
    EXPECT_LT(error, 0.05 * a.total.mean[0]);
  }
}

// What a line meets, against steps of 10 m over the land's heights; lines that pass within a few metres, or through what is
// coarser than these steps, are left out.
TEST(TerrainSurface, lines_meet_mountains_where_steps_over_the_land_do) {
  const auto land = mountains();
  const double eye = land->altitude(0, 0) + 50, radius = land->frame().radius();
  const TerrainSurface surface(terrain_of(land, eye), {0.5});
  std::mt19937 random(5);
  const auto between = [&](double low, double high) { return low + (high - low) * double(random()) * 0x1p-32; };
  int compared = 0, hidden = 0;
  for (int i = 0; i < 300; ++i) {
    const Position start{between(-500, 500), between(-500, 500), eye + between(20, 300)};
    const Direction towards = direction(between(0, 6.28), between(-25, 25) * deg);
    const auto height = [&](double t) {
      const Position p{start[0] + t * towards[0], start[1] + t * towards[1], start[2] + t * towards[2]};
      const GroundPoint g = land->frame().ground(p);
      return g.altitude - land->altitude(g.east, g.north);
    };
    // Triangles near the eye are some metres long, and coarser further away.
    constexpr double reach = 4000, step = 10, unsure = 15;
    double met = endless, lowest = endless;
    for (double t = 0; t < reach && std::isinf(met); t += step) {
      const double clear = height(t);
      if (clear < 0) met = t;
      if (clear >= 0) lowest = std::min(lowest, clear);
    }
    if (height(0) < unsure || (std::isinf(met) && lowest < unsure)) continue;
    const Place from{{start[0], start[1], start[2] + radius}, towards};
    const auto hit = surface.hit(from, reach);
    ++compared;
    if (std::isinf(met)) {
      EXPECT_FALSE(hit.has_value()) << i;
      continue;
    }
    ++hidden;
    ASSERT_TRUE(hit.has_value()) << i;
    EXPECT_TRUE(surface.hides(from)) << i;
    // The line comes down at a slope of a few degrees or more: 15 m of height are so many along it.
    EXPECT_NEAR(hit->distance, met, 250) << i;
    EXPECT_LT(reference::dot(hit->normal, towards), 0) << i;
    EXPECT_FALSE(surface.hit({hit->position, hit->normal}, 5.0)) << "lifted off its own triangle, " << i;
  }
  EXPECT_GT(compared, 150);
  EXPECT_GT(hidden, 50);
}

// Between white mountains, in air that absorbs nothing, under even light: radiance 1 everywhere, in each valley.
TEST(TerrainSurface, furnace) {
  const auto land = mountains();
  const double eye = land->altitude(0, 0) + 5, wavelength = 550;
  Atmosphere conservative = air(land->frame().radius(), 0, 1.0);
  conservative.constituents[0].absorption = 0.0;
  const MonteCarlo solver(
      conservative, {&wavelength, 1},
      {.uniform_light = true, .surface = std::make_shared<TerrainSurface>(terrain_of(land, eye), std::vector{1.0})});
  for (const double elevation : {-30.0, 2.0, 30.0}) {
    const auto light = solver.radiance({.altitude = eye, .view = direction(1, elevation * deg)}, {.walks = 1024});
    EXPECT_NEAR(light.total.mean[0], 1, far * light.total.standard_error[0] + 1e-9) << elevation;
    EXPECT_LT(light.total.standard_error[0], 0.05);
  }
}

TEST(TerrainSurface, names_what_is_wrong) { EXPECT_THROW(TerrainSurface(terrain_of(plain(), 2), {1.5}), InputError); }

}  // namespace
}  // namespace airlight::test
