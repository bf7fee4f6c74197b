#include "model/realworldz_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "optics/colour.h"

namespace airlight {
namespace {

using std::numbers::pi;

/// The four texels around a place, with their weights.
template <class Take>
void around(const SkyTable& table, const TablePlace& place, const Take& take) {
  const double x = std::clamp(place.x * table.width - 0.5, 0.0, table.width - 1.0);
  const double y = std::clamp(place.y * table.height - 0.5, 0.0, table.height - 1.0);
  const int i = std::min(int(x), table.width - 2), j = std::min(int(y), table.height - 2);
  for (int corner = 0; corner < 4; ++corner) {
    const int column = i + corner % 2, row = j + corner / 2;
    take(column, row, (1 - std::abs(x - column)) * (1 - std::abs(y - row)));
  }
}

// Push-pull: colours and their weights are averaged down to one texel, and back up wherever weight is missing.
struct Weighted {
  int width, height;
  std::vector<std::array<double, 4>> texels;  // rgb times weight, weight
};
void fill(Weighted& fine) {
  if (fine.width == 1 && fine.height == 1) return;
  Weighted coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  coarse.texels.resize(std::size_t(coarse.width) * std::size_t(coarse.height));
  const auto above = [&](int i, int j) -> auto& {
    return coarse.texels[std::size_t(j) * std::size_t(coarse.width) + std::size_t(i)];
  };
  for (int j = 0; j < fine.height; ++j)
    for (int i = 0; i < fine.width; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        above(i / 2, j / 2)[c] += fine.texels[std::size_t(j) * std::size_t(fine.width) + std::size_t(i)][c];
  for (auto& t : coarse.texels)
    if (t[3] > 1)
      for (double& c : t) c /= t[3];  // full: weight 1
  fill(coarse);
  for (int j = 0; j < fine.height; ++j) {
    for (int i = 0; i < fine.width; ++i) {
      auto& t = fine.texels[std::size_t(j) * std::size_t(fine.width) + std::size_t(i)];
      const double missing = 1 - t[3];
      if (missing <= 0) continue;
      // Bilinear between the coarser texels' centres.
      const double x = std::clamp((i + 0.5) / 2 - 0.5, 0.0, coarse.width - 1.0),
                   y = std::clamp((j + 0.5) / 2 - 0.5, 0.0, coarse.height - 1.0);
      for (int corner = 0; corner < 4; ++corner) {
        const int a = std::min(int(x) + corner % 2, coarse.width - 1),
                  b = std::min(int(y) + corner / 2, coarse.height - 1);
        const double weight =
            (1 - std::abs(x - int(x) - corner % 2)) * (1 - std::abs(y - int(y) - corner / 2)) * missing;
        for (std::size_t c = 0; c < 3; ++c) t[c] += weight * above(a, b)[c];
      }
      t[3] = 1;
    }
  }
}

}  // namespace

SkyGeometry ring_geometry(const Direction& sun, std::vector<double> rings) {
  const auto optical_depth = [rings = std::move(rings)](double elevation) {
    const auto latitude = [&](double ring) {
      const double w = 2 * ring / double(rings.size() - 1) - 1;
      return w * std::abs(w);
    };
    const double part = std::clamp(elevation / (pi / 2), -1.0, 1.0), half = double(rings.size() - 1) / 2;
    const double at = half * (1 + std::copysign(std::sqrt(std::abs(part)), part));
    const std::size_t i = std::min(std::size_t(at), rings.size() - 2);
    const double t = (part - latitude(double(i))) / (latitude(double(i) + 1) - latitude(double(i)));
    return -std::log(rings[i] + (rings[i + 1] - rings[i]) * t);
  };
  return {sun, optical_depth};
}

TablePlace place_of(const SkyGeometry& sky, const Direction& view) {
  double square = 0;
  for (std::size_t c = 0; c < 3; ++c) square += (view[c] - sky.sun[c]) * (view[c] - sky.sun[c]);
  const double half_sine = std::min(std::sqrt(square) / 2, 1.0);
  return {2 * std::asin(half_sine) / pi, std::exp(-sky.optical_depth(std::asin(std::clamp(view[2], -1.0, 1.0))))};
}

std::array<double, 4> colour_at(const SkyTable& painted, const TablePlace& place) {
  std::array<double, 4> colour{};
  around(painted, place, [&](int column, int row, double weight) {
    for (std::size_t c = 0; c < 4; ++c) colour[c] += weight * painted.texel(column, row)[c];
  });
  return colour;
}

std::vector<float> highlight(const SkyTable& painted, int column, int row, const SkyGeometry& sky,
                             const Camera& camera) {
  std::vector<float> seen(std::size_t(camera.width) * std::size_t(camera.height), 0.0f);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const TablePlace place =
          place_of(sky, view_direction(camera, (x + 0.5) / camera.width, (y + 0.5) / camera.height));
      around(painted, place, [&](int i, int j, double weight) {
        if (i == column && j == row && weight > 0)
          seen[std::size_t(y) * std::size_t(camera.width) + std::size_t(x)] = 1;
      });
    }
  }
  return seen;
}

Projected back_projected(std::span<const float> rgb, const Camera& camera, const SkyGeometry& sky, int width,
                         int height, const std::function<bool(const Direction&)>& known) {
  Weighted sum{width, height, std::vector<std::array<double, 4>>(std::size_t(width) * std::size_t(height))};
  Projected result{realworldz_starter(width, height), std::vector<bool>(sum.texels.size())};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Direction view = view_direction(camera, (x + 0.5) / camera.width, (y + 0.5) / camera.height);
      if (known && !known(view)) continue;
      const float* const pixel = &rgb[3 * (std::size_t(y) * std::size_t(camera.width) + std::size_t(x))];
      around(result.table, place_of(sky, view), [&](int column, int row, double weight) {
        auto& t = sum.texels[std::size_t(row) * std::size_t(width) + std::size_t(column)];
        for (std::size_t c = 0; c < 3; ++c) t[c] += weight * double(pixel[c]);
        t[3] += weight;
      });
    }
  }
  for (std::size_t i = 0; i < sum.texels.size(); ++i) {
    auto& t = sum.texels[i];
    result.covered[i] = t[3] > 1e-6;
    if (result.covered[i])
      for (double& c : t) c /= t[3];
    else
      t = {};
  }
  std::vector<std::array<double, 4>> seen = sum.texels;
  fill(sum);
  for (std::size_t i = 0; i < sum.texels.size(); ++i) {
    double* const texel = &result.table.rgba[4 * i];
    // What the picture showed stays as it was: alpha lets stars through, it does not dim.
    for (std::size_t c = 0; c < 3; ++c) texel[c] = result.covered[i] ? seen[i][c] : sum.texels[i][c] * texel[3];
  }
  return result;
}

std::vector<double> discontinuities(const SkyTable& painted) {
  std::vector<double> steps(std::size_t(painted.width) * std::size_t(painted.height), 0.0);
  for (int j = 0; j < painted.height; ++j) {
    for (int i = 0; i < painted.width; ++i) {
      double& step = steps[std::size_t(j) * std::size_t(painted.width) + std::size_t(i)];
      for (const auto& [right, down] : {std::pair{1, 0}, std::pair{0, 1}}) {
        if (i + right >= painted.width || j + down >= painted.height) continue;
        for (int c = 0; c < 4; ++c)
          step = std::max(step, std::abs(painted.texel(i + right, j + down)[c] - painted.texel(i, j)[c]));
      }
    }
  }
  return steps;
}

void adjust(SkyTable& painted, const Adjustment& a) {
  const std::size_t count = painted.rgba.size() / 4;
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i)
    mean += luminance({painted.rgba[4 * i], painted.rgba[4 * i + 1], painted.rgba[4 * i + 2]}) / double(count);
  // Rotation about (1, 1, 1), after Rodrigues.
  const double c = std::cos(a.hue), s = std::sin(a.hue), third = (1 - c) / 3, root = s / std::sqrt(3.0);
  for (std::size_t i = 0; i < count; ++i) {
    double* const t = &painted.rgba[4 * i];
    const double turned[3] = {t[0] * (c + third) + t[1] * (third - root) + t[2] * (third + root),
                              t[0] * (third + root) + t[1] * (c + third) + t[2] * (third - root),
                              t[0] * (third - root) + t[1] * (third + root) + t[2] * (c + third)};
    const std::array<double, 3> reddened{turned[0] * (1 + a.redden), turned[1], turned[2] * (1 - a.redden)};
    const double light = std::max(luminance(reddened), 0.0);
    const double gain = a.lighten * (light > 0 && mean > 0 ? std::pow(light / mean, a.contrast - 1) : 1);
    for (std::size_t k = 0; k < 3; ++k) t[k] = std::max(reddened[k], 0.0) * gain;
  }
}

}  // namespace airlight
