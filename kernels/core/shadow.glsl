#pragma once
#include "core/geometry.glsl"
// Shadows that land casts into the air. A map over the land holds, for the one direction of the Sun, two altitudes [m]: x, below
// which all of the Sun's disc is hidden; y, above which all of it is seen. Between them, and outside the map, light is partial and
// full. So the air's light costs one lookup a point, on every engine, and no ray is cast towards the Sun. A texel also holds the
// altitudes of its neighbour on the u axis (z, w): two texels, not four, make a point between four.

struct Shadow {
  Scalar4 across;   // [1/m] in -1e-5..1e-5  map coordinate u of a point p, in the observer's frame: dot(across.xyz, p) + across.w
  Scalar4 along;    // [1/m] in -1e-5..1e-5  map coordinate v
  Scalar highest;   // [m] in 0..1e4   altitude above which all is lit
  Scalar steps;     // [1] in 1..64    points on a ray
  Scalar pad0;      // [1] in 0..1
  Scalar pad1;      // [1] in 0..1
};

/// The part of the Sun's disc that land leaves visible at a point [1].
/// @param point [m] from the observer, in the observer's frame
/// @param altitude [m] of the point
FN Float sun_share(IN(Shadow) shadow, Table2 shadow_map, Vec3 point, Float altitude) {
  Float u = dot(Vec3(shadow.across.x, shadow.across.y, shadow.across.z), point) + shadow.across.w;
  Float v = dot(Vec3(shadow.along.x, shadow.along.y, shadow.along.z), point) + shadow.along.w;
  Float x = clamp(u * width_of(shadow_map) - 0.5, 0.0, width_of(shadow_map) - 1.0);
  Float y = clamp(v * height_of(shadow_map) - 0.5, 0.0, height_of(shadow_map) - 1.0);
  Vec4 near_row = fetch(shadow_map, floor(x), floor(y));
  Vec4 edge = near_row + (fetch(shadow_map, floor(x), floor(y) + 1.0) - near_row) * (y - floor(y));
  Float dark = edge.x + (edge.z - edge.x) * (x - floor(x));
  Float lit = edge.y + (edge.w - edge.y) * (x - floor(x));
  Float share = clamp((altitude - dark) / max(lit - dark, 1.0e-3), 0.0, 1.0);
  Bool outside = (u < 0.0) || (u > 1.0) || (v < 0.0) || (v > 1.0);
  return select(outside, Float(1.0), share);
}

/// The stretch of a ray on which land may hide the Sun [m]: where it is lower than `highest`.
/// @param ground_radius [m] in 1e6..1e8 log
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param reach [m] in 0..1e6
/// @param begin [m]
/// @param end [m]
/// @bound 2e-5 scale 1e6
FN void shadowed_stretch(IN(Shadow) shadow, Scalar ground_radius, Float altitude, Float mu, Float reach, OUT(Float) begin, OUT(Float) end) {
  Float along = (ground_radius + altitude) * mu;
  Float low = clamp(-along, 0.0, reach);
  Float down = clamp(path_to_shell(ground_radius, altitude, along, Float(shadow.highest), 0), 0.0, low);
  Float up = clamp(path_to_shell(ground_radius, altitude, along, Float(shadow.highest), 1), low, reach);
  begin = select(altitude > shadow.highest, down, Float(0.0));
  end = select(altitude > shadow.highest, select(along < 0.0, up, Float(0.0)), up);
}
