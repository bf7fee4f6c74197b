#pragma once
// What the kernel language promises on every target, as functions and passes that only tests run.

struct Numbers {
  Scalar4 four;  // [1] in 0..1
  Scalar a;      // [1] in 0..1
  Scalar b;      // [1] in 0..1
  Scalar c;      // [1] in 0..1
  Scalar d;      // [1] in 0..1
};

/// The larger of two, the second where the first is NaN [1].
/// @param a [1] in -2..2
/// @param b [1] in -2..2
FN Float language_max(Float a, Float b) { return max(a, b); }

/// The smaller of two, the second where the first is NaN [1].
/// @param a [1] in -2..2
/// @param b [1] in -2..2
FN Float language_min(Float a, Float b) { return min(a, b); }

/// x between two bounds, the lower where x is NaN [1].
/// @param x [1] in -2..2
/// @param low [1] in -1..0
/// @param high [1] in 0..1
FN Float language_clamp(Float x, Float low, Float high) { return clamp(x, low, high); }

/// max, min and clamp of four components [1].
/// @param x [1] in -2..2
/// @param bound [1] in 0..1
FN Vec4 language_bounds4(Vec4 x, Float bound) { return max(x, -bound) + min(x, bound) + clamp(x, -bound, bound); }

/// Which comparisons hold: 1 for <, 2 for <=, 4 for >, 8 for >= [1].
/// @param a [1] in -2..2
/// @param b [1] in -2..2
FN Float language_compare(Float a, Float b) {
  return select(a < b, Float(1.0), Float(0.0)) + select(a <= b, Float(2.0), Float(0.0)) + select(a > b, Float(4.0), Float(0.0)) +
         select(a >= b, Float(8.0), Float(0.0));
}

/// Both above zero or both not [1].
/// @param a [1] in -2..2
/// @param b [1] in -2..2
FN Bool language_alike(Float a, Float b) { return (a > 0.0 && b > 0.0) || !(a > 0.0 || b > 0.0); }

/// One of two by a flag [1].
/// @param first [1] in 0..1
/// @param a [1] in -2..2
/// @param b [1] in -2..2
FN Vec4 language_select(Bool first, Vec4 a, Vec4 b) { return select(first, a, b); }

/// Work that any() may skip: what x has above 1 [1].
/// @param x [1] in 0..2
FN Float language_any(Float x) {
  Float above = Float(0.0);
  if (any(x > 1.0)) above = select(x > 1.0, x - 1.0, 0.0);
  return above;
}

/// Parts of a number: x = mantissa 2^exponent, and its floor [1].
/// @param x [1] in 1e-30..1e30 log
/// @param mantissa [1]
/// @param below [1]
FN Float language_parts(Float x, OUT(Float) mantissa, OUT(Float) below) {
  mantissa = mantissa_of(x);
  below = floor(x);
  return exponent_of(x);
}

/// A sum over a uniform count, with uniform numbers of every kind [1].
/// @param count [1] in 0..5
/// @param stride [1] in 0..1
/// @param weights [1] in 0..1
/// @param x [1] in -2..2
FN Float language_sum(int count, Scalar stride, Scalar4 weights, Float x) {
  Float sum = Float(weights.w);
  for (int i = 0; i < count; ++i) sum = sum + (x + Float(i) * stride) * weights.y;
  return sum;
}

/// How often the inner of two loops turns [1].
/// @param outer [1] in 1..100
/// @param inner [1] in 1..100
/// @param x [1] in 0..1
FN Float language_turns(int outer, int inner, Float x) {
  Float turns = Float(0.0) * x;
  for (int i = 0; i < outer; ++i) {
    for (int j = 0; j < inner; ++j) turns = turns + 1.0;
  }
  return turns;
}

/// Several results and no return value.
/// @param a [1] in -2..2
/// @param sum [1]
/// @param turned [1]
/// @param positive [1]
FN void language_outs(Vec2 a, OUT(Float) sum, OUT(Vec3) turned, OUT(Bool) positive) {
  sum = a.x + a.y;
  turned = Vec3(a.y, a.x, sum);
  positive = sum > 0.0;
}

// ---- passes: `places` has the pass's own shape and holds the coordinates to look up ----

/// Texels at whole-numbered places.
FN Vec4 language_fetch_pass(Table2 places, Table2 grid, Vec2 uv) {
  Vec4 at = fetch_same(places, uv);
  return fetch(grid, at.x, at.y);
}

/// Bilinear.
FN Vec4 language_lookup2_pass(Table2 places, Table2 grid, Vec2 uv) { return lookup(grid, xy(fetch_same(places, uv))); }

/// Bilinear in a table without end.
FN Vec4 language_repeat_pass(Table2 places, Table2 grid, Vec2 uv) { return lookup_repeat(grid, xy(fetch_same(places, uv))); }

/// Trilinear.
FN Vec4 language_lookup3_pass(Table2 places, Table3 grid, Vec2 uv) { return lookup(grid, xyz(fetch_same(places, uv))); }

/// Linear along the second row; cells of the third.
FN Vec4 language_rows_pass(Table2 places, Table2 grid, Vec2 uv, OUT(Vec4) cells) {
  Vec4 at = fetch_same(places, uv);
  cells = lookup_cell(grid, at.y, 2);
  return lookup_row(grid, at.x, 1);
}

/// A texel that all lanes share; the table's size.
FN Vec4 language_same_pass(Table2 grid, Vec2 uv, OUT(Vec4) size) {
  size = Vec4(width_of(grid) + Float(0.0), height_of(grid) + Float(0.0), uv.x, uv.y);
  return Vec4(fetch_scalar(grid, 2, 1));
}

/// Parameters as they arrive, in four outputs.
FN Vec4 language_parameters_pass(IN(Numbers) first, IN(Numbers) second, Vec2 uv, OUT(Vec4) rest, OUT(Vec4) second_four, OUT(Vec4) second_rest) {
  rest = Vec4(Float(first.a), Float(first.b), Float(first.c), Float(first.d));
  second_four = Vec4(second.four);
  second_rest = Vec4(Float(second.a), Float(second.b), Float(second.c), Float(second.d));
  return Vec4(first.four) + Vec4(0.0 * uv.x);
}

/// Coordinates of a volume's texels.
FN Vec4 language_volume_pass(Vec3 uvw, OUT(Vec4) twice) {
  twice = Vec4(2.0 * uvw.x, 2.0 * uvw.y, 2.0 * uvw.z, Float(2.0));
  return Vec4(uvw.x, uvw.y, uvw.z, Float(1.0));
}
