#include "model/realworldz_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

double smooth(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}
double mixed(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

SkyTable realworldz_starter(int width, int height) {
  SkyTable table{width, height, std::vector<double>(4 * std::size_t(width) * std::size_t(height))};
  constexpr double deep[] = {0.10, 0.28, 0.75}, pale[] = {0.33, 0.39, 0.48}, sunset[] = {1.0, 0.42, 0.10};
  for (int row = 0; row < height; ++row) {
    const double thick = 1 - (row + 0.5) / height;
    for (int column = 0; column < width; ++column) {
      const double x = (column + 0.5) / width;
      const double warm = smooth(0.7, 0.95, thick) * std::exp(-(x / 0.18) * (x / 0.18)),
                   bar = std::exp(-(x / 0.02) * (x / 0.02));
      const double alpha = std::max(smooth(0, 0.25, thick), bar);
      double* const texel = table.texel(column, row);
      for (int c = 0; c < 3; ++c) {
        const double blue = deep[c] * std::pow(thick, 0.6) * (1 - 0.35 * x) + pale[c] * smooth(0.6, 1, thick);
        texel[c] = alpha * mixed(mixed(blue, sunset[c], warm) * smooth(0, 0.15, thick), 1, bar);
      }
      texel[3] = alpha;
    }
  }
  return table;
}

SkyTable table_of(const ParameterPicture& picture) {
  SkyTable table{picture.width, picture.height, {}};
  const std::size_t row = 4 * std::size_t(picture.width);
  for (std::size_t y = std::size_t(picture.height); y-- > 0;)
    table.rgba.insert(table.rgba.end(), &picture.rgba[y * row], &picture.rgba[y * row] + row);
  return table;
}

ParameterPicture picture_of(const SkyTable& painted, std::string name) {
  ParameterPicture picture{std::move(name), painted.width, painted.height, {}};
  const std::size_t row = 4 * std::size_t(painted.width);
  for (std::size_t y = std::size_t(painted.height); y-- > 0;)
    for (std::size_t i = 0; i < row; ++i) picture.rgba.push_back(float(painted.rgba[y * row + i]));
  return picture;
}

void paint_halo(SkyTable& table, double inner, double outer, double strength) {
  for (int column = 0; column < table.width; ++column) {
    const double t = ((column + 0.5) / table.width * 180 - inner) / (outer - inner);
    if (t < 0 || t > 1) continue;
    // Red inside, violet outside, as ice halos have it; nothing at both edges, for a sharp one would show as a line.
    for (int row = 0; row < table.height; ++row) {
      double* const texel = table.texel(column, row);
      for (int c = 0; c < 3; ++c) {
        const double hue = std::max(0.0, 1 - std::abs(t - (c + 1) * 0.25) / 0.25);
        texel[c] += strength * hue * texel[3];
      }
    }
  }
}

double realworldz_source_x(double column, double width) {
  return 2 * std::asin(std::sqrt((column + 0.5) / width)) / std::numbers::pi;
}

SkyTable realworldz_resampled(const SkyTable& painted) {
  SkyTable table{2 * painted.width, painted.height, {}};
  table.rgba.resize(2 * painted.rgba.size());
  for (int column = 0; column < table.width; ++column) {
    const double x =
        std::clamp(realworldz_source_x(column, table.width) * painted.width - 0.5, 0.0, painted.width - 1.0);
    const int left = std::min(int(x), painted.width - 2);
    for (int row = 0; row < table.height; ++row) {
      const double *const a = painted.texel(left, row), *const b = painted.texel(left + 1, row);
      for (int c = 0; c < 4; ++c) table.texel(column, row)[c] = mixed(a[c], b[c], x - left);
    }
  }
  return table;
}

}  // namespace airlight
