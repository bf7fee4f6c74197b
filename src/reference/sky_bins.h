// Directions of the sky in bins around a place: narrow towards the horizon, where twilight glows.
#pragma once
#include <array>

#include "reference/random.h"
#include "reference/vector.h"

namespace airlight::reference {

/// Cosines of zenith angles are horizon - (1 + horizon) u^2 below the horizon and horizon + (1 - horizon) u^2 above it; u
/// in 0..1 is cut at the cumulative weights of Gauss' rule, so that each bin holds one of its nodes. Azimuths are counted
/// from the sun, alike on both sides.
struct SkyBins {
  static constexpr int half = 6, zeniths = 2 * half, azimuths = 8, count = zeniths * azimuths;

  /// The node of a bin of zenith angles: its cosine, and the weight of its light in a mean over all directions.
  struct Node {
    double cosine, weight;
  };
  static Node node(int zenith, double horizon);
  static double azimuth(int bin);  ///< its middle [rad]
};

/// Light in the bins as chances: draws directions with a density in proportion to it. Sums, each bin's chance included.
using SkyChances = std::array<double, SkyBins::count>;

/// A place's own frame, to draw and to judge directions there.
class SkyAround {
 public:
  /// @param horizon  cosine of its zenith angle, for the place that the chances were made for
  SkyAround(const Vector& position, const Vector& sun, double horizon, const SkyChances& chances);

  Vector draw(Random& random) const;
  /// Density with which a direction is drawn [1/sr].
  double density(const Vector& direction) const;

 private:
  Vector up_, to_sun_, across_;
  double horizon_;
  const SkyChances& chances_;
};

}  // namespace airlight::reference
