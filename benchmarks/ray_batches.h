// Rays to time models with.
#pragma once
#include <vector>

#include "airlight/sky.h"

namespace airlight::bench {

/// Observers up to 10 km who look anywhere, under any Sun down to 6 degrees below the horizon: neighbours have nothing in common.
std::vector<Ray> random_rays(std::size_t count);

/// The pixels of a picture, row by row: neighbours see nearly the same. From 2 m, 90 degrees wide, the horizon across its lower half.
/// @param sun  elevation [rad]
std::vector<Ray> picture_rays(int width, int height, double sun);

}  // namespace airlight::bench
