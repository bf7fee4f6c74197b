// Which air lies in the mountains' shadow: for each place the altitude above which the sun is seen.
#pragma once
#include <numbers>
#include <vector>

#include "scene/land.h"

namespace airlight {

/// The square that a shadow map covers, and its finesse.
struct ShadowGrid {
  double east = 0, north = 0;  ///< its middle, straight (not along the sphere) in the scene's frame [m]
  double half_width = 40'000;  ///< [m]
  int cells = 768;             ///< along a side
  /// Cone around a direction of the scene's frame that holds all that is looked at from above the middle [rad]; what lies beside it is
  /// left lit.
  Direction axis{0, 0, 1};
  double half_angle = std::numbers::pi;
};

/// Rays to the sun are parallel, so the map lies in straight axes of the scene's frame, `along` pointing to the sun's
/// azimuth: along a view ray the map's coordinates are linear in distance. A point's altitude above the sphere is
/// compared with two values per cell; between them the sun's disc is seen in part (disc_fraction()).
struct ShadowMap {
  std::array<double, 2> along{}, across{};   ///< horizontal unit vectors (east, north)
  double first_along = 0, first_across = 0;  ///< of the first cell's centre [m]
  double spacing = 1;                        ///< [m]
  int cells = 0;                             ///< a side
  /// Altitude [m] below which no part of the sun is seen; and above which all is. Row after row of `across`, `along`
  /// fastest. `not_looked_at` where the grid's cone does not reach.
  static constexpr float not_looked_at = -1e6f;
  std::vector<float> dark, lit;

  /// Texel coordinates (0 = first cell's centre) of a point of the scene.
  std::array<double, 2> texel(const Position& p) const {
    return {(p[0] * along[0] + p[1] * along[1] - first_along) / spacing,
            (p[0] * across[0] + p[1] * across[1] - first_across) / spacing};
  }
  /// Fraction of the sun's disc seen from a point of the scene at an altitude [m]: bilinear; held constant beyond the
  /// edge.
  double visibility(const Position& p, double altitude) const;
  /// Whether a point lies below the shadow of all four cells around it, by some metres: no need to ask closer. False outside.
  bool surely_dark(const Position& p, double altitude, double margin) const;
};

/// The map for a sun, occluders between the map and the sun included as far as the land has relief, and the planet's
/// own bulge.
/// @param sun             unit, towards the centre; may be below the horizon
/// @param angular_radius  [rad]
ShadowMap shadow_map(const Land& land, const Direction& sun, double angular_radius, const ShadowGrid& grid);

/// Part of a disc above a level line at `height` (-1: below the disc, 1: above it) in disc radii.
double disc_fraction(double height);

/// Part of the sun's disc above a sphere's horizon, from an altitude [m] over it.
/// @param sun_zenith_cosine  of the sun's centre
/// @param radius             of the sphere [m]
/// @param angular_radius     of the sun [rad]
double disc_above_sphere(double sun_zenith_cosine, double altitude, double radius, double angular_radius);

}  // namespace airlight
