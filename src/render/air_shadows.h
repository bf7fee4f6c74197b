// From the scene's frame to the eye's: shadows in the air as `Sky::haze` takes them.
#pragma once
#include <cmath>

#include "airlight/sky.h"
#include "scene/scene_camera.h"
#include "scene/shadow_map.h"

namespace airlight {

/// What is looked at of the scene's shadow map, as the air's kernels read it, in the eye's frame.
/// @param steps  points on a view ray where shadows are looked for
AirShadows air_shadows(const ShadowMap& map, const PlacedCamera& camera, int steps);

/// Where between its points a pixel's ray looks for shadows: a low-discrepancy pattern over the picture (Roberts 2018, sequence R2)
/// and the samples of a pixel (golden ratio).
inline double shadow_offset(double x, double y, double sample) {
  const double place = 0.5 + 0.7548776662466927 * x + 0.5698402909980532 * y + 0.6180339887498949 * sample;
  return place - std::floor(place);
}

}  // namespace airlight
