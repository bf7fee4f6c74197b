#pragma once
#include "realworldz/shell.glsl"
// A small planet's mountains, made of folded sines: something for fog to lie before.

/// Height of the ground in a direction from the planet's centre, as a part of the highest [1].
/// @param n [1] in -1..1
/// @bound 1e-3 scale 1   six octaves multiply an error of the direction by 400
FN_SHARED Float realworldz_relief(Vec3 n) {
  Vec3 q = n * 9.0;
  Float sum = Float(0.0);
  Float part = Float(0.5);
  for (int i = 0; i < 6; ++i) {
    Float fold = sin(q.x + 1.3 * sin(q.y)) * sin(q.y + 1.3 * sin(q.z)) + sin(q.z + 1.3 * sin(q.x)) * 0.5;
    Float ridge = 1.0 - min(abs(fold), 1.0);
    sum = sum + part * ridge * ridge;
    // Each octave turned against the last.
    q = Vec3(1.6 * q.x + 1.2 * q.y + 3.1, 1.6 * q.y - 1.2 * q.x + 0.3 * q.z, 2.0 * q.z - 0.3 * q.x + 1.7);
    part = part * 0.5;
  }
  Float peaks = clamp(1.3 * sum - 0.15, 0.0, 1.0);
  return peaks * peaks;
}

/// Distance along a ray to the ground [m]; negative where it meets none. The height met [m].
/// @param terrain [1] in 0..1  0: a smooth ball of the lowest ground
/// @param steps [1] in 16..64
/// @param viewer [m] in 4e4..5e4
/// @param d [1] in -0.577..0.577
/// @param height [m]
/// @bound 1.0 scale 1e7   which mountain a ray meets is a decision
FN_SHARED Float realworldz_trace(IN(Realworldz) rw, Scalar terrain, int steps, Vec3 viewer, Vec3 d, OUT(Float) height) {
  Float along = dot(viewer, d);
  Float square = dot(viewer, viewer) - along * along;  // of the line's distance from the centre
  Float low = sqrt(max(rw.ground_radius * rw.ground_radius - square, 0.0));
  Float high = sqrt(max(rw.bounding_radius * rw.bounding_radius - square, 0.0));
  Bool meets_ball = (square < rw.ground_radius * rw.ground_radius) && (-along - low >= 0.0);
  height = Float(0.0);
  Float result = select(meets_ball, -along - low, Float(-1.0));
  if (terrain > 0.5) {
    // Between the entry into the sphere of the highest peaks and the exit from it, or the lowest ground.
    Float t = max(-along - high, 0.0);
    Float end = select(meets_ball, -along - low, high - along);
    Bool passes = (square < rw.bounding_radius * rw.bounding_radius) && (end > 0.0);
    Float found = Float(-1.0);
    Float last = t;
    for (int i = 0; i < steps; ++i) {
      Vec3 p = viewer + d * t;
      Float above = sqrt(dot(p, p)) - rw.ground_radius - rw.relief * realworldz_relief(realworldz_unit(p));
      Bool under = passes && (above <= 0.0) && (found < 0.0) && (t < end);
      found = select(under, t, found);
      last = select(found < 0.0, t, last);
      // Slopes are below 45 degrees but for the finest folds: 0.6 of the height is safe enough; far away a pixel is wide.
      Float stride = max(0.6 * above, 5.0 + 0.002 * t);
      t = select(found < 0.0, min(t + stride, end), t);
    }
    // Between the last place above ground and the first below.
    Float outside = last;
    Float within = found;
    for (int j = 0; j < 6; ++j) {
      Float middle = 0.5 * (outside + within);
      Vec3 p = viewer + d * middle;
      Bool below = sqrt(dot(p, p)) - rw.ground_radius <= rw.relief * realworldz_relief(realworldz_unit(p));
      within = select(below, middle, within);
      outside = select(below, outside, middle);
    }
    result = select(passes, select(found >= 0.0, within, result), Float(-1.0));
    Vec3 q = viewer + d * max(result, 0.0);
    height = max(sqrt(dot(q, q)) - rw.ground_radius, 0.0);
  }
  return result;
}

/// Normal of the ground at a place [1].
/// @param terrain [1] in 0..1
/// @param x [m] in 3e4..4e4
/// @bound 1.0 scale 1   differences of heights 40 m apart
FN Vec3 realworldz_normal(IN(Realworldz) rw, Scalar terrain, Vec3 x) {
  Vec3 up = realworldz_unit(x);
  Vec3 normal = up;
  if (terrain > 0.5) {
    Float apart = Float(40.0);
    Float r = sqrt(dot(x, x));
    Float here = realworldz_relief(up);
    Vec3 rise = Vec3(realworldz_relief(realworldz_unit(x + Vec3(apart, Float(0.0), Float(0.0)))) - here,
                     realworldz_relief(realworldz_unit(x + Vec3(Float(0.0), apart, Float(0.0)))) - here,
                     realworldz_relief(realworldz_unit(x + Vec3(Float(0.0), Float(0.0), apart))) - here) * (rw.relief / apart);
    normal = realworldz_unit(up - rise + up * dot(rise, up));
  }
  return normal;
}
