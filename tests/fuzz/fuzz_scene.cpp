// Any text either is a scene, whose numbers are finite and whose sun is somewhere, or is refused with an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "airlight/error.h"
#include "scenefile/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const airlight::Scene scene = airlight::parse_scene({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    const airlight::Camera& camera = scene.camera.camera;
    const double numbers[] = {camera.azimuth,        camera.elevation,
                              camera.roll,           camera.field_of_view,
                              scene.sun.azimuth,     scene.sun.elevation,
                              scene.detail,          scene.land.extent,
                              scene.surface.variety, scene.camera.height_above_ground};
    for (const double number : numbers) {
      if (!std::isfinite(number)) std::abort();
    }
    for (const airlight::SceneLight& light : scene.lights) {
      const double its[] = {light.place.azimuth, light.place.elevation, light.phase, light.ratio,
                            light.angular_radius.value_or(1)};
      for (const double number : its) {
        if (!std::isfinite(number)) std::abort();
      }
    }
    if (camera.width < 1 || camera.height < 1 || scene.picture.samples < 1 || !(camera.field_of_view > 0)) std::abort();
  } catch (const airlight::InputError&) {
  }
  return 0;
}
