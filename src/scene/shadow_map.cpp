#include "scene/shadow_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

/// Parallel rays keep their distance from each other: with `offset` measured upward across the sun's direction, in the vertical plane
/// that holds it, a point is in shadow if ground farther towards the sun has a greater offset. So shadow is the greatest
/// offset met on a walk from the sun's side, exact on a curved planet too.
struct SunPlane {
  double sine, cosine;  ///< of the direction's angle above the plane up = 0

  explicit SunPlane(double elevation) {
    // Straight below a sun in the zenith only the ground itself is dark; the cosine may not vanish.
    const double e = std::clamp(elevation, -1.57, 1.57);
    sine = std::sin(e), cosine = std::cos(e);
  }
  double offset(double u, double z) const { return z * cosine - u * sine; }
  /// Up coordinate [m] at u of the ray that has an offset.
  double height(double u, double offset) const { return (offset + u * sine) / cosine; }
  /// Greatest offset of a sphere's cut, a circle around (0, -centre), from u on.
  double of_planet(double u, double circle, double centre) const {
    const double highest_at = -circle * sine;
    if (u <= highest_at) return circle - centre * cosine;
    if (u >= circle) return -std::numeric_limits<double>::infinity();
    return offset(u, std::sqrt(circle * circle - u * u) - centre);
  }
};

/// Ground under a line of the scene's plane up = 0, in the map's axes.
struct Ground {
  std::vector<double> u, z;  ///< along, and up [m]

  /// @param cell  of the land, in steps of the line; the first is at `first`
  Ground(const Land& land, const ShadowMap& map, double v, const std::vector<double>& line, double cell) {
    const double radius = land.frame().radius() + land.plain_altitude();
    std::vector<std::array<double, 2>> places;
    for (const double at : line) {
      const double x = at * map.along[0] + v * map.across[0], y = at * map.along[1] + v * map.across[1];
      // Along the sphere; what lies above the plain comes to stand a little farther out, and is taken where it stands.
      const double q2 = std::min((x * x + y * y) / (radius * radius), 1.0);
      const double arc =
          q2 < 0.01 ? 1 + q2 / 6 * (1 + q2 * 9 / 20 * (1 + q2 * 25 / 42)) : std::asin(std::sqrt(q2)) / std::sqrt(q2);
      const double stretch = arc * land.frame().radius() / radius;
      places.push_back({x * stretch, y * stretch});
    }
    std::vector<double> altitudes(places.size());
    land.altitudes(places, cell, altitudes);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Position p = land.frame().position({places[i][0], places[i][1], altitudes[i]});
      u.push_back(p[0] * map.along[0] + p[1] * map.along[1]);
      z.push_back(p[2]);
    }
  }
};

/// The cells of a map that a cone from its middle may lie over: seen from above, a wedge, or everything.
class Wedge {
 public:
  Wedge(const ShadowGrid& grid, const ShadowMap& map) : cells_(grid.cells) {
    const double level = std::hypot(grid.axis[0], grid.axis[1]), sine = std::sin(grid.half_angle);
    whole_ = grid.half_angle >= std::numbers::pi / 2 || sine >= level;  // the cone holds a vertical
    if (whole_) return;
    const double cosine = std::sqrt(level * level - sine * sine);
    const auto part = [&](const std::array<double, 2>& axis) {
      return (grid.axis[0] * axis[0] + grid.axis[1] * axis[1]) / (level * level);
    };
    const double u = part(map.along), v = part(map.across);
    right_ = {u * cosine + v * sine, v * cosine - u * sine};
    left_ = {u * cosine - v * sine, v * cosine + u * sine};
  }

  /// [first, last) of a row; none: first = last.
  std::array<int, 2> columns(int row) const {
    if (whole_) return {0, cells_};
    constexpr double margin = 3;  // of interpolation
    const double middle = 0.5 * (cells_ - 1), v = row - middle;
    // To the left of its right edge, and to the right of its left one: slope * u + rest >= 0.
    double first = -middle, last = middle;
    for (const auto& [slope, rest] :
         {std::pair{-right_[1], right_[0] * v + margin}, {left_[1], margin - left_[0] * v}}) {
      if (slope > 0) first = std::max(first, -rest / slope);
      if (slope < 0) last = std::min(last, -rest / slope);
      if (slope == 0 && rest < 0) last = first - 1;
    }
    if (last < first) return {0, 0};
    return {int(std::ceil(first + middle)), int(std::floor(last + middle)) + 1};
  }

 private:
  int cells_;
  bool whole_;
  std::array<double, 2> right_{}, left_{};  ///< its edges: unit vectors in the map's axes
};

}  // namespace

double disc_fraction(double height) {
  const double h = std::clamp(height, -1.0, 1.0);
  return (std::acos(h) - h * std::sqrt(1 - h * h)) / std::numbers::pi;
}

double disc_above_sphere(double sun_zenith_cosine, double altitude, double radius, double angular_radius) {
  const double h = std::max(altitude, 0.0), dip = std::atan2(std::sqrt(h * (2 * radius + h)), radius);
  return disc_fraction(-(std::asin(std::clamp(sun_zenith_cosine, -1.0, 1.0)) + dip) / std::max(angular_radius, 1e-9));
}

ShadowMap shadow_map(const Land& land, const Direction& sun, double angular_radius, const ShadowGrid& grid) {
  if (grid.cells < 2 || !(grid.half_width > 0))
    throw InputError("a shadow map needs at least 2 x 2 cells of some width");
  ShadowMap map;
  const double flat = std::hypot(sun[0], sun[1]);
  map.along = flat > 1e-9 ? std::array{sun[0] / flat, sun[1] / flat} : std::array{0.0, 1.0};
  map.across = {-map.along[1], map.along[0]};
  map.cells = grid.cells;
  map.spacing = 2 * grid.half_width / grid.cells;
  const double inner = grid.half_width - 0.5 * map.spacing;
  map.first_along = grid.east * map.along[0] + grid.north * map.along[1] - inner;
  map.first_across = grid.east * map.across[0] + grid.north * map.across[1] - inner;
  const auto count = std::size_t(grid.cells);
  map.dark.assign(count * count, ShadowMap::not_looked_at);
  map.lit.assign(count * count, ShadowMap::not_looked_at);
  const Wedge looked_at(grid, map);

  const double elevation = std::atan2(sun[2], flat), centre = land.frame().radius();
  const SunPlane upper(elevation + angular_radius), lower(elevation - angular_radius);
  // Ground beyond what is looked at throws shadows into it from as far as a ray climbs above all summits, the planet's curve included.
  const double relief = land.highest() - std::min(land.plain_altitude(), 0.0) + 1000, slope = lower.sine / lower.cosine;
  const double reach = centre * (-slope + std::sqrt(slope * slope + 2 * relief / centre));

  tbb::parallel_for(0, grid.cells, [&](int row) {
    const auto [first, last] = looked_at.columns(row);
    if (first == last) return;
    const double v = map.first_across + row * map.spacing, edge = map.first_along + (last - 1) * map.spacing;
    const double farthest = std::max(edge, std::min(edge + reach, std::sqrt(2.0) * land.extent()));
    std::vector<double> line;
    for (double i = first;;) {
      const double u = map.first_along + i * map.spacing;
      if (u > farthest) break;
      line.push_back(u);
      // A ridge's shadow is as soft as its distance times the sun's width: far ground may be coarse.
      i += std::max(1.0, std::floor(0.005 * (i - last)));
    }
    const Ground ground(land, map, v, line, 0.5 * map.spacing);
    const double sphere = centre + land.plain_altitude();
    const double circle = std::sqrt(std::max(sphere * sphere - v * v, 0.0));
    double dark = upper.of_planet(farthest, circle, centre), lit = lower.of_planet(farthest, circle, centre);
    for (std::size_t i = line.size(); i-- > 0;) {
      dark = std::max(dark, upper.offset(ground.u[i], ground.z[i]));
      lit = std::max(lit, lower.offset(ground.u[i], ground.z[i]));
      if (i >= std::size_t(last - first)) continue;
      const double u = line[i], x = u * map.along[0] + v * map.across[0], y = u * map.along[1] + v * map.across[1];
      const std::size_t k = std::size_t(row) * count + std::size_t(first) + i;
      map.dark[k] = float(land.frame().altitude({x, y, upper.height(u, dark)}));
      map.lit[k] = float(land.frame().altitude({x, y, lower.height(u, lit)}));
    }
  });
  return map;
}

double ShadowMap::visibility(const Position& p, double altitude) const {
  const auto t = texel(p);
  const double x = std::clamp(t[0], 0.0, cells - 1.0), y = std::clamp(t[1], 0.0, cells - 1.0);
  const int i = std::min(int(x), cells - 2), j = std::min(int(y), cells - 2);
  const double fx = x - i, fy = y - j;
  const std::size_t k = std::size_t(j) * std::size_t(cells) + std::size_t(i), below = k + std::size_t(cells);
  const auto mix = [&](const std::vector<float>& f) {
    return (f[k] * (1 - fx) + f[k + 1] * fx) * (1 - fy) + (f[below] * (1 - fx) + f[below + 1] * fx) * fy;
  };
  const double low = mix(dark), high = mix(lit);
  if (altitude >= high) return 1;
  if (altitude <= low) return 0;
  return disc_fraction(1 - 2 * (altitude - low) / (high - low));
}

bool ShadowMap::surely_dark(const Position& p, double altitude, double margin) const {
  const auto t = texel(p);
  if (!(t[0] >= 0 && t[0] < cells - 1 && t[1] >= 0 && t[1] < cells - 1)) return false;
  const float* d = &dark[std::size_t(t[1]) * std::size_t(cells) + std::size_t(t[0])];
  return altitude + margin < double(std::min(std::min(d[0], d[1]), std::min(d[cells], d[cells + 1])));
}

}  // namespace airlight
