// Light that the ground of a picture reflects.
#pragma once
#include <span>

#include "airlight/sky.h"

namespace airlight {

/// As Sky::surface, for points under Suns of any height: an eye in space sees ground by day, in dusk and at night.
/// @param sun_zenith_cosine  at the eye
void ground_light(const Sky& sky, std::span<const SurfacePoint> points, double sun_zenith_cosine,
                  std::span<const double> wavelengths, std::span<const double> albedo, std::span<double> radiance,
                  std::span<double> skylight);

}  // namespace airlight
