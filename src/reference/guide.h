// A rough, cheap estimate of the light everywhere, by which random walks find where light comes from.
#pragma once
#include <optional>
#include <vector>

#include "reference/layers.h"
#include "reference/optics.h"
#include "reference/sky_bins.h"

namespace airlight::reference {

/// Mean radiance over all directions, for the mean of all wavelengths and a sun of irradiance 1, on a grid of altitude and the sun's
/// zenith cosine: all orders, as if air scattered evenly in all directions. No answer depends on it, only errors.
class Guide {
 public:
  /// @param uniform  every place alike, in place of an estimate
  Guide(const Layers& layers, const Optics& optics, bool uniform);

  struct Light {
    double all;        ///< [1/sr] direct sunlight included
    double scattered;  ///< without it
  };
  /// @param sun_cosine  of the sun's zenith angle
  Light air(double radius_squared, double sun_cosine) const;
  /// Radiance of the ground; scattered: what skylight adds.
  Light ground(double sun_cosine) const;
  /// Directions from which light comes to a place; none where nothing is known of them.
  std::optional<SkyAround> around(const Vector& position, const Vector& sun) const;

 private:
  static constexpr int altitudes = 25, suns = 65;
  double horizon(int altitude) const;
  double radius(int altitude) const;
  void estimate(const Layers& layers, const Optics& optics);

  double planet_radius_, thickness_;
  std::vector<Light> air_, ground_;
  std::vector<SkyChances> chances_;  // on the same grid
};

}  // namespace airlight::reference
