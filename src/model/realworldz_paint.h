// Tools for the painter of a sky table: which texel colours a piece of sky, tables from pictures, whole-table adjustments.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "airlight/camera.h"
#include "model/realworldz_table.h"

namespace airlight {

/// The sky that a table is looked up with: how thick its air is in a direction.
struct SkyGeometry {
  Direction sun{0, 0, 1};                                 ///< unit, in the viewer's frame (east, north, up)
  std::function<double(double elevation)> optical_depth;  ///< of the air in a direction [rad]
};

/// The same as pictures have it: the air's transmittance on rings of equal elevation, linear in between.
/// @param rings  at the elevations of kernels/realworldz/sky.glsl: 90 degrees times w |w|, w from -1 to 1 in equal steps
SkyGeometry ring_geometry(const Direction& sun, std::vector<double> rings);

/// Where in a painted table the colour of a direction is.
struct TablePlace {
  double x, y;  ///< angle from the Sun / 180 degrees; exp(-optical depth): both 0..1
};
TablePlace place_of(const SkyGeometry& sky, const Direction& view);

/// The table's colour at a place, bilinear.
std::array<double, 4> colour_at(const SkyTable& painted, const TablePlace& place);

/// Where in a picture a cell of the table is seen: 1 at pixels whose colour is mixed from that texel, 0 elsewhere; rows of pixels.
std::vector<float> highlight(const SkyTable& painted, int column, int row, const SkyGeometry& sky,
                             const Camera& camera);

/// Builds a painted table from a picture of a sky: each pixel's colour goes to the texels around its place, then what no pixel
/// showed is filled smoothly. Alpha is that of the starter, and colours are multiplied by it.
/// @param rgb    linear, rows of pixels of the camera's size
/// @param known  pixels to take (the sky, not the ground); empty: all
struct Projected {
  SkyTable table;
  std::vector<bool> covered;  ///< which texels pixels were seen at, column fastest
};
Projected back_projected(std::span<const float> rgb, const Camera& camera, const SkyGeometry& sky, int width = 256,
                         int height = 256, const std::function<bool(const Direction&)>& known = {});

/// The largest difference of neighbouring colours, per texel: any sharp edge becomes a visible line in the sky.
std::vector<double> discontinuities(const SkyTable& painted);

struct Adjustment {
  double redden = 0;    ///< -1 .. 1: red up and blue down
  double lighten = 1;   ///< factor
  double contrast = 1;  ///< power about the table's mean luminance
  double hue = 0;       ///< [rad] turn about the grey axis
};
void adjust(SkyTable& painted, const Adjustment& adjustment);

}  // namespace airlight
