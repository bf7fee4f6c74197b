#include "scene/shadow_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "raster_maker.h"
#include "scene/terrain.h"

namespace airlight {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180, radius = 0.00467;

Direction towards(double azimuth, double elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth), std::sin(elevation)};
}

TEST(ShadowMap, disc_fraction_is_the_area_of_a_segment) {
  EXPECT_EQ(disc_fraction(-1), 1);
  EXPECT_EQ(disc_fraction(2), 0);
  EXPECT_NEAR(disc_fraction(0), 0.5, 1e-15);
  EXPECT_NEAR(disc_fraction(0.3) + disc_fraction(-0.3), 1, 1e-15);
  // Archimedes could count it: 1e6 points of a square grid.
  int inside = 0, above = 0;
  for (int j = 0; j < 1000; ++j) {
    for (int i = 0; i < 1000; ++i) {
      const double x = (i + 0.5) / 500 - 1, y = (j + 0.5) / 500 - 1;
      if (x * x + y * y < 1) ++inside, above += y > 0.4;
    }
  }
  EXPECT_NEAR(disc_fraction(0.4), double(above) / inside, 1e-3);
}

TEST(ShadowMap, behind_a_wall_the_shadow_falls_with_the_sun) {
  const Folder folder;
  write_raster(folder / "wall.tif", {.width = 1600, .height = 400},
               [](double x, double, int) { return 800 * std::exp(-std::pow((x - 1400) / 20, 2)); });
  LandSettings settings;
  settings.files = {{.file = folder / "wall.tif", .cell_size = 50}};
  const Land land(settings);
  // The wall stands 30 km east. Map of 40 km: the wall is inside; of 8 km: beyond its edge.
  for (const double half_width : {40'000.0, 8'000.0}) {
    for (const double elevation : {1.0 * degree, 3.0 * degree}) {
      const ShadowMap map = shadow_map(land, towards(pi / 2, elevation), radius, {0, 0, half_width, 800});
      for (const double east : {-6000.0, 0.0, 5000.0}) {
        const auto t = map.texel({east, 0, 0});
        const std::size_t k = std::size_t(std::lround(t[1])) * 800 + std::size_t(std::lround(t[0]));
        // Up coordinate of the wall's top, then along the ray back to here, then above the sphere again.
        const double R = land.frame().radius(), top = 800 - 30'000.0 * 30'000 / (2 * R), d = 30'000 - east;
        for (const auto& [stored, angle] :
             {std::pair{map.dark[k], elevation + radius}, {map.lit[k], elevation - radius}}) {
          const double expected = std::max(0.0, top - d * std::tan(angle) + east * east / (2 * R));
          // The crest, 1 km wide, is met within half a step of 110 m: 800 (55 / 1000)^2 = 2.4 m low; a ray that grazes
          // it beside its top, where it is as steep as the ray, passes up to slope^2 width^2 / 4 height = 3 m higher.
          EXPECT_NEAR(stored, expected, 4) << half_width << ' ' << east;
        }
      }
    }
  }
}

TEST(ShadowMap, the_planet_itself_sets_the_sun) {
  const Land land(LandSettings{});
  // A sun 1 degree below the horizon: air is lit above R (1 / cos(1 degree) - 1) = 970 m.
  for (const double elevation : {-0.5 * degree, -1.0 * degree, -3.0 * degree}) {
    const ShadowMap map = shadow_map(land, towards(0.7, elevation), radius, {0, 0, 2000, 64});
    const double R = land.frame().radius();
    const auto limit = [&](double e) { return e < 0 ? R * (1 / std::cos(e) - 1) : 0.0; };
    const std::size_t k = 32 * 64 + 32;
    // Half a cell along the ray: 31 m.
    EXPECT_NEAR(map.dark[k], limit(elevation + radius), 3);
    EXPECT_NEAR(map.lit[k], limit(elevation - radius), 3);
    EXPECT_EQ(map.visibility({0, 0, 50'000}, 50'000), 1);
    EXPECT_EQ(map.visibility({0, 0, 0}, 0), elevation + radius < 0 ? 0 : map.visibility({0, 0, 0}, 0));
  }
}

TEST(ShadowMap, agrees_with_rays_among_mountains) {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = 40'000;
  const auto land = std::make_shared<Land>(settings);
  const Position middle = land->frame().position({0, 0, 3000});
  LevelOfDetail detail;
  detail.eye = middle;
  detail.pixel_angle = 0.006;
  const Terrain terrain(land, detail);
  int dark = 0;
  for (const double elevation : {2 * degree, 8 * degree, 30 * degree}) {
    const Direction sun = towards(2.1, elevation);
    const ShadowMap map = shadow_map(*land, sun, radius, {0, 0, 15'000, 600});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-12'000, 12'000), height(0, 1500);
    std::vector<SunQuestion> points;
    std::vector<double> altitudes;
    for (int i = 0; i < 4000; ++i) {
      const double east = place(random), north = place(random);
      // Points in the air have no normal that could hide the sun: theirs points to it.
      const double altitude = land->altitude(east, north) + 30 + height(random);
      points.push_back(
          {land->frame().position({east, north, altitude}), {float(sun[0]), float(sun[1]), float(sun[2])}});
      altitudes.push_back(altitude);
    }
    std::vector<float> rays(points.size());
    terrain.sun_visibility(points, sun, radius, rays);
    double error = 0, lit = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      // A hundred metres below the edge no ray comes through.
      if (map.surely_dark(points[i].position, altitudes[i], 100)) {
        ++dark;
        ASSERT_EQ(rays[i], 0) << elevation / degree << " degrees, point " << i;
      }
      const double visible = map.visibility(points[i].position, altitudes[i]);
      error += std::abs(visible - double(rays[i]));
      lit += double(rays[i]);
    }
    const double count = double(points.size());
    EXPECT_GT(lit / count, 0.02) << "the test sees both light and shade";
    EXPECT_LT(lit / count, 0.999);
    // Cells of 50 m put a shadow's edge 25 m wrong at most; where shadows are some kilometres wide and its edges blurred by tens of
    // metres that is some per cent of the points, half wrong each.
    RecordProperty("mean_error_" + std::to_string(int(elevation / degree)), std::to_string(error / count));
    EXPECT_LT(error / count, 0.02) << elevation / degree << " degrees, lit " << lit / count;
  }
  EXPECT_GT(dark, 500);
}

TEST(ShadowMap, what_is_not_looked_at_may_be_left_out) {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = 20'000;
  const Land land(settings);
  const Direction sun = towards(1.0, 3 * degree);
  const ShadowGrid whole{500, -300, 10'000, 64};
  const ShadowMap all = shadow_map(land, sun, radius, whole);
  for (const double azimuth : {0.2, 1.1, 2.6, 3.4, 5.9}) {
    ShadowGrid part = whole;
    part.axis = towards(azimuth, -0.1);
    part.half_angle = 0.4;
    const ShadowMap seen = shadow_map(land, sun, radius, part);
    std::size_t left_out = 0;
    for (std::size_t k = 0; k < seen.lit.size(); ++k) left_out += seen.lit[k] != all.lit[k];
    EXPECT_GT(left_out, seen.lit.size() / 2) << azimuth;
    // Along rays inside the cone both are the same, to the bit.
    for (const double turn : {-0.39, -0.2, 0.0, 0.3, 0.39}) {
      for (double away = 1; away < 15'000; away *= 1.2) {
        const Direction view = towards(azimuth + turn, 0);
        const Position p{whole.east + away * view[0], whole.north + away * view[1], 800};
        for (const double altitude : {300.0, 900.0, 1500.0})
          ASSERT_EQ(seen.visibility(p, altitude), all.visibility(p, altitude)) << azimuth << ' ' << turn << ' ' << away;
      }
    }
  }
}

}  // namespace
}  // namespace airlight
