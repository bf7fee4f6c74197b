#pragma once
// Functions that drivers get wrong or that cancel, as our own polynomials, the same for every target.

/// Natural logarithm [1]; 0 and below give -87.3 (the smallest normal float), so that exp of it is 0 in effect.
/// @param x [1] in 1e-30..1e30 log
/// @bound 2e-5 scale 1
FN Float ln(Float x) {
  Float y = max(x, 1.1754944e-38);
  Float m = mantissa_of(y);
  Float e = exponent_of(y);
  // ln m = 2 artanh(z), z = (m - 1) / (m + 1), with m folded to [1/sqrt 2, sqrt 2): |z| < 0.1716, the next term is 3e-9.
  Bool high = m > 1.41421356;
  m = select(high, 0.5 * m, m);
  e = select(high, e + 1.0, e);
  Float z = (m - 1.0) / (m + 1.0);
  Float q = z * z;
  Float series = 2.0 * z * (1.0 + q * (0.333333333 + q * (0.2 + q * (0.142857143 + q * 0.111111111))));
  return e * 0.693147181 + series;
}

/// x to the power y [1], for x >= 0; 0 gives 0 for positive y.
/// @param x [1] in 1e-6..1e3 log  0 and NaN count as the smallest normal float, whose powers below -1 leave float's range
/// @param y [1] in -1..2
/// @bound 2e-5 scale 1   error grows as 1e-7 times the result's logarithm
FN Float power(Float x, Float y) { return exp(y * ln(x)); }

/// Natural logarithm of each component [1].
/// @param x [1] in 1e-30..1e30 log
FN Vec4 ln4(Vec4 x) { return Vec4(ln(x.x), ln(x.y), ln(x.z), ln(x.w)); }

/// x to the power of each component of y [1], for x >= 0.
/// @param x [1] in 1e-6..1e3 log
/// @param y [1] in -1..2  as power
/// @bound 2e-5 scale 1   as power
FN Vec4 power4(Float x, Vec4 y) { return exp(ln(x) * y); }

/// 1 - exp(-x) without cancellation for small x [1].
/// @param x [1] in 0..40
/// @bound 2e-5 scale 1e-6
FN Float one_minus_exp(Float x) {
  // Taylor to x^6 below 0.35, where its next term is 1e-7 of the value.
  Float t = x * (1.0 - x * (0.5 - x * (0.166666667 - x * (0.0416666667 - x * (0.00833333333 - x * 0.00138888889)))));
  return select(abs(x) < 0.35, t, 1.0 - exp(-x));
}

/// Angle whose cosine is c [rad]; c is clamped to [-1, 1].
/// @param c [1] in -1..1
/// @bound 2e-5 scale 1e-2   near c = 1 the angle is sqrt(2 (1 - c)): half the relative error of 1 - c
FN Float arc_cosine(Float c) {
  Float x = clamp(c, -1.0, 1.0);
  Float a = abs(x);
  // acos(a) = sqrt(1 - a) * polynomial; Chebyshev fit, relative error 2e-8 (form: Abramowitz & Stegun 4.4.46).
  Float p = -0.0012370049;
  p = p * a + 0.0065808852;
  p = p * a - 0.0169654720;
  p = p * a + 0.0308082534;
  p = p * a - 0.0501450250;
  p = p * a + 0.0889740993;
  p = p * a - 0.2145984942;
  p = p * a + 1.5707963018;
  Float angle = sqrt(1.0 - a) * p;
  return select(x < 0.0, 3.14159265358979 - angle, angle);
}

/// Angle of the point (x, y) from the x axis, in -pi..pi [rad]; (0, 0) gives 0.
/// @param y [1] in -1..1
/// @param x [1] in -1..1
/// @bound 2e-5 scale 1
FN Float arc_tangent2(Float y, Float x) {
  Float ax = abs(x);
  Float ay = abs(y);
  Float big = max(ax, ay);
  Float z = min(ax, ay) / max(big, 1.0e-37);
  // arctan on [0, 1]: z times a polynomial in z^2, absolute error 1.2e-8 before rounding.
  Float q = z * z;
  Float p = 0.0028340643;
  p = p * q - 0.0160050305;
  p = p * q + 0.0425876075;
  p = p * q - 0.0749544544;
  p = p * q + 0.1063675410;
  p = p * q - 0.1420257051;
  p = p * q + 0.1999248358;
  p = p * q - 0.3333306678;
  p = p * q + 0.9999999842;
  Float angle = p * z;
  angle = select(ay > ax, 1.57079632679490 - angle, angle);
  angle = select(x < 0.0, 3.14159265358979 - angle, angle);
  return select(y < 0.0, -angle, angle);
}

/// Smooth step from 0 at a to 1 at b (a may be larger than b) [1].
/// @param a [1] in -2..-1
/// @param b [1] in 1..2
/// @param x [1] in -3..3
FN Float smooth_step(Scalar a, Scalar b, Float x) {
  Float t = clamp((x - a) * (1.0 / (b - a)), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Table coordinate of u in 0..1 such that 0 and 1 hit the centres of the first and the last of n texels [1].
/// @param u [1] in 0..1
/// @param n [1] in 2..1024
FN Float half_texel(Float u, Scalar n) { return (0.5 + u * (n - 1.0)) * (1.0 / n); }

/// Inverse of half_texel, clamped to 0..1 [1].
/// @param t [1] in 0..1
/// @param n [1] in 2..1024
FN Float from_half_texel(Float t, Scalar n) { return clamp((t * n - 0.5) * (1.0 / (n - 1.0)), 0.0, 1.0); }

/// The three points of Gauss's rule on 0..1, again and again [1]: x: where the i-th is in its part, y: its weight.
/// @param i [1] in 0..71
FN Vec2 gauss_three(int i) {
  int third = i - 3 * (i / 3);
  Vec2 point = Vec2(Float(0.112701665379258), Float(5.0 / 18.0));
  if (third == 1) point = Vec2(Float(0.5), Float(4.0 / 9.0));
  if (third == 2) point = Vec2(Float(0.887298334620742), Float(5.0 / 18.0));
  return point;
}
