#include "scene/relief.h"

#include <algorithm>
#include <cmath>

#include "every_processor.h"
#include "scene/noise.h"

namespace airlight {
namespace {

// Places are worked on in lanes: each step is a loop over them that the compiler makes into vector instructions, so functions
// called in one have no branches.
constexpr int lanes = 16;

struct Ridge {
  Slope slope;
  float lost2;  ///< the slope's square that rounding takes away: all of it on the crest, next to nothing beside
};

/// Ridges where noise changes its sign, in [0, 1], with rounded crests.
AIRLIGHT_INLINE Ridge ridge(float x, float y, std::uint32_t seed) {
  constexpr float rounding = 0.07f;
  const Slope n = noise(x, y, seed);
  const float distance = std::sqrt(n.height * n.height + rounding * rounding);
  const float sign = n.height / distance;
  return {{1 - distance + rounding, -sign * n.x, -sign * n.y},
          (1 - sign * sign) * (1 - sign * sign) * (n.x * n.x + n.y * n.y)};
}

/// Ribs and gullies that run down a slope, for all lanes: waves whose crests follow the fall line, a patch of them round each of
/// the lattice's scattered points, so that they split and join.
struct Ribs {
  float height[lanes];        ///< in [-1, 1]
  float across_slope[lanes];  ///< its slope towards the left of downhill

  /// @param down_x, down_y  unit, downhill
  AIRLIGHT_INLINE Ribs(const float* x, const float* y, const float* down_x, const float* down_y, float frequency,
                       std::uint32_t seed) {
    constexpr float reach2 = 1.25f * 1.25f;          // squared; points that are not next to this cell are farther
    float weights[lanes], in_x[lanes], in_y[lanes];  // place within its cell
    std::uint32_t cell[lanes];
    for (int l = 0; l < lanes; ++l) {
      const float u = x[l] * frequency, v = y[l] * frequency, fu = std::floor(u), fv = std::floor(v);
      in_x[l] = u - fu, in_y[l] = v - fv;
      cell[l] = seed + lattice_number(std::int32_t(fu), std::int32_t(fv));
      height[l] = across_slope[l] = 0, weights[l] = 1e-6f;
    }
    for (int k = 0; k < 9; ++k) {
      const int i = k % 3 - 1, j = k / 3 - 1;
      for (int l = 0; l < lanes; ++l) {
        const std::uint32_t bits = scramble(cell[l] + lattice_number(i, j));
        const float px = in_x[l] - (float(i) + 0.25f + 0.5f * low_half(bits));
        const float py = in_y[l] - (float(j) + 0.25f + 0.5f * high_half(bits));
        const float w = std::max(0.0f, 1 - (px * px + py * py) / reach2), weight = w * w * w;
        const float phase = py * down_x[l] - px * down_y[l];
        const float turn = phase - std::floor(phase + 0.5f);  // -0.5 .. 0.5, 0 on a crest
        const float m = 1 - 2 * std::abs(turn);
        // A cubic in place of the cosine.
        height[l] += weight * (2 * m * m * (3 - 2 * m) - 1);
        across_slope[l] -= weight * 24 * m * (1 - m) * std::copysign(1.0f, turn);
        weights[l] += weight;
      }
    }
    for (int l = 0; l < lanes; ++l) height[l] /= weights[l], across_slope[l] /= weights[l];
  }
};

constexpr float mean_cut = 0.3f;  ///< that gullies take from a slope on the whole, as a part of their depth

/// Depth of gullies on a slope, in [0, 1]. Where the fall line turns round, gullies that follow it would be cut across, into blades:
/// floors hold none, and crests, level or running downhill, are notched without regard to it.
/// @param steepness2  squared slope
/// @param turns       how fast the fall line turns, on the same scale
AIRLIGHT_INLINE float gullied(float steepness2, float turns) {
  return steepness2 * steepness2 / ((0.5f + steepness2) * (steepness2 + turns + 1e-9f));
}

/// 0 where a wave is shorter than two cells, 1 from four cells on.
float resolved(double wavelength, double cell) {
  return cell > 0 ? float(std::clamp(wavelength / (2 * cell) - 1, 0.0, 1.0)) : 1.0f;
}

AIRLIGHT_EVERY_PROCESSOR
void relief_lanes(const ReliefSettings& settings, double cell, float* x, float* y, float* height) {
  const std::uint32_t seed = settings.seed * 0x68E31DA4u;
  float slope_x[lanes], slope_y[lanes], on_ridge[lanes], crest2[lanes];

  // Ranges are bent: noise moves the place that noise is asked at.
  for (int l = 0; l < lanes; ++l) {
    const float bend_x = noise(0.7f * x[l], 0.7f * y[l], seed + 1).height;
    const float bend_y = noise(0.7f * x[l], 0.7f * y[l], seed + 2).height;
    x[l] += 0.35f * bend_x, y[l] += 0.35f * bend_y;
    height[l] = slope_x[l] = slope_y[l] = crest2[l] = 0;
    on_ridge[l] = 1;
  }

  // Massifs and their main ridges; each octave grows on the ridges of the one before.
  float amplitude = 1.15f, frequency = 0.55f;
  for (std::uint32_t octave = 0; octave < 3; ++octave) {
    const float kept = amplitude * resolved(settings.wavelength / double(frequency), cell);
    if (kept == 0) break;
    for (int l = 0; l < lanes; ++l) {
      const auto [r, lost2] = ridge(frequency * x[l], frequency * y[l], seed + 10 + octave);
      const float a = kept * on_ridge[l], steepness = a * 2 * r.height * frequency;
      height[l] += a * (r.height * r.height - 0.47f);
      slope_x[l] += steepness * r.x;
      slope_y[l] += steepness * r.y;
      crest2[l] += steepness * steepness * lost2;
      on_ridge[l] = std::min(1.0f, std::max(0.0f, on_ridge[l] * r.height * 1.3f));
    }
    frequency *= 2.13f, amplitude *= 0.48f;
  }

  // Water cuts gullies down every slope, smaller ones into the walls of greater ones.
  frequency = 3.1f;
  float depth = 0.085f * float(0.4 + 1.2 * settings.ruggedness);
  for (std::uint32_t octave = 0; octave < 8; ++octave) {
    const float kept = resolved(settings.wavelength / double(frequency), cell);
    if (kept == 0) {
      // What gullies take away on the whole is gone all the same, else coarse ridges would hide what lies behind fine ones.
      for (int l = 0; l < lanes; ++l) {
        const float steepness2 = slope_x[l] * slope_x[l] + slope_y[l] * slope_y[l];
        height[l] -= mean_cut * depth * gullied(steepness2, 30 * depth * crest2[l]);
      }
    } else {
      float down_x[lanes], down_y[lanes];
      for (int l = 0; l < lanes; ++l) {
        const float downhill = -1 / std::sqrt(std::max(slope_x[l] * slope_x[l] + slope_y[l] * slope_y[l], 1e-12f));
        down_x[l] = slope_x[l] * downhill, down_y[l] = slope_y[l] * downhill;
      }
      const Ribs ribs(x, y, down_x, down_y, frequency, seed + 100 + octave);
      for (int l = 0; l < lanes; ++l) {
        const float steepness2 = slope_x[l] * slope_x[l] + slope_y[l] * slope_y[l];
        const float cut = depth * gullied(steepness2, 30 * depth * crest2[l]);
        const float notch = 1.6f * kept * depth * crest2[l] / (0.3f + crest2[l]);
        const Slope crag = ridge(frequency * x[l], frequency * y[l], seed + 200 + octave).slope;
        height[l] += cut * (kept * ribs.height[l] - mean_cut) + notch * (crag.height - 0.7f);
        const float across = 0.7f * kept * cut * ribs.across_slope[l] * frequency;
        slope_x[l] += notch * crag.x * frequency - across * down_y[l];
        slope_y[l] += notch * crag.y * frequency + across * down_x[l];
      }
    }
    frequency *= 1.83f, depth *= 0.53f;
  }

  const float highest = float(settings.height);
  for (int l = 0; l < lanes; ++l) {
    // Valley floors are filled, and no summit outgrows the stated height.
    constexpr float floor = 0.06f, soft = 0.05f;
    const float above = height[l] - floor;
    const float t = std::max(0.0f, 0.5f * (above + std::sqrt(above * above + soft * soft)));
    height[l] = highest * t / std::sqrt(std::sqrt(1 + t * t * t * t));
  }
}

}  // namespace

void relief(const ReliefSettings& settings, std::span<const std::array<double, 2>> places, double cell,
            std::span<float> heights) {
  const double scale = 1 / settings.wavelength;
  for (std::size_t begin = 0; begin < places.size(); begin += lanes) {
    alignas(64) float x[lanes], y[lanes], height[lanes];
    const std::size_t count = std::min<std::size_t>(lanes, places.size() - begin);
    for (std::size_t l = 0; l < lanes; ++l) {
      const auto& place = places[begin + std::min(l, count - 1)];
      x[l] = float(place[0] * scale), y[l] = float(place[1] * scale);
    }
    relief_lanes(settings, cell, x, y, height);
    std::copy_n(height, count, heights.begin() + std::ptrdiff_t(begin));
  }
}

}  // namespace airlight
