#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "airlight/sky.h"

namespace airlight::test {

inline constexpr double degree = std::numbers::pi / 180;

inline Direction toward(double azimuth_deg, double elevation_deg) {
  return direction(azimuth_deg * degree, elevation_deg * degree);
}

inline std::vector<float> draw(const Sky& sky, const Camera& camera, Direction sun,
                               const PictureOptions& options = {}) {
  std::vector<float> pixels;
  sky.render(camera, sun, options, [&](int, int, std::span<const float> rgba) {
    pixels.insert(pixels.end(), rgba.begin(), rgba.end());
    return true;
  });
  return pixels;
}

/// CIE Y [cd/m^2] of a linear sRGB pixel.
inline double luminance(const float* rgb) { return 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]; }

inline bool has_gl() {
  try {
    make_engine("gl");
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace airlight::test
