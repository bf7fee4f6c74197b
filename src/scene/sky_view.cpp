#include "scene/sky_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "every_processor.h"

namespace airlight {
namespace {

using std::numbers::pi;
constexpr int directions = 16;

/// Heights around the map, at one smoothness: rows that far apart, but in each a height for each column of the map, and for as many
/// columns beyond its edges as are looked at. So a place seen from all of a row's places is a shifted row.
struct Level {
  double first_north, spacing;  ///< of its rows [m]
  int rows, columns, before;    ///< columns, of which as many lie west of the map
  std::vector<float> altitude;  ///< [m] rows go north

  const float* row(int j) const { return &altitude[std::size_t(j) * std::size_t(columns)]; }
};

/// Lifts the tangents of the horizons of places in a row to what stands at the same distance from each.
/// @param lower, upper        altitudes there, in the rows to both sides; the place lies between these columns and the next ones
/// @param across, up          0 .. 1, where between columns and rows
/// @param sunk                by the planet's curve [m]
AIRLIGHT_EVERY_PROCESSOR
void raise_horizon(const float* lower, const float* upper, float across, float up, const float* here, float sunk,
                   float per_metre, int count, float* horizon) {
  for (int i = 0; i < count; ++i) {
    const float west = lower[i] + (upper[i] - lower[i]) * up, east = lower[i + 1] + (upper[i + 1] - lower[i + 1]) * up;
    const float there = west + (east - west) * across;
    horizon[i] = std::max(horizon[i], (there - here[i] - sunk) * per_metre);
  }
}

/// @param fold   its rows' distance in cells of the map
/// @param reach  how many rows to each side of the map are looked at, of this distance
Level sample(const Land& land, const SkyViewMap& map, int fold, int reach) {
  const int beyond = reach + 1;  // one more to interpolate with
  const int rows = 2 * beyond + (map.cells + fold - 2) / fold + 1;
  const double spacing = fold * map.spacing;
  Level level{map.first_north - beyond * spacing, spacing, rows, (rows - 1) * fold + 1, beyond * fold, {}};
  level.altitude.resize(std::size_t(rows) * std::size_t(level.columns));
  tbb::parallel_for(0, rows, [&](int j) {
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < rows; ++i)
      places.push_back({map.first_east + (i - beyond) * spacing, level.first_north + j * spacing});
    std::vector<double> altitudes(places.size());
    land.altitudes(places, spacing, altitudes);
    float* out = &level.altitude[std::size_t(j) * std::size_t(level.columns)];
    for (int i = 0; i + 1 < rows; ++i)
      for (int k = 0; k < fold; ++k)
        *out++ = float(altitudes[std::size_t(i)] +
                       (altitudes[std::size_t(i) + 1] - altitudes[std::size_t(i)]) * (double(k) / fold));
    *out = float(altitudes.back());
  });
  return level;
}

}  // namespace

SkyViewMap sky_view_map(const Land& land, double east, double north, double half_width, int cells) {
  if (cells < 2 || !(half_width > 0)) throw InputError("a sky-view map needs at least 2 x 2 cells of some width");
  SkyViewMap map{0, 0, 2 * half_width / cells, cells, {}};
  map.first_east = east - half_width + 0.5 * map.spacing;
  map.first_north = north - half_width + 0.5 * map.spacing;
  // Land at the map's own spacing; and at each doubling of it, on grids that reach farther. Each is looked at from 3 to 6 of its rows
  // away; the first also nearer, the last also farther.
  std::vector<int> folds{1};
  for (int fold = 2; fold * map.spacing < 0.25 * land.extent() && fold < 64; fold *= 2) folds.push_back(fold);
  std::vector<Level> levels;
  for (const int fold : folds) levels.push_back(sample(land, map, fold, fold == folds.back() ? 12 : 6));
  map.factor.assign(std::size_t(cells) * std::size_t(cells), 1);
  // A plain hides nothing of the sky: no need to look around from each of its places.
  const float first = levels[0].altitude[0];
  if (std::ranges::all_of(levels, [&](const Level& level) {
        return std::ranges::all_of(level.altitude, [&](float altitude) { return altitude == first; });
      })) {
    return map;
  }

  const double diameter = 2 * land.frame().radius();
  tbb::parallel_for(0, cells, [&](int j) {
    const auto count = std::size_t(cells);
    const Level& own = levels[0];
    const float* here = own.row(own.before + j) + own.before;
    const float *south = here - own.columns, *north_of = here + own.columns;
    std::vector<float> slope_x(count), slope_y(count), horizon(count), sum(count);
    for (std::size_t i = 0; i < count; ++i) {
      slope_x[i] = (here[i + 1] - *(here + i - 1)) * float(0.5 / map.spacing);
      slope_y[i] = (north_of[i] - south[i]) * float(0.5 / map.spacing);
    }
    for (int k = 0; k < directions; ++k) {
      const double azimuth = 2 * pi * k / directions, dx = std::sin(azimuth), dy = std::cos(azimuth);
      // The slope itself hides what lies behind it: tan(horizon elevation) is at least its own rise that way.
      for (std::size_t i = 0; i < count; ++i)
        horizon[i] = std::max(0.0f, slope_x[i] * float(dx) + slope_y[i] * float(dy));
      for (std::size_t l = 0; l < levels.size(); ++l) {
        const Level& level = levels[l];
        for (const double steps : {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0}) {
          if ((l > 0 && steps <= 3) || (l + 1 < levels.size() && steps > 6)) continue;
          const double d = steps * level.spacing;
          const double x = level.before + d * dx / map.spacing;
          const double y = (map.first_north + j * map.spacing + d * dy - level.first_north) / level.spacing;
          const int column = int(x), row = int(y);
          raise_horizon(level.row(row) + column, level.row(row + 1) + column, float(x - column), float(y - row), here,
                        float(d * d / diameter), float(1 / d), cells, horizon.data());
        }
      }
      for (std::size_t i = 0; i < count; ++i) {
        // The zenith angle of the horizon, its sine and its cosine.
        const float h = horizon[i], s = 1 / std::sqrt(1 + h * h), c = h * s, zenith = std::atan2(1.0f, h);
        const float gx = slope_x[i], gy = slope_y[i];
        const float cosine = 1 / std::sqrt(1 + gx * gx + gy * gy);
        // Dozier & Frew 1990: the integral over zenith angles of cosine of incidence times solid angle. The slope faces (-gx, -gy).
        sum[i] += cosine * (s * s - (gx * float(dx) + gy * float(dy)) * (zenith - s * c));
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      map.factor[std::size_t(j) * count + i] = std::clamp(sum[i] / directions, 0.0f, 1.0f);
  });
  return map;
}

double SkyViewMap::at(double east, double north) const {
  const double x = std::clamp((east - first_east) / spacing, 0.0, cells - 1.0);
  const double y = std::clamp((north - first_north) / spacing, 0.0, cells - 1.0);
  const int i = std::min(int(x), cells - 2), j = std::min(int(y), cells - 2);
  const double fx = x - i, fy = y - j;
  const float* f = &factor[std::size_t(j) * std::size_t(cells) + std::size_t(i)];
  return (double(f[0]) * (1 - fx) + double(f[1]) * fx) * (1 - fy) +
         (double(f[cells]) * (1 - fx) + double(f[cells + 1]) * fx) * fy;
}

}  // namespace airlight
