// Solid things in the way of random walks: land, buildings.
#pragma once
#include <optional>
#include <span>

#include "reference/vector.h"

namespace airlight::reference {

/// A Lambertian surface inside the air, above the planet's sphere, which stays where it is. Places [m] are counted from
/// the planet's centre; z is the vertical at the scene's origin, where an observer of a Ray stands. const use is
/// thread-safe.
class Surface {
 public:
  virtual ~Surface() = default;

  struct Hit {
    double distance;  ///< [m]
    Vector position;  ///< just off the surface: lines from here do not meet the same spot again
    Vector normal;    ///< unit, on the side that was met
  };
  /// The nearest point that a line meets, none beyond `farthest` [m], which may be infinite.
  virtual std::optional<Hit> hit(const Place& from, double farthest) const = 0;
  /// Whether a line meets anything; for light from the sun.
  virtual bool hides(const Place& from) const = 0;
  /// Share of light that the surface throws back at a place where it was met, in [0, 1].
  /// @param albedo  one value for each of the walks' wavelengths
  virtual void albedo(const Vector& position, std::span<double> albedo) const = 0;
};

}  // namespace airlight::reference
