// The lights beside the sun.
#pragma once
#include <span>
#include <vector>

#include "airlight/sky.h"
#include "image/picture_file.h"
#include "scenefile/scene_file.h"

namespace airlight::cli {

/// The air as one of them lights it.
struct LitSky {
  Sky sky;
  PlacedLight light;

  Direction direction() const { return airlight::direction(light.azimuth, light.elevation); }  ///< in the scene's frame
};

/// @param air  with its sun at one astronomical unit
/// @param sun  the same air in the sun's light: gives model, its parameters and engine
/// @throws InputError for a published system, which knows one light.
std::vector<LitSky> lit_skies(std::span<const SceneLight> lights, const Atmosphere& air, const Place& origin,
                              const Sky& sun, const std::shared_ptr<Engine>& engine);

/// Adds lines for a picture's metadata.
void describe(const std::vector<LitSky>& lights, Metadata& lines);

}  // namespace airlight::cli
