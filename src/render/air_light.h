// Lights beside the Sun. Light of two sources adds up, in the air and on the ground; what the air takes on the way is the same for both.
#pragma once
#include <span>
#include <vector>

#include "airlight/sky.h"

namespace airlight {

struct AirLight {
  const Sky* sky;                       ///< of the same air, whose sun is this light; must outlive its user
  Direction direction{0, 0, 1};         ///< unit, towards its centre
  const AirShadows* shadows = nullptr;  ///< of land, in the eye's frame; must outlive its user
};

/// Adds to what the air sends by the Sun's light what it sends by that of others, as Sky::haze answers for one.
/// @param lights     in the eye's frame
/// @param inscatter  points x wavelengths [W m^-2 sr^-1 nm^-1]
inline void add_haze(std::span<const AirLight> lights, double altitude, std::span<const Sight> points,
                     std::span<const double> wavelengths, std::span<double> inscatter) {
  if (lights.empty()) return;
  std::vector<double> more(inscatter.size()), transmittance(inscatter.size());
  for (const AirLight& light : lights) {
    light.sky->haze(altitude, light.direction, points, wavelengths, light.shadows, more, transmittance);
    for (std::size_t i = 0; i < more.size(); ++i) inscatter[i] += more[i];
  }
}

}  // namespace airlight
