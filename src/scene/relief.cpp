#include "scene/relief.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

/// A height and its gradient, per unit of the plane they are functions of.
struct Slope {
  double height = 0, x = 0, y = 0;
};

/// Bits without pattern from a lattice point (Wang-style mixing; integers only, so the same everywhere).
std::uint32_t scramble(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = seed + static_cast<std::uint32_t>(x) * 0x9E3779B1u + static_cast<std::uint32_t>(y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

/// Gradient noise (Perlin 2002: quintic blend, so that slopes have no creases), in about [-1, 1], with its gradient.
Slope noise(double x, double y, std::uint32_t seed) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto ix = static_cast<std::int32_t>(fx), iy = static_cast<std::int32_t>(fy);
  const double u = x - fx, v = y - fy;
  const double a = u * u * u * (u * (u * 6 - 15) + 10), b = v * v * v * (v * (v * 6 - 15) + 10);
  const double da = 30 * u * u * (u - 1) * (u - 1), db = 30 * v * v * (v - 1) * (v - 1);
  // Corners' gradients: components uniform in [-1, 1], 16 bits each.
  double gx[4], gy[4], g[4];
  for (int k = 0; k < 4; ++k) {
    const int cx = k & 1, cy = k >> 1;
    const std::uint32_t bits = scramble(ix + cx, iy + cy, seed);
    gx[k] = (bits & 0xFFFFu) * (2.0 / 65535) - 1;
    gy[k] = (bits >> 16) * (2.0 / 65535) - 1;
    g[k] = gx[k] * (u - cx) + gy[k] * (v - cy);
  }
  const double k0 = g[0], k1 = g[1] - g[0], k2 = g[2] - g[0], k3 = g[0] - g[1] - g[2] + g[3];
  constexpr double norm = 1.5;
  return {norm * (k0 + a * k1 + b * k2 + a * b * k3),
          norm * (gx[0] + a * (gx[1] - gx[0]) + b * (gx[2] - gx[0]) + a * b * (gx[0] - gx[1] - gx[2] + gx[3]) +
                  da * (k1 + b * k3)),
          norm * (gy[0] + a * (gy[1] - gy[0]) + b * (gy[2] - gy[0]) + a * b * (gy[0] - gy[1] - gy[2] + gy[3]) +
                  db * (k2 + a * k3))};
}

/// 1 - |n| with the crest rounded over a width: ridges where noise changes its sign.
Slope ridge(double x, double y, double rounding, std::uint32_t seed) {
  const Slope n = noise(x, y, seed);
  const double distance = std::sqrt(n.height * n.height + rounding * rounding);
  const double sign = n.height / distance;
  return {1 - distance + rounding, -sign * n.x, -sign * n.y};
}

/// Ribs and gullies that run down a slope: waves whose crests follow the fall line, a patch of them round each of the
/// lattice's scattered points, so that they split and join. In [-1, 1], gradient across the ribs.
/// @param down_x, down_y  unit, downhill
Slope ribs(double x, double y, double down_x, double down_y, std::uint32_t seed) {
  const auto ix = static_cast<std::int32_t>(std::floor(x)), iy = static_cast<std::int32_t>(std::floor(y));
  const double side_x = -down_y, side_y = down_x;
  double sum = 0, slope = 0, weights = 1e-6;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const std::uint32_t bits = scramble(ix + i, iy + j, seed);
      const double px = x - (ix + i + 0.25 + (bits & 0xFFFFu) * (0.5 / 65535));
      const double py = y - (iy + j + 0.25 + (bits >> 16) * (0.5 / 65535));
      const double distance2 = px * px + py * py;
      if (distance2 >= 1.5625) continue;  // what no point leaves out of its patch
      const double w = 1 - distance2 / 1.5625, weight = w * w * w;
      // Cosine by its quadratic spline: sharp ribs are the next octaves' work.
      const double phase = px * side_x + py * side_y;
      const double turn = phase - std::floor(phase + 0.5);  // -0.5 .. 0.5
      const double m = 1 - 2 * std::abs(turn);              // 0 .. 1, 1 at the crest
      const double s = m * m * (3 - 2 * m);
      sum += weight * (2 * s - 1);
      slope += weight * 2 * 6 * m * (1 - m) * (turn > 0 ? -2.0 : 2.0);
      weights += weight;
    }
  }
  sum /= weights, slope /= weights;
  return {sum, slope * side_x, slope * side_y};
}

/// 0 where a wave is shorter than two cells, 1 from four cells on.
double resolved(double wavelength, double cell) {
  return cell > 0 ? std::clamp(wavelength / (2 * cell) - 1, 0.0, 1.0) : 1;
}

}  // namespace

double relief(const ReliefSettings& settings, double east, double north, double cell) {
  const std::uint32_t seed = settings.seed * 0x68E31DA4u;
  const double scale = 1 / settings.wavelength, aspect = settings.height * scale;
  double x = east * scale, y = north * scale;

  // Ranges are bent: noise moves the place that noise is asked at.
  const Slope bend_x = noise(0.7 * x, 0.7 * y, seed + 1), bend_y = noise(0.7 * x, 0.7 * y, seed + 2);
  x += 0.35 * bend_x.height, y += 0.35 * bend_y.height;

  // Massifs and their main ridges; each octave grows on the ridges of the one before.
  Slope h;
  double amplitude = 0.62, frequency = 0.5, on_ridge = 1;
  for (std::uint32_t octave = 0; octave < 4; ++octave) {
    const double kept = resolved(settings.wavelength / frequency, cell);
    if (kept == 0) break;
    const Slope r = ridge(frequency * x, frequency * y, 0.04, seed + 10 + octave);
    const double a = amplitude * on_ridge * kept;
    h.height += a * (r.height * r.height - 0.3);
    h.x += a * 2 * r.height * r.x * frequency, h.y += a * 2 * r.height * r.y * frequency;
    on_ridge = std::clamp(on_ridge * r.height * 1.4, 0.0, 1.0);
    frequency *= 2.03, amplitude *= 0.52;
  }

  // Water cuts gullies down every slope, smaller ones into the walls of greater ones.
  frequency = 5.5;
  double depth = 0.085 * (0.4 + 1.2 * settings.ruggedness);
  for (std::uint32_t octave = 0; octave < 7; ++octave) {
    const double kept = resolved(settings.wavelength / frequency, cell);
    if (kept == 0) break;
    const double steepness = std::hypot(h.x, h.y);
    if (steepness > 1e-9) {
      // Flats hold no gullies; walls are stripped evenly.
      const double cut = depth * kept * std::min(1.0, steepness * steepness / (0.35 + steepness * steepness) * 1.3);
      const Slope r = ribs(frequency * x, frequency * y, -h.x / steepness, -h.y / steepness, seed + 100 + octave);
      h.height += cut * (r.height - 0.4);
      h.x += cut * r.x * frequency, h.y += cut * r.y * frequency;
    }
    frequency *= 1.97, depth *= 0.5;
  }
  (void)aspect;
  // Valley floors are filled.
  const double floor = 0.06, soft = 0.05;
  const double above = h.height - floor;
  const double filled = floor + 0.5 * (above + std::sqrt(above * above + soft * soft));
  return settings.height * std::clamp(filled - floor, 0.0, 1.0);
}

}  // namespace airlight
