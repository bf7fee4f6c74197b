// Land for tests: mountains from noise, and the two real files.
#pragma once
#include <memory>
#include <numbers>

#include "render/scene_renderer.h"

namespace airlight::test {

inline constexpr double deg = std::numbers::pi / 180;

inline std::shared_ptr<const Land> mountains() {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = 60'000;
  return std::make_shared<const Land>(settings);
}
inline std::shared_ptr<const Land> plain() {
  LandSettings settings;
  settings.extent = 10'000;
  return std::make_shared<const Land>(settings);
}
inline std::shared_ptr<const Land> land_from(const char* file) {
  LandSettings settings;
  settings.files = {{.file = std::string(AIRLIGHT_DATA) + "/terrain/" + file}};
  return std::make_shared<const Land>(settings);
}

/// An eye so far above the ground, and a lens of 60 degrees.
inline SceneView view_from(const Land& land, double east, double north, double height, double azimuth, double elevation,
                           Direction sun) {
  SceneCamera camera;
  camera.camera = {.projection = Projection::perspective,
                   .width = 48,
                   .height = 27,
                   .azimuth = azimuth * deg,
                   .elevation = elevation * deg,
                   .field_of_view = 60 * deg};
  camera.spot = std::array{east, north};
  camera.height_above_ground = height;
  return {place_camera(camera, land), sun};
}

}  // namespace airlight::test
