#include "image/tone.h"

#include <algorithm>
#include <cmath>

#define AIRLIGHT_TARGET image_tone
#define AIRLIGHT_REP xsimd::batch<float, xsimd::default_arch>
#include "prelude/prelude.hpp"
namespace airlight::AIRLIGHT_TARGET {
#include "codeflow/tone.glsl"
#include "core/math.glsl"
#include "core/tone.glsl"
}  // namespace airlight::AIRLIGHT_TARGET

namespace airlight {
namespace {
using namespace image_tone;

// 8.5 EV above middle grey (0.18): what Reinhard's curve shows as white.
constexpr double reinhard_white = 64;

/// Dither threshold of a pixel: one of the 256 middles of equal parts of 0..1, so that black and white, which rounding
/// errors leave a little inside, stay exact. A rank-1 lattice of the plastic number's powers (Roberts 2018, "R2"), in
/// whole numbers modulo 2^32: neighbours differ much, so the noise is fine and the mean over a few pixels is right.
float threshold(std::uint32_t x, std::uint32_t y) {
  return (float((x * 3242174889u + y * 2447445414u) >> 24) + 0.5f) * 0x1p-8f;
}

/// Encoded, 0..1.
Vec3 shown(const Vec3& light, ToneCurve curve) {
  if (curve == ToneCurve::codeflow) return codeflow_tone(light);
  if (curve == ToneCurve::square_root) {
    const auto root = [](const Float& x) { return sqrt(clamp(x, 0.0, 1.0)); };
    return {root(light.x), root(light.y), root(light.z)};
  }
  const Vec3 linear = curve == ToneCurve::filmic     ? tone_filmic(light)
                      : curve == ToneCurve::reinhard ? tone_reinhard(light, reinhard_white)
                      : curve == ToneCurve::exponential
                          ? Vec3(one_minus_exp(light.x), one_minus_exp(light.y), one_minus_exp(light.z))
                          : light;  // the encoding clips
  return {srgb_encode(linear.x), srgb_encode(linear.y), srgb_encode(linear.z)};
}

}  // namespace

double automatic_exposure(std::span<const float> rgb) {
  constexpr double sun_disc = 5e5;
  const auto key_of = [&](double brightest) {
    double weights = 0, sum = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      const double luminance = 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
      if (!(luminance > 0 && luminance <= brightest)) continue;
      const double weight = std::sqrt(luminance);
      weights += weight;
      sum += weight * std::log2(luminance);
    }
    return weights > 0 ? std::exp2(sum / weights) : 0;
  };
  double key = key_of(sun_disc);
  if (key == 0) key = key_of(std::numeric_limits<double>::max());
  if (key == 0) return automatic_exposure_limit;
  return std::min(std::log2(0.25 * std::pow(key / (key + 10), 0.25) / key), automatic_exposure_limit);
}

void encode_row(std::span<const float> rgb, int y, double exposure_ev, ToneCurve curve, std::span<std::uint8_t> out) {
  const float gain = float(std::exp2(std::clamp(exposure_ev, -120.0, 120.0)));
  const std::size_t width = rgb.size() / 3;
  for (std::size_t first = 0; first < width; first += std::size_t(lanes)) {
    const std::size_t n = std::min(width - first, std::size_t(lanes));
    alignas(64) float channels[3][lanes] = {};
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < 3; ++c) channels[c][i] = rgb[3 * (first + i) + c];
    const auto load = [&](int c) { return Float::of(Rep::load_aligned(channels[c]) * Rep(gain)); };
    const Vec3 light(load(0), load(1), load(2));
    const Vec3 encoded = shown(light, curve);
    encoded.x.v.store_aligned(channels[0]);
    encoded.y.v.store_aligned(channels[1]);
    encoded.z.v.store_aligned(channels[2]);
    for (std::size_t i = 0; i < n; ++i) {
      const float dither = threshold(std::uint32_t(first + i), std::uint32_t(y));
      for (std::size_t c = 0; c < 3; ++c) out[3 * (first + i) + c] = std::uint8_t(channels[c][i] * 255.0f + dither);
    }
  }
}

}  // namespace airlight
