#pragma once
// What the machine can do: one operation over and over, enough of it that all else in the pass does not count. The operands of
// one step do not wait for the result of the step before: this is throughput, which is what marching many rays is bound by.

/// 256 exps [1].
FN Vec4 bench_exp_pass(Vec2 uv) {
  Vec4 x = Vec4(uv.x, uv.y, uv.x + uv.y, uv.x - uv.y);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 64; ++i) {
    sum = sum + exp(x);
    x = x - Vec4(0.06, 0.05, 0.04, 0.03);
  }
  return sum;
}

/// 256 divisions [1].
FN Vec4 bench_division_pass(Vec2 uv) {
  Vec4 x = Vec4(uv.x, uv.y, uv.x + uv.y, uv.x - uv.y) + Vec4(2.0);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 64; ++i) {
    sum = sum + Vec4(1.0) / x;
    x = x + Vec4(0.06, 0.05, 0.04, 0.03);
  }
  return sum;
}

/// 64 texels of four channels, one at a time: address, load, transpose [1].
FN Vec4 bench_fetch_pass(Table2 table, Vec2 uv) {
  Float column = uv.x * (0.5 * width_of(table));
  Float row = uv.y * (0.5 * height_of(table));
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 64; ++i) {
    sum = sum + fetch(table, column, row);
    column = column + 1.0;
    row = row + 0.5;  // halves are exact: float and double fetch the same texels
  }
  return sum;
}

/// 64 bilinear lookups, 256 texels: address, four loads and transposes, interpolation [1].
FN Vec4 bench_lookup_pass(Table2 table, Vec2 uv) {
  Vec2 at = Vec2(0.5 * uv.x, 0.5 * uv.y);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 64; ++i) {
    sum = sum + lookup(table, at);
    at = at + Vec2(0.0078, 0.0071);
  }
  return sum;
}
