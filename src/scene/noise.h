// Smooth randomness over the plane, without branches, so that loops over it become vector instructions.
#pragma once
#include <cmath>
#include <cstdint>

#include "every_processor.h"

namespace airlight {

/// A height and its gradient, per unit of the plane they are functions of.
struct Slope {
  float height, x, y;
};

/// A number for each lattice point. They are linear, so that a neighbour's is its own plus that of the way there.
AIRLIGHT_INLINE std::uint32_t lattice_number(std::int32_t x, std::int32_t y) {
  return static_cast<std::uint32_t>(x) * 0x9E3779B1u + static_cast<std::uint32_t>(y) * 0x85EBCA77u;
}
/// Bits without pattern from a seed plus such a number; integers only, so the same everywhere.
AIRLIGHT_INLINE std::uint32_t scramble(std::uint32_t h) {
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}
AIRLIGHT_INLINE float low_half(std::uint32_t bits) { return float(std::int32_t(bits & 0xFFFFu)) * (1 / 65535.0f); }
AIRLIGHT_INLINE float high_half(std::uint32_t bits) { return float(std::int32_t(bits >> 16)) * (1 / 65535.0f); }

/// Gradient noise (Perlin 2002: quintic blend, so that slopes have no creases), in about [-1, 1], with its gradient.
AIRLIGHT_INLINE Slope noise(float x, float y, std::uint32_t seed) {
  const float fx = std::floor(x), fy = std::floor(y), u = x - fx, v = y - fy;
  const std::uint32_t corner = seed + lattice_number(static_cast<std::int32_t>(fx), static_cast<std::int32_t>(fy));
  const float a = u * u * u * (u * (u * 6 - 15) + 10), b = v * v * v * (v * (v * 6 - 15) + 10);
  const float da = 30 * u * u * (u - 1) * (u - 1), db = 30 * v * v * (v - 1) * (v - 1);
  float gx[4], gy[4], g[4];  // gradients at the corners: components uniform in [-1, 1]
  for (int k = 0; k < 4; ++k) {
    const int cx = k & 1, cy = k >> 1;
    const std::uint32_t bits = scramble(corner + lattice_number(cx, cy));
    gx[k] = 2 * low_half(bits) - 1;
    gy[k] = 2 * high_half(bits) - 1;
    g[k] = gx[k] * (u - float(cx)) + gy[k] * (v - float(cy));
  }
  const float k1 = g[1] - g[0], k2 = g[2] - g[0], k3 = g[0] - g[1] - g[2] + g[3];
  constexpr float norm = 1.5f;
  return {norm * (g[0] + a * k1 + b * k2 + a * b * k3),
          norm * (gx[0] + a * (gx[1] - gx[0]) + b * (gx[2] - gx[0]) + a * b * (gx[0] - gx[1] - gx[2] + gx[3]) +
                  da * (k1 + b * k3)),
          norm * (gy[0] + a * (gy[1] - gy[0]) + b * (gy[2] - gy[0]) + a * b * (gy[0] - gy[1] - gy[2] + gy[3]) +
                  db * (k2 + a * k3))};
}

}  // namespace airlight
