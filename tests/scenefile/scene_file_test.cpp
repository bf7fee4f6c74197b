#include "scenefile/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(SceneFile, keys_arrive_in_SI_and_radians) {
  const Scene scene = parse_scene(R"(
place = "46.5,7.5"
air = { base = "earth", aerosol_optical_depth = 0.3 }
[camera]
type = "fisheye"
width = 300
place = "46.6,7.6"
altitude = 1234
azimuth = 90
elevation = 45
roll = -10
field_of_view = 200
[sun]
time = "2026-06-21T18:40Z"
refraction = true
[[terrain]]
file = "coarse.tif"
[[terrain]]
file = "/data/fine.tif"
band = 2
height_scale = 0.3048
height_offset = -5
cell_size = 10
blend = 200
[relief]
seed = 7
height = 900
wavelength = 5000
ruggedness = 0.2
[land]
extent = 60_000
detail = 2
[surface]
image = "photo.jpg"
image_linear = true
rock = [0.1, 0.2, 0.3]
steepest_grass = 30
[picture]
samples = 9
exposure = -12.5
tone = "reinhard"
air_shadows = false
)",
                                  "folder/a_scene.toml");
  EXPECT_EQ(scene.name, "a_scene");
  EXPECT_EQ(scene.air, with_overrides(built_in_atmosphere("earth"), {.aerosol_optical_depth = 0.3}));
  EXPECT_EQ(scene.land.planet_radius, scene.air.planet.ground_radius);
  ASSERT_TRUE(scene.land.origin);
  EXPECT_NEAR(scene.land.origin->latitude, 46.5 * degree, 1e-12);
  const Camera& camera = scene.camera.camera;
  EXPECT_EQ(camera.projection, Projection::fisheye);
  EXPECT_EQ(camera.width, 300);
  EXPECT_EQ(camera.height, 300) << "a circle's picture is square unless said otherwise";
  EXPECT_NEAR(camera.azimuth, 90 * degree, 1e-12);
  EXPECT_NEAR(camera.elevation, 45 * degree, 1e-12);
  EXPECT_NEAR(camera.roll, -10 * degree, 1e-12);
  EXPECT_NEAR(camera.field_of_view, 200 * degree, 1e-12);
  EXPECT_EQ(scene.camera.altitude, 1234);
  EXPECT_NEAR(std::get<Place>(scene.camera.spot).longitude, 7.6 * degree, 1e-12);
  EXPECT_EQ(scene.camera.key, "folder/a_scene.toml:8: camera.altitude");
  ASSERT_TRUE(scene.sun.time);
  EXPECT_EQ(format_time(*scene.sun.time), "2026-06-21T18:40:00Z");
  EXPECT_TRUE(scene.sun.refraction);
  ASSERT_EQ(scene.land.files.size(), 2u);
  EXPECT_EQ(scene.land.files[0].file, "folder/coarse.tif") << "files lie beside the scene";
  EXPECT_EQ(scene.land.files[1].file, "/data/fine.tif");
  EXPECT_EQ(scene.land.files[1].band, 2);
  EXPECT_EQ(scene.land.files[1].height_scale, 0.3048);
  EXPECT_EQ(scene.land.files[1].height_offset, -5);
  EXPECT_EQ(scene.land.files[1].cell_size, 10);
  EXPECT_EQ(scene.land.files[1].blend, 200);
  ASSERT_TRUE(scene.land.relief);
  EXPECT_EQ(scene.land.relief->seed, 7u);
  EXPECT_EQ(scene.land.relief->wavelength, 5000);
  EXPECT_EQ(scene.land.extent, 60'000);
  EXPECT_TRUE(scene.has_land);
  EXPECT_EQ(scene.detail, 2);
  EXPECT_EQ(scene.surface.image, "folder/photo.jpg");
  EXPECT_TRUE(scene.surface.image_linear);
  EXPECT_EQ(scene.surface.rock[2], 0.3);
  EXPECT_NEAR(scene.surface.steepest_grass, 30 * degree, 1e-12);
  EXPECT_EQ(scene.picture.samples, 9);
  EXPECT_EQ(scene.picture.exposure_ev, -12.5);
  EXPECT_EQ(scene.picture.tone, "reinhard");
  EXPECT_EQ(scene.picture.air_shadows, false);
}

TEST(SceneFile, least_that_is_a_scene) {
  const Scene scene = parse_scene("[camera]\n[sun]\nelevation = 10\n", "s.toml");
  EXPECT_EQ(scene.air, built_in_atmosphere("earth"));
  EXPECT_EQ(scene.camera.camera.projection, Projection::perspective);
  EXPECT_FALSE(scene.picture.air_shadows.has_value());
  EXPECT_EQ(scene.camera.height_above_ground, 2);
  EXPECT_FALSE(scene.has_land);
  EXPECT_FALSE(scene.picture.exposure_ev);
}

TEST(SceneFile, shipped_scenes_are_read) {
  int with_land = 0;  // the published systems' skies have none
  for (const auto& entry : std::filesystem::directory_iterator(AIRLIGHT_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const Scene scene = load_scene(entry.path().string());
    with_land += scene.has_land;
    for (const ElevationFile& file : scene.land.files) EXPECT_TRUE(std::filesystem::exists(file.file)) << file.file;
  }
  EXPECT_GE(with_land, 4);
}

TEST(Scene, has_lights_beside_its_sun) {
  const Scene scene = parse_scene(R"(
[camera]
[sun]
time = "2026-06-21T18:40Z"
place = "46.5,7.5"
[[light]]
elevation = 20
azimuth = 200
ratio = 0.25
angular_radius = 1
[[light]]
body = "moon"
[[light]]
body = "moon"
elevation = 40
phase = 90
irradiance = 1e-6
)",
                                  "s.toml");
  ASSERT_EQ(scene.lights.size(), 3u);
  const SceneLight &second = scene.lights[0], &moon = scene.lights[1], &fixed = scene.lights[2];
  EXPECT_FALSE(second.moon);
  EXPECT_NEAR(second.place.azimuth, 200 * degree, 1e-12);
  const Place origin{46 * degree, 8 * degree};
  const PlacedLight placed = place_light(second, scene.air.sun, origin);
  EXPECT_NEAR(placed.elevation, 20 * degree, 1e-12);
  EXPECT_NEAR(placed.source.irradiance.at(550) / scene.air.sun.irradiance.at(550), 0.25, 1e-12);
  EXPECT_NEAR(placed.source.angular_radius, 1 * degree, 1e-12);
  EXPECT_TRUE(moon.moon);
  ASSERT_TRUE(moon.place.time);
  EXPECT_EQ(format_time(*moon.place.time), "2026-06-21T18:40:00Z") << "of the sun, where it says none of its own";
  ASSERT_TRUE(moon.place.place);
  EXPECT_NEAR(moon.place.place->longitude, 7.5 * degree, 1e-12);
  EXPECT_NEAR(fixed.phase, 90 * degree, 1e-12);
  EXPECT_EQ(place_light(fixed, scene.air.sun, origin).source.irradiance.at(700), 1e-6);
  EXPECT_NEAR(place_light(fixed, scene.air.sun, origin).source.angular_radius, 0.00452, 1e-5);
}

}  // namespace
}  // namespace airlight
