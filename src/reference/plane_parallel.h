// Air without curvature: homogeneous layers over a Lambertian ground. Only optical depths matter, heights do not.
#pragma once
#include <vector>

#include "airlight/atmosphere.h"

namespace airlight::reference {

/// What scatters in a layer with one phase function.
struct Scatterer {
  double optical_depth = 0;  ///< vertical, of scattering
  Phase phase;
};

struct Layer {
  std::vector<Scatterer> scatterers;    ///< a mixture
  double absorption_optical_depth = 0;  ///< vertical
};

struct PlaneParallelAir {
  std::vector<Layer> layers;  ///< from the top down
  double surface_albedo = 0;  ///< Lambertian, in [0, 1]
};

/// @throws InputError naming key, value and legal range ("layers[1].scatterers[0].phase.g")
void validate(const PlaneParallelAir& air);

/// Deepest layer that may be asked for, in vertical optical depth.
inline constexpr double deepest_layer = 1e6;

}  // namespace airlight::reference
