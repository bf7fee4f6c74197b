// Real stars as a cube map (data/stars.csv).
#pragma once
#include <array>
#include <vector>

#include "airlight/camera.h"
#include "airlight/engine.h"

namespace airlight {

struct Star {
  Direction direction;  ///< x towards the vernal equinox, z towards the north celestial pole
  double magnitude;     ///< V
  double colour_index;  ///< B - V
};

/// The catalogue, brightest first.
const std::vector<Star>& star_catalogue();

/// Linear sRGB of luminance 1 of a star's colour: a black body's of the temperature that B - V stands for.
std::array<double, 3> star_colour(double colour_index);

struct StarMap {
  Shape shape;  ///< as kernels/core/cube.glsl has it
  std::vector<double> rgba;
};

/// Light per solid angle, that of a star of magnitude 0 being 1 over all [1/sr]: each star's on the four texels around it.
/// @param size  of a face [texel]
StarMap star_map(int size);

}  // namespace airlight
