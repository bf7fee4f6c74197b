#include "ray_batches.h"

#include <cmath>
#include <numbers>
#include <random>

namespace airlight::bench {

std::vector<Ray> random_rays(std::size_t count) {
  std::mt19937_64 random(1);
  const auto between = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
  const auto anywhere = [&](double lowest) {
    return direction(between(0, 2 * std::numbers::pi), std::asin(between(lowest, 1)));
  };
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) rays.push_back({between(0, 1e4), anywhere(-1), anywhere(-0.1)});
  return rays;
}

std::vector<Ray> picture_rays(int width, int height, double sun) {
  std::vector<Ray> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double across = 2 * (x + 0.5) / width - 1, up = 0.75 - (y + 0.5) / height;
      const double length = std::sqrt(1 + across * across + up * up);
      rays.push_back({2, {across / length, 1 / length, up / length}, direction(0.3, sun)});
    }
  }
  return rays;
}

}  // namespace airlight::bench
