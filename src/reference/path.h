// One ray through a planet's air: its ends, and what the sun's rays meet on their way to it.
#pragma once
#include <array>
#include <vector>

#include "airlight/sky.h"
#include "reference/air.h"

namespace airlight::reference {

/// @throws InputError naming the number of the ray that is out of its range.
void check(const Ray& ray, double planet_radius);

/// A point of the ray as sunlight sees it.
struct Illuminated {
  double radius;         ///< [m] from the planet's centre
  double sun_elevation;  ///< [rad] of the sun's centre above the local horizontal
  double horizon;        ///< [rad] depression of the horizon
};

/// The part of a ray that lies in the air. Points are named by t [m], the distance beyond the line's lowest point.
class Path {
 public:
  /// @throws InputError naming what is wrong with the ray
  Path(const Ray& ray, const Air& air);

  double impact;         ///< of the line [m]
  double begin, end;     ///< t of the ends; equal where the ray misses the air
  bool meets_ground;     ///< the ray's end lies on the ground
  double ground_radius;  ///< [m]
  double one_minus_cos;  ///< of the scattering angle to the sun's centre

  Illuminated at(double t) const;
  /// The observer, who may be in space.
  Illuminated observer() const { return at(observer_); }

  /// t, increasing, from begin to end, between which light depends smoothly on t: the air's landmarks, the lowest
  /// point, and where rays from the disc's upper and lower limb graze the ground (the terminator) or a jump of density.
  std::vector<double> breaks(const Air& air, double sun_radius) const;

 private:
  void add_grazing_points(double radius, double offset, std::vector<double>& breaks) const;

  Direction view_, sun_, lowest_;  // lowest_: the line's point t = 0 [m], z along the observer's vertical
  double observer_;
};

}  // namespace airlight::reference
