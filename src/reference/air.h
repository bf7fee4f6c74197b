// The air as the solvers see it: concentric shells in which every density is a polynomial, and columns along lines.
#pragma once
#include <span>
#include <vector>

#include "airlight/atmosphere.h"
#include "reference/quadrature.h"

namespace airlight::reference {

/// Half the chord that a line at the distance `impact` from the centre has in a sphere; 0 where it misses. All [m].
double half_chord(double radius, double impact);

/// Densities and columns of all constituents. A column is the integral of relative density along a line [m]: it does
/// not depend on wavelength, so one quadrature serves them all.
///
/// A line is given by its impact parameter (distance from the planet's centre) and the coordinate t along it, 0 at the
/// lowest point: radius = hypot(impact, t) cancels nowhere.
class Air {
 public:
  /// @param fineness  multiplies the number of shells to begin with and of Gauss nodes in each
  Air(const Atmosphere& atmosphere, int fineness);

  int constituents() const { return int(profiles_.size()); }
  double planet_radius() const { return planet_radius_; }   ///< of altitude 0 [m]
  double top_radius() const { return shells_.back().top; }  ///< vacuum beyond [m]

  /// Radii [m], altitude 0 and top included: all kinks, and between them steps so small that ten points notice every
  /// change. A quadrature that refines itself may start from these.
  std::span<const double> landmarks() const { return landmarks_; }
  /// Radii [m], top included, where a density jumps.
  std::span<const double> jumps() const { return jumps_; }

  /// Relative densities at a radius [m], inside the top.
  void densities(double radius, std::span<double> densities) const;

  /// Adds the columns [m] between two points of a line; parts above the top count nothing; `to` may be infinite.
  void add_columns(double impact, double from, double to, std::span<double> columns) const;

 private:
  /// Chebyshev series in z = (radius - middle) / half_thickness, a row of all constituents for each order. Trimmed to
  /// what matters: an error of the optical depth counts absolutely (T = exp(-tau)), so one tolerance serves all
  /// altitudes.
  struct Shell {
    double top, middle, half_thickness;
    std::vector<double> series;
  };

  void find_landmarks(std::span<const double> edges);
  void add_shells(double bottom, double top, std::span<const double> tolerances, int depth);
  void add_rising_columns(double impact, double from, double to, std::span<double> columns) const;
  void add_columns_inside(const Shell& shell, double impact, double from, double to, std::span<double> columns) const;

  std::vector<Profile> profiles_;
  double planet_radius_;
  std::vector<GaussRule> rules_;  // for series of order 0, 1, 2, ...
  std::vector<Shell> shells_;     // the first reaches down from altitude 0, and has its density
  std::vector<double> landmarks_, jumps_;
};

}  // namespace airlight::reference
