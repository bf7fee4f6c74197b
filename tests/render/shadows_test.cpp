// Shadows in the air against brute force: along each view ray, light of the first order from the double-precision quadrature, and
// four thousand rays towards the Sun through Embree. Higher orders are not shaded, by the models' stated approximation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "reference/single_scattering.h"
#include "render/air_shadows.h"
#include "scenes.h"

namespace airlight::test {
namespace {

const std::vector<double> wavelengths{445, 515, 565, 635};

struct Scene {
  const char* name;
  std::shared_ptr<const Land> land;
  SceneView view;
};

double percentile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, std::size_t(part * double(values.size())))];
}

// Light of the first order on the way to a distance, seen through the land's shadows.
std::vector<double> shaded_first_order(const reference::SingleScattering& solver, const Terrain& terrain,
                                       const Position& eye, const Direction& view_in_scene, Ray ray,
                                       const Direction& sun, double sun_radius) {
  constexpr int parts = 40, looks = 100;
  std::vector<double> sum(wavelengths.size()), before(wavelengths.size());
  const double whole = std::sqrt(ray.distance);
  for (int i = 0; i < parts; ++i) {
    const double begin = std::pow(whole * i / parts, 2), end = std::pow(whole * (i + 1) / parts, 2);
    std::vector<SunQuestion> points;
    for (int j = 0; j < looks; ++j) {
      const double t = begin + (end - begin) * (j + 0.5) / looks;
      points.push_back({{eye[0] + t * view_in_scene[0], eye[1] + t * view_in_scene[1], eye[2] + t * view_in_scene[2]},
                        {float(sun[0]), float(sun[1]), float(sun[2])}});
    }
    std::vector<float> seen(points.size());
    terrain.sun_visibility(points, sun, sun_radius, seen);
    double share = 0;
    for (const float s : seen) share += double(s) / looks;
    ray.distance = end;
    const std::vector<double> after = solver.along(ray, wavelengths).path_radiance;
    for (std::size_t w = 0; w < sum.size(); ++w) sum[w] += share * (after[w] - before[w]);
    before = after;
  }
  return sum;
}

TEST(shadows_in_the_air, agree_with_brute_force) {
  const std::vector<Scene> scenes = [] {
    const auto noise = mountains(), helens = land_from("mount_st_helens.tif"),
               ridges = land_from("jacksboro_fault.tif");
    return std::vector<Scene>{
        {"mountains, sun 3 degrees up ahead", noise, view_from(*noise, 0, 0, 300, 30, 2, direction(40 * deg, 3 * deg))},
        {"Mount St. Helens, sun 5 degrees up to the west", helens,
         view_from(*helens, 500, 6000, 300, 183, 4, direction(275 * deg, 5 * deg))},
        {"Jacksboro, sun 8 degrees up ahead", ridges,
         view_from(*ridges, -8000, 10000, 400, 150, 0, direction(120 * deg, 8 * deg))}};
  }();
  const Atmosphere air = built_in_atmosphere("earth");
  const Sky sky(air, "skyview");
  const reference::SingleScattering solver(air, {.tolerance = 1e-4});
  std::vector<double> all;
  for (const Scene& scene : scenes) {
    SceneOptions options;
    options.shadow_grid.half_width = 30'000;
    const Position eye = scene.view.camera.eye;
    const SceneRenderer renderer(sky, scene.land, {}, scene.view, options);
    // Triangles of its own: those of so small a picture are coarse, and coarser where hidden; on made mountains that alone is 1 %.
    const Terrain terrain(scene.land, {.eye = eye, .pixel_angle = 0.004, .unseen_pixels = 0});
    // Pixels here and there, on the ground and in the sky.
    std::mt19937 random(11);
    std::vector<double> errors;
    double shaded_part = 0;
    constexpr int rays = 24;
    for (int n = 0; n < rays; ++n) {
      const double u = double(random() % 1000) / 1000, v = double(random() % 1000) / 1000;
      const SceneRenderer::Answer got = renderer.at(u, v);
      // The eye's own frame is the scene's, turned by less than 0.1 degrees: exact for both.
      Ray ray{scene.land->frame().altitude(eye), got.view, got.sun, std::min(got.distance, 60'000.0)};
      if (got.distance > 60'000) continue;  // beyond the map
      const auto first =
          shaded_first_order(solver, terrain, eye, got.view_in_scene, ray, scene.view.sun, air.sun.angular_radius);
      std::vector<double> every(4), once(4);
      sky.evaluate(Quantity::path_radiance, std::span(&ray, 1), wavelengths, every);
      sky.evaluate(Quantity::path_radiance, std::span(&ray, 1), wavelengths, once, 1);
      for (std::size_t w = 0; w < 4; ++w) {
        const double expected = first[w] + every[w] - once[w];
        errors.push_back(std::abs(got.inscatter[w] / expected - 1));
        shaded_part += 1 - expected / every[w];
      }
    }
    ASSERT_GE(errors.size(), 40u) << scene.name;
    std::printf("%s: %zu values, shadows take %.0f %%; error median %.2f %%, 95th percentile %.1f %%, worst %.1f %%\n",
                scene.name, errors.size(), 100 * shaded_part / double(errors.size()), 100 * percentile(errors, 0.5),
                100 * percentile(errors, 0.95), 100 * percentile(errors, 1));
    // The bounds that were set for this software.
    EXPECT_LT(percentile(errors, 0.5), 0.03) << scene.name;
    EXPECT_LT(percentile(errors, 0.95), 0.10) << scene.name;
    EXPECT_GT(shaded_part / double(errors.size()), 0.005) << scene.name << ": nothing was shaded";
  }
}

// Without relief nothing is in shadow, whatever the map says.
TEST(shadows_in_the_air, of_a_plain_take_nothing) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const auto land = plain();
  const SceneView view = view_from(*land, 0, 0, 50, 30, 2, direction(40 * deg, 4 * deg));
  SceneOptions shaded, open;
  shaded.sun_disc = open.sun_disc = false;
  open.air_shadows = false;
  std::vector<float> a, b;
  const auto into = [](std::vector<float>& all) {
    return [&all](const SceneRows& rows) {
      all.insert(all.end(), rows.inscatter.begin(), rows.inscatter.end());
      return true;
    };
  };
  SceneRenderer(sky, land, {}, view, shaded).render(into(a));
  SceneRenderer(sky, land, {}, view, open).render(into(b));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-5 * std::abs(b[i])) << i;
}

TEST(AirShadows, a_part_of_the_map_says_what_the_map_says) {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = 20'000;
  const Land land(settings);
  PlacedCamera camera;
  camera.eye = land.frame().position({3000, -2000, 1500});
  camera.axes = land.frame().axes(camera.eye);
  const ShadowGrid grid{.east = camera.eye[0],
                        .north = camera.eye[1],
                        .half_width = 10'000,
                        .cells = 64,
                        .axis = {0.6, 0.8, 0},
                        .half_angle = 0.4};
  const ShadowMap map = shadow_map(land, {0.8, -0.6, 0.05}, 0.005, grid);
  const AirShadows shadows = air_shadows(map, camera, 32);
  EXPECT_LT(shadows.width * shadows.height, map.cells * map.cells / 2);
  for (const double distance : {100.0, 2000.0, 9000.0}) {
    for (const double turn : {-0.35, 0.0, 0.35}) {
      const double azimuth = std::atan2(0.6, 0.8) + turn;
      const Direction view{std::sin(azimuth), std::cos(azimuth), 0};
      const Direction scene = camera.to_scene(view);
      const auto texel = map.texel({camera.eye[0] + distance * scene[0], camera.eye[1] + distance * scene[1],
                                    camera.eye[2] + distance * scene[2]});
      const auto whole = std::size_t(std::lround(texel[1])) * 64 + std::size_t(std::lround(texel[0]));
      double x = shadows.across[3], y = shadows.along[3];
      for (std::size_t i = 0; i < 3; ++i)
        x += distance * view[i] * shadows.across[i], y += distance * view[i] * shadows.along[i];
      x = x * shadows.width - 0.5, y = y * shadows.height - 0.5;
      const auto part = std::size_t(std::lround(y)) * std::size_t(shadows.width) + std::size_t(std::lround(x));
      EXPECT_NEAR(std::remainder(x - texel[0], 1), 0, 1e-9) << distance << ' ' << turn;
      EXPECT_EQ((*shadows.edges)[2 * part], map.dark[whole]) << distance << ' ' << turn;
      EXPECT_EQ((*shadows.edges)[2 * part + 1], map.lit[whole]) << distance << ' ' << turn;
    }
  }
}

}  // namespace
}  // namespace airlight::test
