#include "lights.h"

#include <fmt/core.h>

#include "airlight/error.h"
#include "airlight/model_info.h"
#include "number.h"

namespace airlight::cli {

std::vector<LitSky> lit_skies(std::span<const SceneLight> lights, const Atmosphere& air, const Place& origin,
                              const Sky& sun, const std::shared_ptr<Engine>& engine) {
  if (!lights.empty() && model_info(sun.model()).colours)
    throw InputError(fmt::format("model {}: knows one light, its sun; expected no light beside it", sun.model()));
  std::vector<LitSky> skies;
  for (const SceneLight& light : lights) {
    const PlacedLight placed = place_light(light, air.sun, origin);
    Atmosphere lit = air;
    lit.sun = placed.source;
    skies.push_back({Sky(std::move(lit), sun.model(), engine, sun.parameters()), placed});
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
