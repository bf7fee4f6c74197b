// The air as the solvers see it: concentric shells between which every density is smooth, and columns along lines.
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
  /// @param nodes  Gauss nodes between two shells; shells are added until that many give columns to 1e-11 of the
  /// vertical
  ///               one, for lines that cross the shells and for lines that graze them
  Air(const Atmosphere& atmosphere, int nodes);

  int constituents() const { return int(profiles_.size()); }
  double planet_radius() const { return planet_radius_; }     ///< of altitude 0 [m]
  double top_radius() const { return shells_.back(); }        ///< vacuum beyond [m]
  std::span<const double> shells() const { return shells_; }  ///< radii [m], altitude 0 first
  std::span<const double> kinks() const { return kinks_; }    ///< the shells [m] where a density or its slope jumps

  /// Relative densities at a radius [m], inside the top.
  void densities(double radius, std::span<double> densities) const;

  /// Adds the columns [m] between two points of a line; parts above the top count nothing; `to` may be infinite.
  void add_columns(double impact, double from, double to, std::span<double> columns) const;

 private:
  void add_rising_columns(double impact, double from, double to, std::span<double> columns) const;
  void add_smooth_columns(double impact, double from, double to, std::span<double> columns) const;
  void add_shells(double bottom, double top, std::span<const double> tolerances, int depth);

  std::vector<Profile> profiles_;
  double planet_radius_;
  GaussRule rule_;
  std::vector<double> kinks_, shells_;
};

}  // namespace airlight::reference
