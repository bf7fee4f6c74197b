#pragma once
#include "core/phase.glsl"
#include "core/tables.glsl"
#include "realworldz/shell.glsl"
// RealWorldz' sky: colours from a painted table over the angle from the Sun and the air's optical depth, over stars.

/// Optical depth of one leg of a ray, from its lowest point outwards [1]: dense there, three-point Gauss in 24 parts.
/// `gap` is the squared radius of that point less the ground's, `slope` its radius times the cosine of the angle to the vertical there.
/// `densities`: one row, from the ground to the top, relative to `density`; read where the air is painted.
FN_SHARED Float realworldz_leg(IN(Realworldz) rw, Table2 densities, Float gap, Float slope, Float length) {
  Float sum = Float(0.0);
  for (int i = 0; i < 72; ++i) {
    Vec2 point = gauss_three(i);
    Float u = (Float(i / 3) + point.x) * (1.0 / 24.0);
    Float s = length * u * u;
    Float k = gap + s * (2.0 * slope + s);
    Float height = max(k / (sqrt(max(rw.ground_radius * rw.ground_radius + k, 0.0)) + rw.ground_radius), 0.0);
    Float dense = Float(0.0);
    if (rw.painted > 0.5) {
      dense = lookup_row(densities, height * (1.0 / max(rw.top_radius - rw.ground_radius, 1.0)), 0).x;
    } else {
      dense = exp(-height * (1.0 / rw.scale_height));
    }
    sum = sum + point.y * u * dense;
  }
  return sum * length * (rw.density * (2.0 / 24.0));
}

/// Optical depth of the sky's air in a direction, up to its top or the ground [1]; `mu` is the cosine of the angle to the vertical.
FN Float realworldz_sky_depth(IN(Realworldz) rw, Table2 densities, Float altitude, Float mu) {
  Float above = max(altitude, 0.0);
  Float gap = above * (2.0 * rw.ground_radius + above);
  Float along = -mu * (rw.ground_radius + above);  // to the lowest point
  Float top = (rw.top_radius - rw.ground_radius) * (rw.top_radius + rw.ground_radius) + 0.0 * above;
  Bool down = along > 0.0;
  Float low = gap - along * along;  // gap of the lowest point of the whole line
  Bool hits = down && (low < 0.0);
  Bool misses = (gap > top) && (!down || (low > top));
  // The leg that lies before the lowest point, or before the ground: from there back to the viewer or to where the ray comes in.
  Float half_chord = sqrt(max(top - low, 0.0));
  Float to_ground = sqrt(max(-low, 0.0));
  Float back = min(along, half_chord);
  Float before = select(hits, back - to_ground, select(down, back, 0.0));
  Float first = realworldz_leg(rw, densities, select(hits, Float(0.0), max(low, 0.0)), select(hits, to_ground, 0.0), max(before, 0.0));
  // The leg after it.
  Float after = select(hits, Float(0.0), half_chord + min(along, 0.0));
  Float second = realworldz_leg(rw, densities, select(down, max(low, 0.0), gap), select(down, 0.0, -along), max(after, 0.0));
  return select(misses, Float(0.0), first + second);
}

/// Horizontal coordinate of the colour table [1]: a quarter of |sun - view|^2, which is sin^2 of half the angle.
/// @param one_minus_cos [1] in 0..2
FN Float realworldz_sky_u(Float one_minus_cos) { return 0.5 * one_minus_cos; }

/// Sky over stars, through fog [1]. Alpha of the sky: 1 hides the stars; of the stars: 0 adds them at full strength even by day.
/// @param air [1] in 0..1
/// @param stars [1] in 0..1
/// @param extinction [1] in 0..1
/// @param inscatter [1] in 0..1
FN Vec4 realworldz_fragment(Vec4 air, Vec4 stars, Vec4 extinction, Vec4 inscatter) {
  return (air + stars * (1.0 - air.w * stars.w)) * extinction + inscatter;
}

// ---- rings: what the air does is known on 65 rings of equal latitude, dense at the horizon, and linear in between ----

/// Latitude of a ring [quarter turns].
/// @param ring [1] in 0..64
FN Float realworldz_latitude(Float ring) {
  Float w = ring * (1.0 / 32.0) - 1.0;
  return w * abs(w);
}

/// Rings around a latitude [1]: x: the lower one, y: how far to the next.
/// @param latitude [1] in -1..1
/// @bound 5e-2 scale 32   at the horizon rings lie close and their root has half the digits
FN Vec2 realworldz_ring(Float latitude) {
  Float root = sqrt(abs(latitude));
  Float ring = clamp(floor(32.0 + 32.0 * select(latitude < 0.0, -root, root)), 0.0, 63.0);
  Float low = realworldz_latitude(ring);
  return Vec2(ring, clamp((latitude - low) / (realworldz_latitude(ring + 1.0) - low), 0.0, 1.0));
}

/// Transmittance of the sky's air on the rings around a viewer [1].
FN Float realworldz_rings(IN(Realworldz) rw, Table2 densities, Float altitude, Float ring) {
  return exp(-realworldz_sky_depth(rw, densities, altitude, sin(realworldz_latitude(ring) * 1.57079632679490)));
}

/// Optical depth of the sky's air for eyes (x: altitude [m]) in directions (w: cosine of the angle to the vertical) [1].
FN Vec4 realworldz_depth_pass(IN(Realworldz) rw, Table2 densities, Table2 eyes, Vec2 uv) {
  Vec4 eye = fetch_same(eyes, uv);
  return Vec4(realworldz_sky_depth(rw, densities, eye.x, eye.w));
}
