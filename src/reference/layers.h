// The air as random walks see it: concentric layers in which every density is a cubic over radius squared.
#pragma once
#include <span>
#include <vector>

#include "airlight/atmosphere.h"
#include "reference/vector.h"

namespace airlight::reference {

/// A straight line through the air, cut where it crosses from layer to layer. Points are named by t [m], the distance
/// beyond the line's lowest point; radius^2 = impact^2 + t^2.
struct Line {
  double impact_squared;        ///< [m^2] of the line's distance from the planet's centre
  double start;                 ///< t of the place it was traced from
  bool meets_ground;            ///< its end lies on the ground
  std::vector<double> borders;  ///< t, from the start (or where the line enters the air) to the end; empty: no air
  std::vector<int> layers;      ///< between the borders, one less than these
  std::vector<double> columns;  ///< [m] from the start to each border, a row of all constituents for each
};

/// On a line, radius^2 is a parabola over t, so that columns are polynomials: exact, fast, and alike at all slants. The
/// densities themselves are within `precision` of a constituent's vertical column over the layer's thickness, and within
/// 2e-5 of themselves but where less than 1e-8 of the column lies.
class Layers {
 public:
  static constexpr double precision = 1e-6;

  /// @param coarseness  above 1: a rough idea of the air, as much less precise, that knows nothing of sharp edges
  explicit Layers(const Atmosphere& atmosphere, double coarseness = 1);

  /// How many neighbours a flight takes together: what the guide knows does not change from one to the next.
  std::size_t together() const { return together_; }
  int constituents() const { return constituents_; }
  int layers() const { return int(tops_.size()); }
  double planet_radius() const { return planet_radius_; }        ///< of altitude 0 [m]
  double top_radius() const { return std::sqrt(tops_.back()); }  ///< vacuum beyond [m]

  /// Follows a line from a place until it leaves the air, meets the ground or has run `distance`.
  void trace(const Vector& place, const Vector& direction, double ground_radius, double distance, Line& line) const;

  /// Relative densities at a radius squared [m^2] inside a layer.
  void densities(int layer, double radius_squared, std::span<double> densities) const;

  /// Adds the columns [m] between two points of a line inside a layer.
  void add_columns(int layer, double impact_squared, double from, double to, std::span<double> columns) const;

  /// Adds the columns [m] from a place to space. @returns false where the ground is in the way.
  bool add_columns_to_space(const Vector& place, const Vector& direction, double ground_radius,
                            std::span<double> columns) const;

 private:
  void add_layers(const Atmosphere& atmosphere, double bottom, double top, std::span<const double> tolerances,
                  double relative, int depth);
  int layer_at(double radius_squared) const;
  const double* cubic(int constituent, int power) const { return cubics_[4 * constituent + power].data(); }
  template <class Visit>
  void climb(int first, int last, double impact_squared, double from, double to, Visit visit) const;

  int constituents_;
  double planet_radius_;
  std::size_t together_;
  std::vector<double> tops_;                 // radius^2 of each layer's top; the first reaches down from altitude 0
  std::vector<double> middles_, scales_;     // x = (radius^2 - middle) * scale, -1..1 in the layer
  std::vector<std::vector<double>> cubics_;  // for each constituent four powers of x, of all layers
};

}  // namespace airlight::reference
