#include "scene/sky_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "airlight/error.h"
#include "every_processor.h"

namespace airlight {
namespace {

using std::numbers::pi;
constexpr int directions = 16;

/// Heights on the map's grid and beyond it, at one smoothness.
struct Level {
  double first_east, first_north, spacing;
  int cells;
  std::vector<float> altitude;
};

/// Altitudes along a line of a level that lies east to west, between two of its rows.
AIRLIGHT_EVERY_PROCESSOR
void blend_rows(const float* lower, const float* upper, float between, int count, float* out) {
  for (int i = 0; i < count; ++i) out[i] = lower[i] + (upper[i] - lower[i]) * between;
}

/// Altitudes on that line at `first` and each `step` from there [cells of the level], held constant beyond its ends.
AIRLIGHT_EVERY_PROCESSOR
void altitudes_along(const float* line, float first, float step, float last, int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float x = std::min(std::max(first + float(i) * step, 0.0f), last);
    const int cell = int(x);
    out[i] = line[cell] + (line[cell + 1] - line[cell]) * (x - float(cell));
  }
}

/// Lifts the tangent of each place's horizon to what stands there.
AIRLIGHT_EVERY_PROCESSOR
void raise_horizon(const float* there, const float* here, int count, float sunk, float per_metre, float* horizon) {
  for (int i = 0; i < count; ++i) horizon[i] = std::max(horizon[i], (there[i] - here[i] - sunk) * per_metre);
}

/// What a row of the map sees in a level: as many altitudes as `out` holds, from (east, north) on in steps of `spacing` to the east.
/// @param line  as long as a row of the level; overwritten
void look(const Level& level, double east, double north, double spacing, std::span<float> line, std::span<float> out) {
  const double y = std::clamp((north - level.first_north) / level.spacing, 0.0, level.cells - 1.001);
  const int j = int(y);
  const float* lower = &level.altitude[std::size_t(j) * std::size_t(level.cells)];
  blend_rows(lower, lower + level.cells, float(y - j), level.cells, line.data());
  altitudes_along(line.data(), float((east - level.first_east) / level.spacing), float(spacing / level.spacing),
                  float(level.cells) - 1.001f, int(out.size()), out.data());
}

Level sample(const Land& land, double east, double north, double half_width, int cells) {
  Level level{0, 0, 2 * half_width / cells, cells, {}};
  level.first_east = east - half_width + 0.5 * level.spacing;
  level.first_north = north - half_width + 0.5 * level.spacing;
  level.altitude.resize(std::size_t(cells) * std::size_t(cells));
  tbb::parallel_for(0, cells, [&](int j) {
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < cells; ++i) {
      places.push_back({level.first_east + i * level.spacing, level.first_north + j * level.spacing});
    }
    std::vector<double> altitudes(places.size());
    land.altitudes(places, level.spacing, altitudes);
    std::ranges::copy(altitudes, &level.altitude[std::size_t(j) * std::size_t(cells)]);
  });
  return level;
}

}  // namespace

SkyViewMap sky_view_map(const Land& land, double east, double north, double half_width, int cells) {
  if (cells < 2 || !(half_width > 0)) throw InputError("a sky-view map needs at least 2 x 2 cells of some width");
  // Land at the map's own spacing; and at each doubling of it, on grids that reach farther.
  std::vector<Level> levels{sample(land, east, north, half_width, cells)};
  const double spacing = levels[0].spacing;
  for (double s = 2 * spacing; s < 0.25 * land.extent() && s < 64 * spacing; s *= 2) {
    const double reach = std::min(half_width + 12 * s, land.extent() + half_width);
    levels.push_back(sample(land, east, north, reach, std::max(2, int(2 * reach / s))));
  }
  SkyViewMap map{levels[0].first_east, levels[0].first_north, spacing, cells, {}};
  // A plain hides nothing of the sky: no need to look around from each of its places.
  const float first = levels[0].altitude[0];
  if (std::ranges::all_of(levels, [&](const Level& level) {
        return std::ranges::all_of(level.altitude, [&](float altitude) { return altitude == first; });
      })) {
    map.factor.assign(levels[0].altitude.size(), 1);
    return map;
  }
  map.factor.resize(levels[0].altitude.size());

  const double diameter = 2 * land.frame().radius();
  std::size_t longest = 0;
  for (const Level& level : levels) longest = std::max(longest, std::size_t(level.cells));
  tbb::parallel_for(0, cells, [&](int j) {
    const auto count = std::size_t(cells);
    const double x = map.first_east, y = map.first_north + j * spacing;
    const float* here = &levels[0].altitude[std::size_t(j) * count];
    std::vector<float> at_west(count), at_east(count), at_south(count), at_north(count), there(count), horizon(count),
        sum(count), line(longest);
    look(levels[0], x - spacing, y, spacing, line, at_west);
    look(levels[0], x + spacing, y, spacing, line, at_east);
    look(levels[0], x, y - spacing, spacing, line, at_south);
    look(levels[0], x, y + spacing, spacing, line, at_north);
    const auto gradient = [&](const std::vector<float>& from, const std::vector<float>& to, std::size_t i) {
      return (to[i] - from[i]) * float(0.5 / spacing);
    };
    for (int k = 0; k < directions; ++k) {
      const double azimuth = 2 * pi * k / directions, dx = std::sin(azimuth), dy = std::cos(azimuth);
      // The slope itself hides what lies behind it: tan(horizon elevation) is at least its own rise that way.
      for (std::size_t i = 0; i < count; ++i) {
        const float rise = gradient(at_west, at_east, i) * float(dx) + gradient(at_south, at_north, i) * float(dy);
        horizon[i] = std::max(0.0f, rise);
      }
      for (std::size_t l = 0; l < levels.size(); ++l) {
        for (const double steps : {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0}) {
          // Each level looks from 3 to 6 of its own cells away; the first also nearer, the last also farther.
          if ((l > 0 && steps <= 3) || (l + 1 < levels.size() && steps > 6)) continue;
          const double d = steps * levels[l].spacing;
          look(levels[l], x + d * dx, y + d * dy, spacing, line, there);
          raise_horizon(there.data(), here, cells, float(d * d / diameter), float(1 / d), horizon.data());
        }
      }
      for (std::size_t i = 0; i < count; ++i) {
        // The zenith angle of the horizon, its sine and its cosine.
        const float h = horizon[i], s = 1 / std::sqrt(1 + h * h), c = h * s, zenith = std::atan2(1.0f, h);
        const float gx = gradient(at_west, at_east, i), gy = gradient(at_south, at_north, i);
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
