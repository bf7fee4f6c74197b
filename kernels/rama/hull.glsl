#pragma once
#include "rama/air.glsl"
// Rama's inside as rays meet it: northern cap and plain, sea, cliff, southern plain and cap.

/// Distance from a place inside a sphere or cylinder to where a ray leaves it [km], by the numbers of a t^2 + 2 b t + c = 0.
/// @param a [1] in 1e-3..1
/// @param b [km] in -8..8
/// @param c [km^2] in -64..-1
FN Float rama_exit(Float a, Float b, Float c) {
  // Along the axis a ray never leaves the cylinder.
  Float slope = max(a, 1.0e-9);
  Float root = sqrt(max(b * b - slope * c, 0.0));
  return select(b > 0.0, max(-c, 0.0) / max(b + root, 1.0e-9), (root - b) / slope);
}

/// Nearest of two distances, the second counting where it is a hit before the first [km].
/// @param nearest [km] in 0..60
/// @param t [km] in 0..60
/// @param hit [1] in 0..1
FN Float rama_nearer(Float nearest, Float t, Bool hit) { return select(hit && (t < nearest), t, nearest); }

/// Distance to the hull [km]; its normal, inwards.
/// @param p [km] in -4..4
/// @param d [1] in -0.577..0.577
/// @param normal [1]
/// @bound 1.0 scale 1e7   where two parts of the hull meet, rounding decides for one
FN_SHARED Float rama_hull(Vec3 p, Vec3 d, OUT(Vec3) normal) {
  Float across = d.y * d.y + d.z * d.z;
  Float outward = p.y * d.y + p.z * d.z;
  Float square = rama_square(p);
  // Whatever rounding makes of the rest, a ray ends.
  Float t = Float(60.0);
  Float wide = rama_exit(across, outward, square - 64.0);
  Float x = p.x + wide * d.x;
  Bool on_wide = (x >= -5.0) && (x <= 16.0);
  t = rama_nearer(t, wide, on_wide);
  Float narrow = rama_exit(across, outward, square - 56.25);
  x = p.x + narrow * d.x;
  Bool on_narrow = (x >= -16.5) && (x < -5.0);
  t = rama_nearer(t, narrow, on_narrow);
  Float north = rama_exit(Float(1.0), outward + (p.x - 16.0) * d.x, square + (p.x - 16.0) * (p.x - 16.0) - 64.0);
  Bool on_north = p.x + north * d.x > 16.0;
  t = rama_nearer(t, north, on_north);
  Float south = rama_exit(Float(1.0), outward + (p.x + 16.5) * d.x, square + (p.x + 16.5) * (p.x + 16.5) - 56.25);
  Bool on_south = p.x + south * d.x < -16.5;
  t = rama_nearer(t, south, on_south);
  Float cliff = (-5.0 - p.x) / select(d.x < -1.0e-9, d.x, -1.0e-9);
  Vec3 q = p + d * cliff;
  Bool on_cliff = (d.x < -1.0e-9) && (p.x > -5.0) && (rama_square(q) > 56.25) && (cliff <= t);
  t = rama_nearer(t, cliff, on_cliff);

  q = p + d * t;
  Float centre = select(q.x > 16.0, Float(16.0), select(q.x < -16.5, Float(-16.5), q.x));
  Vec3 radial = Vec3(q.x - centre, q.y, q.z);
  normal = radial * (-1.0 / max(sqrt(dot(radial, radial)), 1.0e-6));
  if (any(on_cliff)) normal = select(on_cliff && (cliff <= t), Vec3(1.0, 0.0, 0.0), normal);
  return t;
}
