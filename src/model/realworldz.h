// RealWorldz' planets: fog of two shells and a painted sky, as the kernels take them.
#pragma once
#include <array>
#include <numbers>

#include "model/model.h"

namespace airlight {

struct RealworldzSettings {
  double ground_radius = 60e3, bounding_radius = 63e3, outer_radius = 66e3, inner_radius = 58e3;  ///< [m]
  double clear = 0.39, clear_width = 8e3;  ///< [1], [m]: the zone around the viewer
  bool auto_clear = false;
  std::array<double, 3> far_transmittance{0.35, 0.45, 0.60}, far_light{0.35, 0.48, 0.70};
  std::array<double, 3> sun_light{1, 1, 1};
  double density = 2e-4, scale_height = 1500, top_radius = 75e3;  ///< [1/m], [m], [m]: of the sky's air
  bool painted_density = false;  ///< of the sky's air: in a table beside; otherwise exponential
};

/// The kernels' struct Realworldz.
Fields realworldz_fields(const RealworldzSettings& settings);

}  // namespace airlight
