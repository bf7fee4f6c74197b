#include "scene/terrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "raster_maker.h"
#include "scene/tile_tree.h"

namespace airlight {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

Direction towards(double azimuth, double elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth), std::sin(elevation)};
}

std::shared_ptr<const Land> range(double extent = 60'000) {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = extent;
  return std::make_shared<Land>(settings);
}

LevelOfDetail coarse(const Position& eye, double pixel_angle) {
  LevelOfDetail detail;
  detail.eye = eye;
  detail.pixel_angle = pixel_angle;
  return detail;
}

TEST(Terrain, a_plain_is_the_sphere) {
  LandSettings settings;
  settings.plain_altitude = 300;
  for (const double radius : {20'000.0, 6'371'000.0}) {
    settings.planet_radius = radius;
    const auto land = std::make_shared<Land>(settings);
    for (const double height : {2.0, 1000.0, 400'000.0}) {
      const Position eye = land->frame().position({1000, -500, 300 + height});
      const Terrain terrain(land, coarse(eye, 0.001));
      std::mt19937 random(1);
      std::uniform_real_distribution<double> unit(-1, 1);
      const double dip = std::acos((radius + 300) / (radius + 300 + height));
      std::vector<SceneRay> rays;
      const auto axes = land->frame().axes(eye);
      for (int i = 0; i < 4000; ++i) {
        const Direction d =
            towards(pi * unit(random), -dip - (pi / 2 - dip) * std::pow(std::abs(unit(random)), 3) - 1e-6);
        Direction v;
        for (std::size_t k = 0; k < 3; ++k) v[k] = d[0] * axes.east[k] + d[1] * axes.north[k] + d[2] * axes.up[k];
        rays.push_back({eye, v});
      }
      std::vector<TerrainHit> hits(rays.size());
      terrain.hits(rays, hits);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(hits[i].hit()) << "a ray below the horizon misses, " << i;
        // Law of cosines from the planet's centre; chords lie at most a quarter of a pixel of the distance, or 1e-9
        // of the radius, under the arc, and floats hold 1e-7 of the coordinates.
        const double r = radius + 300, mu = rays[i].direction[0] * axes.up[0] + rays[i].direction[1] * axes.up[1] +
                                            rays[i].direction[2] * axes.up[2];
        const double q = (r + height) * mu, expected = -q - std::sqrt(std::max(0.0, q * q - height * (2 * r + height)));
        const double sag = 0.25 * 0.001 * expected + 1e-9 * radius + 1e-6 * std::min(expected, 2e5) + 0.01;
        EXPECT_NEAR(hits[i].ground.altitude, 300, sag) << expected;
        const double incidence = std::max(1e-3, -(rays[i].direction[0] * double(hits[i].normal[0]) +
                                                  rays[i].direction[1] * double(hits[i].normal[1]) +
                                                  rays[i].direction[2] * double(hits[i].normal[2])));
        EXPECT_NEAR(hits[i].distance, expected,
                    sag / incidence + std::sqrt(2 * radius * sag) * (incidence < 0.02 ? 1 : 0));
      }
      // And straight up there is nothing.
      const SceneRay up{eye, axes.up};
      TerrainHit sky;
      terrain.hits({&up, 1}, {&sky, 1});
      EXPECT_FALSE(sky.hit());
    }
  }
}

TEST(Terrain, hits_lie_on_the_land_and_normals_are_its_slope) {
  const Folder folder;
  // A plane that rises 3 in 10 to the east and falls 1 in 10 to the north.
  write_raster(folder / "plane.tif", {.width = 200, .height = 200},
               [](double x, double y, int) { return 2000 + 0.3 * 30 * (x - 100) + 0.1 * 30 * (y - 100); });
  LandSettings settings;
  settings.files = {{.file = folder / "plane.tif", .cell_size = 30}};
  const auto land = std::make_shared<Land>(settings);
  const Position eye = land->frame().position({-500, 300, 4000});
  const Terrain terrain(land, coarse(eye, 0.002));
  std::vector<SceneRay> rays;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> turn(0, 2 * pi), down(-pi / 2, -65 * degree);
  for (int i = 0; i < 2000; ++i) rays.push_back({eye, towards(turn(random), down(random))});
  std::vector<TerrainHit> hits(rays.size());
  terrain.hits(rays, hits);
  for (const TerrainHit& hit : hits) {
    ASSERT_TRUE(hit.hit());
    // On a plane triangles have no error but the pixels' own rounding of 2^-13 m, and the curve: 30^2/8R = 2e-5 m a cell.
    EXPECT_NEAR(hit.ground.altitude, 2000 + 0.3 * hit.ground.east - 0.1 * hit.ground.north, 0.01);
    const double length = std::sqrt(1 + 0.09 + 0.01);
    for (const auto& normal : {hit.normal, hit.shading_normal}) {
      // The vertical turns by distance / radius: 3e-4 over 2 km; packed normals are good to 7e-5; a float's edge of 4 m to 1e-4.
      EXPECT_NEAR(normal[0], -0.3 / length, 2e-3);
      EXPECT_NEAR(normal[1], 0.1 / length, 2e-3);
      EXPECT_NEAR(normal[2], 1 / length, 2e-3);
    }
    EXPECT_NEAR(std::acos(hit.level), std::acos(1 / length), 2e-3);
  }
}

TEST(Terrain, curvature_hides_the_foot_of_a_far_mountain) {
  const Folder folder;
  // A ridge of 500 m, 60 km east of the eye.
  write_raster(folder / "wall.tif", {.width = 1600, .height = 64},
               [](double x, double, int) { return 500 * std::exp(-std::pow((x - 1400) / 10, 2)); });
  LandSettings settings;
  settings.files = {{.file = folder / "wall.tif", .cell_size = 100}};
  const auto land = std::make_shared<Land>(settings);
  const double wall = 60'000, radius = land->frame().radius();
  const Position eye = land->frame().position({0, 0, 2});
  const Terrain terrain(land, coarse(eye, 0.0005));
  // Elevation of a point of altitude h at distance d, eye of 2 m: (h - 2)/d - d/2R. The lowest visible is the horizon's dip,
  // sqrt(2 * 2 / R) = 0.00079; the wall's top stands at 0.00829 - 0.00471 = 0.00358.
  const double top = (500 - 2) / wall - wall / (2 * radius), horizon = -std::sqrt(2 * 2 / radius);
  const auto cast = [&](double elevation) {
    const SceneRay ray{eye, towards(pi / 2, elevation)};
    TerrainHit hit;
    terrain.hits({&ray, 1}, {&hit, 1});
    return hit;
  };
  EXPECT_FALSE(cast(top + 0.0002).hit());
  const TerrainHit high = cast(top - 0.0004);
  ASSERT_TRUE(high.hit());
  EXPECT_NEAR(high.distance, wall, 1000);
  const TerrainHit low = cast(horizon + 0.0002);
  ASSERT_TRUE(low.hit());
  EXPECT_NEAR(low.distance, wall, 2000);
  // What the bulge leaves visible of the ridge begins at (d - sqrt(2 R 2))^2 / 2R: 237 m at 60 km.
  const double d = low.distance;
  EXPECT_NEAR(low.ground.altitude, d * (horizon + 0.0002) + 2 + d * d / (2 * radius), 1);
  EXPECT_GT(low.ground.altitude, 200);
}

TEST(Terrain, no_ray_below_the_horizon_misses_and_none_falls_through_a_seam) {
  const auto land = range();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double height : {2.0, 3000.0, 50'000.0}) {
    const double east = 3000, north = -7000, ground = land->altitude(east, north);
    const Position eye = land->frame().position({east, north, ground + height});
    LevelOfDetail detail = coarse(eye, 0.01);
    detail.axis = towards(0.4, -0.2);
    detail.half_angle = 0.6;  // seams between seen and unseen parts are the deepest
    const Terrain terrain(land, detail);
    const TileTree tree(*land, detail);
    const double radius = land->frame().radius(), dip = std::acos(radius / (radius + ground + height));
    const auto axes = land->frame().axes(eye);
    std::vector<SceneRay> rays;
    for (int i = 0; i < 60'000; ++i) {
      const Direction d =
          towards(pi * unit(random), -dip - 1e-5 - (pi / 2 - dip) * std::pow(std::abs(unit(random)), 4));
      Direction v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = d[0] * axes.east[k] + d[1] * axes.north[k] + d[2] * axes.up[k];
      rays.push_back({eye, v});
    }
    // Along edges of tiles: the ground there, and a metre to either side; also straight down on it, where a slit would show.
    const std::size_t from_eye = rays.size();
    for (const Tile& tile : tree.leaves()) {
      const double width = TileTree::tile_cells * tree.cell(tile.level);
      for (int k = 0; k < 12; ++k) {
        const double t = width * std::abs(unit(random)),
                     off = k % 3 == 0 ? 0 : std::copysign(0.002 + 0.01 * std::abs(unit(random)), unit(random));
        const double x = tree.metres(tile.x) + (k % 2 ? t : off), y = tree.metres(tile.y) + (k % 2 ? off : t);
        const Position above = land->frame().position({x, y, 9000});
        const Direction up = land->frame().up(above);
        rays.push_back({above, {-up[0], -up[1], -up[2]}});
      }
    }
    std::vector<TerrainHit> hits(rays.size());
    terrain.hits(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_TRUE(hits[i].hit()) << i;
      if (!hits[i].mesh) {
        // The plain takes over only where the triangles end.
        EXPECT_GE(std::max(std::abs(hits[i].ground.east), std::abs(hits[i].ground.north)),
                  tree.half_side() * (1 - 1e-9))
            << i;
      }
      EXPECT_GE(hits[i].ground.altitude, land->plain_altitude() - 1);
      const double from_border =
          tree.half_side() - std::max(std::abs(hits[i].ground.east), std::abs(hits[i].ground.north));
      if (i >= from_eye && hits[i].mesh && from_border > 1) {
        // A ray that slips through a slit ends on a flange, a fifth of a cell lower, or lower still.
        const double cell =
            tree.cell(tree.level_at(tree.lattice(hits[i].ground.east), tree.lattice(hits[i].ground.north)));
        const double expected = land->altitude(hits[i].ground.east, hits[i].ground.north, cell);
        EXPECT_NEAR(hits[i].ground.altitude, expected, 2.5 * cell + 1);
        // On the very edge the flange begins at the surface itself, and floats cannot tell which is first: 40 km from the
        // mesh's middle they are 4 mm apart.
        const auto to_edge = [&](double at) { return std::abs(std::remainder(at, cell)); };
        if (std::min(to_edge(hits[i].ground.east), to_edge(hits[i].ground.north)) < 0.004) continue;
        const double facing = hits[i].normal[0] * rays[i].direction[0] + hits[i].normal[1] * rays[i].direction[1] +
                              hits[i].normal[2] * rays[i].direction[2];
        EXPECT_LT(facing, -0.15) << "a flange was hit at " << hits[i].ground.east << ' ' << hits[i].ground.north;
      }
    }
  }
}

TEST(Terrain, rays_may_come_from_space) {
  const auto land = range(10'000);
  const double ground = land->altitude(1000, 1000, 45);
  for (const double altitude : {20'000.0, 400'000.0, 3.8e8}) {
    const Position eye = land->frame().position({1000, 1000, altitude});
    const Terrain terrain(land, coarse(eye, 30 / altitude));
    const Direction up = land->frame().up(eye);
    const SceneRay ray{eye, {-up[0], -up[1], -up[2]}};
    TerrainHit hit;
    terrain.hits({&ray, 1}, {&hit, 1});
    ASSERT_TRUE(hit.hit());
    // Cells of 45 m or less cut the corners of gullies; a float's ten-millionth of the way to the Moon would be 40 m.
    EXPECT_NEAR(hit.ground.altitude, ground, 25);
    EXPECT_NEAR(hit.distance, altitude - hit.ground.altitude, 0.01);
  }
}

TEST(Terrain, the_sun_sets_behind_a_ridge_over_its_own_width) {
  const Folder folder;
  // A ridge from south to north, 1000 m high, 10 km east.
  write_raster(folder / "ridge.tif", {.width = 1200, .height = 600},
               [](double x, double, int) { return 1000 * std::exp(-std::pow((x - 1100) / 10, 2)); });
  LandSettings settings;
  settings.files = {{.file = folder / "ridge.tif", .cell_size = 20}};
  const auto land = std::make_shared<Land>(settings);
  const Position eye = land->frame().position({0, 0, 100});
  const Terrain terrain(land, coarse(eye, 0.001));
  const SunQuestion question{land->frame().position({0, 0, land->altitude(0, 0) + 0.01}), {0, 0, 1}};
  const auto visible = [&](double elevation, double radius) {
    float fraction = -1;
    terrain.sun_visibility({&question, 1}, towards(pi / 2, elevation), radius, {&fraction, 1});
    return double(fraction);
  };
  const double ridge = std::atan2(1000 - 10'000.0 * 10'000 / 2 / land->frame().radius(), 10'000.0), radius = 0.0047;
  EXPECT_EQ(visible(ridge + 2 * radius, radius), 1);
  EXPECT_EQ(visible(ridge - 2 * radius, radius), 0);
  EXPECT_EQ(visible(ridge + 2 * radius, 0), 1);
  EXPECT_EQ(visible(ridge - 2 * radius, 0), 0);
  // Half of the disc above the crest: half its area. The crest is cut by triangles of 20 m: 1 m of 10 km, 2 % of the radius.
  EXPECT_NEAR(visible(ridge, radius), 0.5, 0.04);
  // A quarter of the diameter: 0.1955 of the area (segment of a circle).
  EXPECT_NEAR(visible(ridge - 0.5 * radius, radius), 0.1955, 0.04);
  // A slope that faces away is dark.
  const SunQuestion west{question.position, {-0.8f, 0, 0.6f}};
  float fraction = -1;
  terrain.sun_visibility({&west, 1}, towards(pi / 2, 0.3), radius, {&fraction, 1});
  EXPECT_EQ(fraction, 0);
}

// On a dome all ground that faces the sun sees it. Its triangles do not: the edge of day runs along some and past their neighbours.
TEST(Terrain, the_edge_of_day_on_a_dome_is_no_saw) {
  const Folder folder;
  write_raster(folder / "dome.tif", {.width = 240, .height = 240}, [](double x, double y, int) {
    return 1500 - (std::pow(30 * (x - 120), 2) + std::pow(30 * (y - 120), 2)) / 6000;
  });
  LandSettings settings;
  settings.files = {{.file = folder / "dome.tif", .cell_size = 30}};
  const auto land = std::make_shared<Land>(settings);
  const Position eye = land->frame().position({0, 0, 8000});
  const Terrain terrain(land, coarse(eye, 0.01));
  std::vector<SceneRay> rays;
  for (int y = -60; y <= 60; ++y)
    for (int x = -60; x <= 60; ++x) {
      const double length = std::sqrt(x * x * 1e-5 + y * y * 1e-5 + 1);
      rays.push_back({eye, {x * std::sqrt(1e-5) / length, y * std::sqrt(1e-5) / length, -1 / length}});
    }
  std::vector<TerrainHit> hits(rays.size());
  terrain.hits(rays, hits);
  const Direction sun = towards(pi / 2, 15 * degree);
  int lit = 0, dark_triangles = 0;
  for (const TerrainHit& hit : hits) {
    const auto cosine = [&](const std::array<float, 3>& n) { return n[0] * sun[0] + n[1] * sun[1] + n[2] * sun[2]; };
    if (std::hypot(hit.ground.east, hit.ground.north) > 2000 || cosine(hit.shading_normal) < 0.002) continue;
    const SunQuestion smooth = terrain.sun_question(hit);
    float visible = 0;
    terrain.sun_visibility({&smooth, 1}, sun, 0, {&visible, 1});
    EXPECT_EQ(visible, 1) << hit.ground.east << ' ' << hit.ground.north;
    ++lit;
    dark_triangles += cosine(hit.normal) <= 0;
  }
  EXPECT_GT(lit, 3000);
  EXPECT_GT(dark_triangles, 5) << "the triangles are too fine to show anything";
}

TEST(Terrain, mesh_keeps_to_its_bounds_and_to_the_pixel) {
  const auto land = range(90'000);
  const Position eye = land->frame().position({0, -20'000, 3500});
  LevelOfDetail detail = coarse(eye, 0.001);
  detail.axis = towards(0, -0.05);
  detail.half_angle = 0.4;
  detail.most_cells = 300'000;
  const Terrain small(land, detail);
  EXPECT_LE(small.statistics().cells, detail.most_cells);
  EXPECT_GT(small.statistics().pixels, detail.pixels) << "the sacrifice is stated";
  // A cell takes a vertex of 12 bytes and a normal of 4, a fifth of both again at seams, and Embree's tree: 40 bytes in all.
  EXPECT_LT(small.statistics().bytes, 45 * small.statistics().cells);
  const TileTree tree(*land, detail);
  EXPECT_GE(tree.half_side(), land->extent());
}

// Embree's coordinates of a hit, turned into the triangle they mean: its corners, weighted, are the hit.
TEST(Terrain, the_corners_of_a_triangle_weighted_are_the_hit) {
  const auto land = range();
  const Position eye = land->frame().position({0, -20'000, 4000});
  const Terrain terrain(land, coarse(eye, 0.004));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SceneRay> rays;
  for (int i = 0; i < 2000; ++i) rays.push_back({eye, towards(unit(random), -0.25 + 0.2 * unit(random))});
  std::vector<TerrainHit> hits(rays.size());
  terrain.hits(rays, hits);
  int met = 0;
  for (const TerrainHit& hit : hits) {
    if (!hit.hit() || !hit.mesh) continue;
    ++met;
    const TerrainTriangle t = terrain.triangle(hit);
    double sum = 0;
    for (const double weight : t.weights) {
      EXPECT_GE(weight, -1e-6);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    const double size = std::hypot(t.corners[1][0] - t.corners[0][0], t.corners[1][1] - t.corners[0][1]);
    for (std::size_t k = 0; k < 3; ++k) {
      double place = 0;
      for (std::size_t c = 0; c < 3; ++c) place += t.weights[c] * t.corners[c][k];
      // Embree's u and v are floats over a whole tile.
      EXPECT_NEAR(place, hit.position[k], 0.01 * size + 0.05);
    }
  }
  EXPECT_GT(met, 1000);
}

}  // namespace
}  // namespace airlight
