#include "lights.h"

#include <fmt/core.h>

#include "number.h"

namespace airlight::cli {

std::vector<LitSky> lit_skies(const Scene& scene, const Place& origin, const Sky& sun, std::shared_ptr<Engine> engine) {
  std::vector<LitSky> skies;
  for (const SceneLight& light : scene.lights) {
    const PlacedLight placed = place_light(light, scene.air.sun, origin);
    Atmosphere air = scene.air;
    air.sun = placed.source;
    skies.push_back({Sky(std::move(air), sun.model(), engine, sun.parameters()), placed});
  }
  return skies;
}

void describe(const std::vector<LitSky>& lights, Metadata& lines) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& light = lights[i].light;
    lines.push_back({fmt::format("light[{}] azimuth [degrees]", i), light.azimuth / degree});
    lines.push_back({fmt::format("light[{}] elevation [degrees]", i), light.elevation / degree});
    lines.push_back({fmt::format("light[{}] irradiance at 550 nm [W m-2 nm-1]", i), light.source.irradiance.at(550)});
  }
}

}  // namespace airlight::cli
