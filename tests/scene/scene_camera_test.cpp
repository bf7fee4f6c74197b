#include "scene/scene_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

std::shared_ptr<const Land> range() {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  return std::make_shared<Land>(settings);
}

TEST(SceneCamera, stands_above_the_ground_or_is_refused) {
  const auto land = range();
  SceneCamera scene;
  scene.spot = std::array{4000.0, 2000.0};
  scene.height_above_ground = 25;
  const double ground = land->altitude(4000, 2000);
  EXPECT_NEAR(place_camera(scene, *land).camera.altitude, ground + 25, 1e-9);
  EXPECT_NEAR(land->frame().altitude(place_camera(scene, *land).eye), ground + 25, 1e-6);
  scene.altitude = ground - 3;
  scene.key = "s.toml:7: camera.altitude";
  try {
    place_camera(scene, *land);
    ADD_FAILURE() << "a camera inside the ground";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("s.toml:7: camera.altitude = "), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find("inside the ground"), std::string::npos);
  }
}

TEST(SceneCamera, looks_at_its_target_in_its_own_frame) {
  const auto land = range();
  SceneCamera scene;
  scene.spot = std::array{50'000.0, -30'000.0};
  scene.altitude = 5000;
  scene.target = std::array{-20'000.0, 40'000.0};
  scene.target_altitude = 1000;
  const PlacedCamera placed = place_camera(scene, *land);
  const Camera& c = placed.camera;
  const Direction axis = placed.to_scene({std::cos(c.elevation) * std::sin(c.azimuth),
                                          std::cos(c.elevation) * std::cos(c.azimuth), std::sin(c.elevation)});
  const Position target = land->frame().position({-20'000, 40'000, 1000});
  double d[3], length = 0;
  for (std::size_t k = 0; k < 3; ++k) d[k] = target[k] - placed.eye[k], length += d[k] * d[k];
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(axis[k], d[k] / std::sqrt(length), 1e-12);
  // The elevation counts from the eye's own horizontal: the drop, and half the arc between the two places.
  const double arc = 98'995 / land->frame().radius();
  EXPECT_NEAR(c.elevation, -std::atan(4000.0 / 98'995) - arc / 2, 1e-4);
  const Direction back = placed.from_scene(placed.to_scene({0.1, 0.2, -0.3}));
  EXPECT_NEAR(back[0], 0.1, 1e-12);
  EXPECT_NEAR(back[2], -0.3, 1e-12);
}

TEST(SceneCamera, the_cone_holds_the_picture) {
  const auto land = range();
  SceneCamera scene;
  scene.camera = {.projection = Projection::perspective, .width = 1600, .height = 900, .field_of_view = 1.2};
  const LevelOfDetail detail = place_camera(scene, *land).detail();
  const double x = std::tan(0.6), y = x * 9 / 16;
  EXPECT_NEAR(std::cos(detail.half_angle), 1 / std::sqrt(1 + x * x + y * y), 1e-12);
  EXPECT_NEAR(detail.pixel_angle, 2 * x / 1600, 1e-12);
}

}  // namespace
}  // namespace airlight
