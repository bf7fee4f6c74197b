#include "scene/map_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "airlight/error.h"
#include "scene/catmull_rom.h"

namespace airlight {
namespace {

using Point = std::array<double, 2>;

Point apply(const std::array<double, 6>& g, double column, double row) {
  return {g[0] + g[1] * column + g[2] * row, g[3] + g[4] * column + g[5] * row};
}

Point invert(const std::array<double, 6>& g, const Point& p) {
  const double x = p[0] - g[0], y = p[1] - g[3], determinant = g[1] * g[5] - g[2] * g[4];
  return {(x * g[5] - y * g[2]) / determinant, (y * g[1] - x * g[4]) / determinant};
}

bool is_georeferenced(const RasterFile& file) { return !file.coordinate_system().empty() && file.geotransform(); }

}  // namespace

std::optional<Place> middle_of(const RasterFile& file) {
  if (!is_georeferenced(file)) return std::nullopt;
  const Point middle = apply(*file.geotransform(), 0.5 * file.width(), 0.5 * file.height());
  return place_in(file.coordinate_system(), file.path(), middle);
}

MapGrid::MapGrid(const RasterFile& file, const Geography& geography, double cell_size, double extent) {
  const double width = file.width(), height = file.height();
  std::array<double, 6> transform{};
  const bool georeferenced = cell_size == 0 && is_georeferenced(file);
  if (georeferenced) {
    transform = *file.geotransform();
  } else if (cell_size > 0) {
    transform = {-0.5 * width * cell_size, cell_size, 0, 0.5 * height * cell_size, 0, -cell_size};
  } else {
    throw InputError(file.path() + ": says not where it lies" +
                     (file.geotransform() ? " (no coordinate system)" : " (no geotransform)") +
                     "; give cell_size [m], which puts its middle at the scene's origin");
  }

  // The file's outline in the scene, and the box around the part that is wanted.
  std::vector<Point> outline;
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) outline.push_back(apply(transform, width * i / steps, height * j / steps));
  }
  if (georeferenced) geography.from_system(file.coordinate_system(), file.path(), outline);
  west_ = south_ = 1e30, east_ = north_ = -1e30;
  for (const Point& p : outline) {
    if (std::isnan(p[0])) continue;  // the far side of the planet
    west_ = std::min(west_, p[0]), east_ = std::max(east_, p[0]);
    south_ = std::min(south_, p[1]), north_ = std::max(north_, p[1]);
  }
  if (west_ > extent || east_ < -extent || south_ > extent || north_ < -extent) {
    char text[160];
    std::snprintf(text, sizeof text,
                  ": its middle lies %.4g km east and %.4g km north of the scene's origin: expected within %.4g km",
                  (west_ + east_) / 2000, (south_ + north_) / 2000, extent / 1000);
    throw InputError(file.path() + text);
  }
  west_ = std::max(west_, -extent), east_ = std::min(east_, extent);
  south_ = std::max(south_, -extent), north_ = std::min(north_, extent);

  const double dx = (east_ - west_) / (nodes - 1), dy = (north_ - south_) / (nodes - 1);
  for (int j = -1; j <= nodes; ++j) {
    for (int i = -1; i <= nodes; ++i) grid_.push_back({west_ + i * dx, south_ + j * dy});
  }
  if (georeferenced) geography.to_system(file.coordinate_system(), file.path(), grid_);
  const bool turns = georeferenced && is_geographic(file.coordinate_system(), file.path());
  const double middle = apply(transform, width / 2, height / 2)[0];
  for (Point& p : grid_) {
    // The same longitude may be told as a turn more or less.
    if (turns) p[0] = middle + std::remainder(p[0] - middle, 360);
    p = invert(transform, p);
  }
  // Lengths of a step of one pixel in the middle of the box.
  const Point &a = node(nodes / 2, nodes / 2), &b = node(nodes / 2 + 2, nodes / 2), &c = node(nodes / 2, nodes / 2 + 2);
  const double xe = (b[0] - a[0]) / (2 * dx), ye = (b[1] - a[1]) / (2 * dx);
  const double xn = (c[0] - a[0]) / (2 * dy), yn = (c[1] - a[1]) / (2 * dy);
  const double determinant = std::abs(xe * yn - xn * ye);
  pixel_width_ = std::hypot(ye, yn) / determinant;
  pixel_height_ = std::hypot(xe, xn) / determinant;
}

Point MapGrid::pixel(double east, double north) const {
  const double dx = (east_ - west_) / (nodes - 1), dy = (north_ - south_) / (nodes - 1);
  const double x = (east - west_) / dx, y = (north - south_) / dy;
  const double cx = std::clamp(x, 0.0, nodes - 1.0), cy = std::clamp(y, 0.0, nodes - 1.0);
  const int i = std::min(int(cx), nodes - 2), j = std::min(int(cy), nodes - 2);
  const auto wx = catmull_rom(cx - i), wy = catmull_rom(cy - j);
  Point p{};
  for (int k = 0; k < 4; ++k) {
    const double w = wy[std::size_t(k)];
    for (int m = 0; m < 4; ++m) {
      const Point& n = node(i + m, j + k);
      p[0] += w * wx[std::size_t(m)] * n[0];
      p[1] += w * wx[std::size_t(m)] * n[1];
    }
  }
  if (x != cx || y != cy) {
    const Point &o = node(i + 1, j + 1), &e = node(i + 2, j + 1), &n = node(i + 1, j + 2);
    p[0] += (x - cx) * (e[0] - o[0]) + (y - cy) * (n[0] - o[0]);
    p[1] += (x - cx) * (e[1] - o[1]) + (y - cy) * (n[1] - o[1]);
  }
  return p;
}

}  // namespace airlight
