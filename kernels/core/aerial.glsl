#pragma once
#include "core/dome.glsl"
#include "core/march.glsl"
#include "core/picture.glsl"
#include "core/shadow.glsl"
// Aerial perspective: what the air adds and takes between an observer and any point in view, from 3-D tables over direction (u, v,
// a dome) and distance (w). A texel holds the mean along its path, light or optical depth per metre: smooth down to no distance, and
// near things get as many digits as far ones. Peaked phase functions are applied at the pixel.

/// Place on the third axis of a path inside the air [1]: dense near the observer.
/// @param reach [m] in 1..1e6 log
/// @param whole [m] in 1e6..2e6
/// @param depth [1] in 2..64
FN Float aerial_w(Float reach, Float whole, Scalar depth) {
  return half_texel(sqrt(clamp(reach / max(whole, 1.0e-3), 0.0, 1.0)), depth);
}
/// The path at a place on the third axis [m]; at its beginning a short one, for the mean.
/// @param w [1] in 0..1
/// @param whole [m] in 0..2e6
/// @param depth [1] in 2..64
/// @bound 2e-5 scale 1e6
FN Float aerial_reach(Float w, Float whole, Scalar depth) {
  Float root = max(from_half_texel(w, depth), 1.0e-3);
  return root * root * whole;
}

/// The ray of a place in the tables: where it meets the air (as meet_air says), and the path it stands for [m].
/// @param uvw [1] in 0..1
/// @param reach [m]
/// @bound 1 scale 1e30   meet_air's
FN Vec4 aerial_ray(IN(Air) air, IN(Observer) observer, IN(Dome) froxels, Vec3 uvw, OUT(Float) reach) {
  Vec3 view = dome_view(froxels.horizon, Vec2(uvw.x, uvw.y), froxels.width, froxels.height);
  Vec3 sun = Vec3(Float(sqrt(max(1.0 - observer.sun.z * observer.sun.z, 0.0))), Float(0.0), Float(observer.sun.z));
  Float whole = Float(0.0);
  Bool hits = whole > 1.0;
  Vec4 at = meet_air(air, Float(observer.altitude), view, sun, Float(1.0e30), reach, whole, hits);
  reach = aerial_reach(uvw.z, whole, froxels.depth);
  return at;
}

/// Light of the first order gathered along a path [1/sr]: the classes' tables under their phase functions, `phase0` to `phase3`.
FN Vec4 gathered_to(IN(Air) air, IN(Dome) froxels, Table3 class0, Table3 class1, Table3 class2, Table3 class3, Vec4 phase0, Vec4 phase1,
                    Vec4 phase2, Vec4 phase3, Vec2 uv, Float path, Float whole) {
  Vec3 place = Vec3(uv.x, uv.y, aerial_w(path, whole, froxels.depth));
  Vec4 light = lookup(class0, place) * phase0;
  if (air.classes > 1.5) light = light + lookup(class1, place) * phase1;
  if (air.classes > 2.5) light = light + lookup(class2, place) * phase2;
  if (air.classes > 3.5) light = light + lookup(class3, place) * phase3;
  return light * path;
}

/// Light of the first order along a path [1/sr], without (the result) and with the shadows of land, which take what is gathered
/// between points as far as the Sun is hidden halfway between them.
/// @param offset [1] in 0..1  where "halfway" is: spreads over pixels what few points would leave in steps
FN_SHARED Vec4 shadowed_light(IN(Air) air, IN(Dome) froxels, IN(Shadow) shadow, IN(Observer) observer, Table3 class0, Table3 class1, Table3 class2,
                              Table3 class3, Table2 phases, Table2 shadow_map, Vec3 view, Float offset, Vec4 at, Vec2 uv, Float reach,
                              Float whole, OUT(Vec4) shadowed) {
  // Not from at.w, the cosine: floats cancel in the aureole.
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Float x = sqrt(clamp(0.5 * one_minus_cos(view, sun), 0.0, 1.0));
  Vec4 phase0 = lookup_row(phases, x, 0);
  Vec4 phase1 = phase0;
  Vec4 phase2 = phase0;
  Vec4 phase3 = phase0;
  if (air.classes > 1.5) phase1 = lookup_row(phases, x, 1);
  if (air.classes > 2.5) phase2 = lookup_row(phases, x, 2);
  if (air.classes > 3.5) phase3 = lookup_row(phases, x, 3);
  Vec4 all = gathered_to(air, froxels, class0, class1, class2, class3, phase0, phase1, phase2, phase3, uv, reach, whole);
  Float begin = Float(0.0);
  Float end = Float(0.0);
  shadowed_stretch(shadow, air.ground_radius, at.x, at.y, reach, begin, end);
  shadowed = all;
  if (any(end > begin)) {
    Float skipped = (air.ground_radius + at.x) * at.y - (air.ground_radius + observer.altitude) * view.z;
    Float root = sqrt(begin);
    Float stride = (sqrt(max(end, begin)) - root) * (1.0 / shadow.steps);
    // The sum of (hidden part) x (light gathered over a step), by parts: light is asked for only where the hidden part changes.
    Vec4 lost = Vec4(0.0);
    Float hidden = Float(0.0);
    int steps = int(shadow.steps);
    for (int i = 0; i < steps; ++i) {
      Float near_end = root + Float(i) * stride;
      Float halfway = near_end + offset * stride;
      Float middle = halfway * halfway;
      Float altitude = altitude_along(air.ground_radius, at.x, at.y, middle);
      Float before = hidden;
      hidden = 1.0 - sun_share(shadow, shadow_map, view * (skipped + middle), altitude);
      Float change = before - hidden;
      if (any(abs(change) > 0.0)) lost = lost + gathered_to(air, froxels, class0, class1, class2, class3, phase0, phase1, phase2, phase3, uv, near_end * near_end, whole) * change;
    }
    Float far_end = root + shadow.steps * stride;
    if (any(hidden > 0.0)) lost = lost + gathered_to(air, froxels, class0, class1, class2, class3, phase0, phase1, phase2, phase3, uv, far_end * far_end, whole) * hidden;
    shadowed = max(all - lost, 0.0);
  }
  return all;
}
