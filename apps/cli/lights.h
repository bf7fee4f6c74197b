// The lights that a scene has beside its sun.
#pragma once
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

/// @param sun  the same air in the sun's light: gives model, its parameters and engine
std::vector<LitSky> lit_skies(const Scene& scene, const Place& origin, const Sky& sun, std::shared_ptr<Engine> engine);

/// Adds lines for a picture's metadata.
void describe(const std::vector<LitSky>& lights, Metadata& lines);

}  // namespace airlight::cli
