#pragma once
#include "core/math.glsl"
// Where the table of scattered light keeps a place of Rama, and which place a texel is: fine near shores, lights, ground and strips.

/// Distance from the axis to the wall as the table takes it [km]: it changes at x = 0, though the cliff stands at x = -5.
/// @param x [km] in -25..24
FN Float rama_wall(Float x) { return 7.75 + clamp(x, -0.25, 0.25); }

/// Warped place along the axis [1], -24 to 24: ten-fold resolution around |x| = 5 and 16.
/// @param x [km] in -24.75..24
FN Float rama_x_warp(Float x) {
  // The southern plain is 500 m longer.
  Float v = select(x > 0.0, x, -x * (16.0 / 16.5));
  Float inner = v * (3.0 / 4.8);
  Float shore = 5.0 + (v - 5.0) * 10.0;
  Float plain = 7.0 + (v - 5.2) * (7.0 / 10.6);
  Float ends = 16.0 + (v - 16.0) * 10.0;
  Float cap = v * (6.0 / 7.8) + 24.0 * (1.8 / 7.8);
  // clamp(ends, clamp(shore, inner, plain), cap), as the source has it: its bounds may cross
  Float middle = min(max(shore, inner), plain);
  Float y = min(max(ends, middle), cap);
  return select(x > 0.0, y, -y);
}

/// Place along the axis of a warped one [km].
/// @param warped [1] in -24..24
FN Float rama_x_unwarp(Float warped) {
  Float y = abs(warped);
  Float v = select(y < 3.0, y * 1.6, select(y < 7.0, 4.8 + (y - 3.0) * 0.1, select(y < 14.0, 5.2 + (y - 7.0) * (10.6 / 7.0), select(y < 18.0, 15.8 + (y - 14.0) * 0.1, 16.2 + (y - 18.0) * 1.3))));
  return select(warped < 0.0, -v * (16.5 / 16.0), v);
}

/// Coordinates of a place in the table of 49 x 33 x 33 texels [1]: along the axis, from the wall to the axis, between lights.
/// @param p [km] in -7..7
/// @bound 1e-3 scale 1   on the wall, and at a light's angle, the roots keep half the digits
FN Vec3 rama_texture_coordinate(Vec3 p) {
  Float r = sqrt(p.y * p.y + p.z * p.z);
  // Beyond the wall the difference is negative: over the southern half of the sea, and by rounding.
  Float depth = sqrt(max(1.0 - r / rama_wall(p.x), 0.0));
  // Six mirrored wedges of 60 degrees.
  Float f = arc_tangent2(p.z, p.y) * 0.954929658551372;
  Float wedge = sqrt(abs(f - 2.0 * floor(0.5 * f + 0.5)));
  return Vec3(half_texel((rama_x_warp(p.x) + 24.0) * (1.0 / 48.0), 49.0), half_texel(depth, 33.0), half_texel(wedge, 33.0));
}

/// Place of a texel, given by its numbers along the three axes [km].
/// @param i [1] in 0..48
/// @param j [1] in 0..32
/// @param k [1] in 0..32
FN Vec3 rama_texel_point(Float i, Float j, Float k) {
  Float x = rama_x_unwarp(i - 24.0);
  Float depth = j * (1.0 / 32.0);
  Float wedge = k * (1.0 / 32.0);
  Float r = rama_wall(x) * (1.0 - depth * depth);
  Float phi = wedge * wedge * 1.04719755119660;
  return Vec3(x, r * cos(phi), r * sin(phi));
}
