#pragma once
#include "core/math.glsl"
// The tone curve of codeflow.org's program: S. Hill's fit of the Academy's reference and output transforms, with a gamma of 2.2.

/// One channel of the curve, between its two matrices [1].
/// @param x [1] in 0..100
FN Float codeflow_tone_channel(Float x) {
  return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081);
}

/// Exposed linear sRGB as the display shows it, encoded [1].
/// @param rgb [1] in 0..20
/// @bound 1e-4 scale 1   the power 1 / 2.2 is steep at black
FN Vec3 codeflow_tone(Vec3 rgb) {
  // The curve turns back and has poles below 0, and squares overflow far above: the light is held between.
  Float r = clamp(rgb.x, 0.0, 1.0e6);
  Float g = clamp(rgb.y, 0.0, 1.0e6);
  Float b = clamp(rgb.z, 0.0, 1.0e6);
  Float x = codeflow_tone_channel(0.59719 * r + 0.35458 * g + 0.04823 * b);
  Float y = codeflow_tone_channel(0.07600 * r + 0.90834 * g + 0.01566 * b);
  Float z = codeflow_tone_channel(0.02840 * r + 0.13383 * g + 0.83777 * b);
  Vec3 shown = Vec3(1.60475 * x - 0.53108 * y - 0.07367 * z, 1.10813 * y - 0.10208 * x - 0.00605 * z, 1.07602 * z - 0.00327 * x - 0.07276 * y);
  return Vec3(power(clamp(shown.x, 0.0, 1.0), 0.454545455), power(clamp(shown.y, 0.0, 1.0), 0.454545455), power(clamp(shown.z, 0.0, 1.0), 0.454545455));
}
