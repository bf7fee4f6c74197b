// Air of any shape: a density given as a function or on a grid, walked through by null collisions.
#pragma once
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "airlight/atmosphere.h"
#include "reference/random.h"
#include "reference/vector.h"

namespace airlight::reference {

/// A box with sides along the axes. Like all places here [m] from the planet's centre, z the vertical at the scene's
/// origin, where an observer of a Ray stands.
struct Box {
  Vector low, high;
  /// Distances [m] along a line between which it runs inside; begin >= end: nowhere. Nothing behind the place counts.
  std::pair<double, double> inside(const Place& from) const;
};

/// Droplets, smoke: beside the air, and lit like it. Extinction is grey, as droplets' is, which are larger than light's
/// waves; what is absorbed of it may depend on wavelength.
struct Cloud {
  Box box;                                       ///< nothing outside
  std::function<double(const Vector&)> density;  ///< relative, in [0, 1], at a place in the box; thread-safe
  double extinction = 0;                         ///< [1/m] where the density is 1
  Spectrum single_scattering_albedo = 1;
  Phase phase = HenyeyGreensteinPhase{0.85};
};

/// @throws InputError naming key, value and legal range
void validate(const Cloud& cloud);

/// Densities on the corners of equal cells, linear in between; a function for Cloud::density.
class DensityGrid {
 public:
  /// @param counts  corners along each axis, at least 2
  /// @param values  in [0, 1], x fastest. @throws InputError
  DensityGrid(const Box& box, std::array<int, 3> counts, std::vector<double> values);
  double operator()(const Vector& place) const;

 private:
  Box box_;
  std::array<int, 3> counts_;
  std::vector<double> values_;
};

/// Distance [m] to the next collision with a cloud, drawn with the density extinction * transmittance; infinite: none
/// before `to` [m]. Delta tracking: places are drawn as if density were 1 everywhere, and kept with a chance equal to
/// the density (Woodcock et al. 1965).
double draw_collision(const Cloud& cloud, const Place& from, double to, Random& random);

/// A random number whose mean is the cloud's transmittance up to the distance `to` [m]: ratio tracking, the product of
/// 1 - density over such places (Cramer 1978; Novak, Selle & Jarosz 2014, ACM Trans. Graph. 33, 179).
/// @throws WorkError where a density is not in [0, 1]
double draw_transmittance(const Cloud& cloud, const Place& from, double to, Random& random);

}  // namespace airlight::reference
