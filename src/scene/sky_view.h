// How much of the sky the land leaves free over each place.
#pragma once
#include <algorithm>
#include <vector>

#include "scene/land.h"

namespace airlight {

/// Sky-view factor on a square grid that lies along the sphere, axes east and north.
struct SkyViewMap {
  double first_east = 0, first_north = 0;  ///< of the first cell's centre [m]
  double spacing = 1;                      ///< [m]
  int cells = 0;                           ///< a side; rows go north, east fastest
  std::vector<float> factor;               ///< [1]

  /// Bilinear; held constant beyond the edge.
  double at(double east, double north) const;
  /// Cells to the edge; negative outside.
  double inside(double east, double north) const {
    const double x = (east - first_east) / spacing, y = (north - first_north) / spacing;
    return std::min(std::min(x, cells - 1 - x), std::min(y, cells - 1 - y));
  }
};

/// Cosine-weighted fraction, in [0, 1], of the sky that an element of the ground (tilted as it lies) sees: 1 on a
/// plain, less in valleys and on slopes. Skylight of a uniform sky on the ground is this times that on the plain.
///
/// Horizons in 16 directions, found at distances that grow geometrically (each looked up in land smoothed over a third
/// of its distance), put into Dozier & Frew 1990 (IEEE Trans. Geosci. Remote Sensing 28, 963), equation 7b.
SkyViewMap sky_view_map(const Land& land, double east, double north, double half_width, int cells);

}  // namespace airlight
