#include "scene/sky_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

using std::numbers::pi;
constexpr int directions = 16;

/// Heights on the map's grid and beyond it, at one smoothness.
struct Level {
  double first_east, first_north, spacing;
  int cells;
  std::vector<double> altitude;

  double at(double east, double north) const {
    const double x = std::clamp((east - first_east) / spacing, 0.0, cells - 1.001);
    const double y = std::clamp((north - first_north) / spacing, 0.0, cells - 1.001);
    const int i = int(x), j = int(y);
    const double fx = x - i, fy = y - j;
    const double* a = &altitude[std::size_t(j) * std::size_t(cells) + std::size_t(i)];
    return (a[0] * (1 - fx) + a[1] * fx) * (1 - fy) + (a[cells] * (1 - fx) + a[cells + 1] * fx) * fy;
  }
};

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
    land.altitudes(places, level.spacing,
                   std::span(level.altitude).subspan(std::size_t(j) * std::size_t(cells), std::size_t(cells)));
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
  const double first = levels[0].altitude[0];
  if (std::ranges::all_of(levels, [&](const Level& level) {
        return std::ranges::all_of(level.altitude, [&](double altitude) { return altitude == first; });
      })) {
    map.factor.assign(levels[0].altitude.size(), 1);
    return map;
  }
  map.factor.resize(levels[0].altitude.size());

  tbb::parallel_for(0, cells, [&](int j) {
    for (int i = 0; i < cells; ++i) {
      const double x = map.first_east + i * spacing, y = map.first_north + j * spacing;
      const double here = levels[0].altitude[std::size_t(j) * std::size_t(cells) + std::size_t(i)];
      const double gx = (levels[0].at(x + spacing, y) - levels[0].at(x - spacing, y)) / (2 * spacing);
      const double gy = (levels[0].at(x, y + spacing) - levels[0].at(x, y - spacing)) / (2 * spacing);
      const double tangent = std::hypot(gx, gy), cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
      const double aspect = std::atan2(-gx, -gy);  // azimuth that the slope faces
      double sum = 0;
      for (int k = 0; k < directions; ++k) {
        const double azimuth = 2 * pi * k / directions, dx = std::sin(azimuth), dy = std::cos(azimuth);
        // The slope itself hides what lies behind it: tan(horizon elevation) is at least its own rise that way.
        double horizon = std::max(0.0, gx * dx + gy * dy);
        for (std::size_t l = 0; l < levels.size(); ++l) {
          const double s = levels[l].spacing;
          for (const double steps : {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0}) {
            // Each level looks from 3 to 6 of its own cells away; the first also nearer, the last also farther.
            if ((l > 0 && steps <= 3) || (l + 1 < levels.size() && steps > 6)) continue;
            const double d = steps * s;
            const double rise = levels[l].at(x + d * dx, y + d * dy) - here - d * d / (2 * land.frame().radius());
            horizon = std::max(horizon, rise / d);
          }
        }
        const double zenith = 0.5 * pi - std::atan(horizon);  // of the horizon, from the vertical
        const double s = std::sin(zenith);
        // Dozier & Frew 1990: the integral over zenith angles of cosine of incidence times solid angle.
        sum += cosine * s * s + sine * std::cos(azimuth - aspect) * (zenith - s * std::cos(zenith));
      }
      map.factor[std::size_t(j) * std::size_t(cells) + std::size_t(i)] = float(std::clamp(sum / directions, 0.0, 1.0));
    }
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
