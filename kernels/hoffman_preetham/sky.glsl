#pragma once
#include "core/picture.glsl"
#include "core/radiance.glsl"
#include "core/sun_direction.glsl"
#include "core/tables.glsl"
#include "hoffman_preetham/sunlight.glsl"
// The formula at every pixel: the renderer that the others are measured against, and the answers for rays.

/// What the air does to light of a path: the part that it leaves of it [1] and, returned, what it adds per sunlight [1/sr]; or the part of
/// this that a diagnostic view shows.
/// @param rayleigh_path [m] in 0..3e5
/// @param mie_path [m] in 0..3e5
/// @param one_minus_cos [1] in 0..2
/// @param sunlight [1] in 0..2
/// @param left [1]
/// @bound 1e-4 scale 10   as hoffman_preetham_inscatter
FN Vec3 hoffman_preetham_terms(IN(HoffmanPreetham) air, Float rayleigh_path, Float mie_path, Float one_minus_cos, Vec3 sunlight, OUT(Vec3) left) {
  Vec3 none = Vec3(Float(0.0), Float(0.0), Float(0.0));
  Vec3 depth = none;
  Vec3 light = hoffman_preetham_inscatter(air, rayleigh_path, mie_path, one_minus_cos, depth) * sunlight;
  left = hoffman_preetham_exp(depth);
  if (air.show > 0.5) {
    if (air.show < 1.5) {
      light = none;
      left = Vec3(Float(1.0), Float(1.0), Float(1.0));
    } else if (air.show < 2.5) {
      light = left * (1.0 / air.exposure);  // a display shows 1 as white
      left = none;
    } else if (air.show < 3.5) {
      light = none;
    } else if (air.show < 4.5) {
      left = none;
    } else {
      Float clear = exp(-air.fog_density * rayleigh_path);
      light = xyz(Vec4(air.fog_colour)) * (1.0 - clear);
      left = Vec3(clear, clear, clear);
    }
  }
  return light;
}

/// The sky in a direction, without the Sun's disc [1/sr]; what is left of light from space [1].
/// @param mu [1] in -1..1  cosine of the view's zenith angle
/// @param one_minus_cos [1] in 0..2
/// @param sunlight [1] in 0..2
/// @param left [1]
/// @bound 1e-4 scale 10   as hoffman_preetham_inscatter
FN Vec3 hoffman_preetham_dome_light(IN(HoffmanPreetham) air, Float mu, Float one_minus_cos, Vec3 sunlight, OUT(Vec3) left) {
  return hoffman_preetham_terms(air, hoffman_preetham_rayleigh_dome(air, mu), hoffman_preetham_mie_dome(air, mu), one_minus_cos, sunlight, left);
}

/// A colour as the hardware of 2002 kept it, where that is asked for [1].
/// @param x [1] in 0..1
/// @param gain [1] in 0.5..20  display value of 1
/// @bound 1.0 scale 1   which of two steps is nearer is a decision
FN Vec3 hoffman_preetham_kept(IN(HoffmanPreetham) air, Vec3 x, Float gain) {
  Vec3 kept = x;
  if (air.clamp8bit > 0.5) kept = Vec3(hoffman_preetham_8bit(x.x, gain), hoffman_preetham_8bit(x.y, gain), hoffman_preetham_8bit(x.z, gain));
  return kept;
}

/// A pixel with the Sun's disc, linear sRGB [cd/m^2].
/// @param sunlight [1] in 0..1
/// @param light [1/sr] in 0..1
/// @param one_minus_cos [1] in 0..1e-4
/// @param mu [1] in -1..1  cosine of the view's zenith angle
/// @bound 1e-3 scale 1e9   a soft edge, as wide as a millionth of what this test draws
FN Vec4 hoffman_preetham_shown(IN(Display) display, Vec3 sunlight, Vec3 light, Float one_minus_cos, Float mu) {
  Vec4 colour = Vec4(light.x, light.y, light.z, Float(0.0));
  Float reach = Float(display.disc_radius + display.disc_edge);
  Bool near = (2.0 * one_minus_cos < reach * reach) && (mu > 0.0);
  if (display.disc > 0.5) {
    if (any(near)) {
      Vec4 disc = disc_shape(Scalar4(0.0, 0.0, 0.0, 0.0), display.disc_radius, display.disc_edge, one_minus_cos) * Vec4(display.disc_gain);
      colour = colour + select(near, disc * Vec4(sunlight.x, sunlight.y, sunlight.z, Float(0.0)), Vec4(0.0));
    }
  }
  return display_colour(display, colour);
}

/// Sunlight at the ground, once a frame: a table of one texel [1].
FN Vec4 hoffman_preetham_sunlight_pass(IN(HoffmanPreetham) hoffman_preetham, IN(SunDirection) sun_direction, Vec2 uv) {
  Vec3 light = hoffman_preetham_sunlight(hoffman_preetham, Float(sun_direction.direction.z));
  return Vec4(light.x, light.y, light.z, 0.0 * uv.x);
}

/// A picture of the sky, linear sRGB [cd/m^2].
FN Vec4 hoffman_preetham_picture_pass(IN(HoffmanPreetham) hoffman_preetham, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 sunlight, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec3 arriving = xyz(Vec4(fetch_scalar(sunlight, 0, 0)));
  Float apart = one_minus_cos(view, sun);
  Vec3 left = arriving;
  Vec3 light = hoffman_preetham_dome_light(hoffman_preetham, view.z, apart, arriving, left);
  light = hoffman_preetham_kept(hoffman_preetham, light, Float(hoffman_preetham.exposure));
  return hoffman_preetham_shown(display, arriving, light, apart, view.z) * inside;
}

/// Light of a line of sight that ends at a distance, or of the sky where that is infinite [1/sr]; what it leaves of light from there [1].
/// @param view [1] in -0.577..0.577
/// @param distance [m] in 0..3e5
/// @param sun [1] in -0.577..0.577
/// @param sunlight [1] in 0..2
/// @param left [1]
/// @bound 1e-4 scale 10   as hoffman_preetham_inscatter
FN Vec3 hoffman_preetham_sight(IN(HoffmanPreetham) air, Vec3 view, Float distance, Vec3 sun, Vec3 sunlight, OUT(Vec3) left) {
  Bool sky = distance > 9.9e14;
  Float rayleigh = select(sky, hoffman_preetham_rayleigh_dome(air, view.z), distance);
  Float mie = select(sky, hoffman_preetham_mie_dome(air, view.z), distance);
  Vec3 light = hoffman_preetham_terms(air, rayleigh, mie, one_minus_cos(view, sun), sunlight, left);
  left = hoffman_preetham_kept(air, left, Float(1.0));
  return hoffman_preetham_kept(air, light, Float(air.exposure));
}

/// Light along rays as eyes and suns ask it: in front of what ends them, or of the sky [1/sr]; transmittance [1].
FN Vec4 hoffman_preetham_rays_pass(IN(HoffmanPreetham) hoffman_preetham, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 sun = Vec3(at.y, at.z, at.w);
  Vec3 left = sun;
  Vec3 light = hoffman_preetham_sight(hoffman_preetham, Vec3(eye.y, eye.z, eye.w), at.x, sun, hoffman_preetham_sunlight(hoffman_preetham, sun.z), left);
  transmittance = Vec4(left.x, left.y, left.z, Float(0.0));
  ground = Vec4(0.0);
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// The air before points in view, and the sky, by the formula at each [1/sr]; transmittance [1].
FN Vec4 hoffman_preetham_haze_pass(IN(HoffmanPreetham) hoffman_preetham, IN(Observer) observer, Table2 sunlight, Table2 points, Vec2 uv, OUT(Vec4) transmittance) {
  Vec4 sight = fetch_same(points, uv);
  Vec3 left = xyz(sight);
  Vec3 light = hoffman_preetham_sight(hoffman_preetham, xyz(sight), sight.w, Vec3(observer.sun.x, observer.sun.y, observer.sun.z), xyz(Vec4(fetch_scalar(sunlight, 0, 0))), left);
  transmittance = Vec4(left.x, left.y, left.z, Float(0.0));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// Skylight from one direction of the hemisphere (u) for one sun (v), times its weight, whatever the views show [1/sr].
FN Vec4 hoffman_preetham_sky_light_pass(IN(HoffmanPreetham) hoffman_preetham, Table2 suns, Vec2 uv) {
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Vec3 sun = sun_ahead(Vec3(at.y, at.z, at.w));
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0), sun.z, weight);
  Vec3 depth = view;
  Vec3 light = hoffman_preetham_inscatter(hoffman_preetham, hoffman_preetham_rayleigh_dome(hoffman_preetham, view.z), hoffman_preetham_mie_dome(hoffman_preetham, view.z), one_minus_cos(view, sun), depth);
  light = light * hoffman_preetham_sunlight(hoffman_preetham, sun.z) * weight;
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// Light that leaves land towards any eye [1/sr]: albedo / pi times the frame's one sunlight, and the wanted part of its one skylight, which
/// is that of level ground; the skylight that reaches it [1]. `places` and `normals` as core_surface_pass has them.
FN Vec4 hoffman_preetham_surface_pass(IN(HoffmanPreetham) hoffman_preetham, Table2 sunlight, Table2 skylight, Table2 places, Table2 normals, Table2 albedos, Vec2 uv, OUT(Vec4) from_sky) {
  Vec4 place = fetch_same(places, uv);
  Vec4 from_sun = Vec4(fetch_scalar(sunlight, 0, 0)) * (max(fetch_same(normals, uv).w, 0.0) * place.z);
  from_sky = Vec4(fetch_scalar(skylight, 0, 0)) * (place.w * hoffman_preetham.ambient);
  return fetch_same(albedos, uv) * (from_sun + from_sky) * 0.318309886183791;
}

/// Sunlight at the ground for the suns asked [1].
FN Vec4 hoffman_preetham_sun_irradiance_pass(IN(HoffmanPreetham) hoffman_preetham, Table2 suns, Vec2 uv) {
  Vec3 light = hoffman_preetham_sunlight(hoffman_preetham, fetch_same(suns, uv).w);
  return Vec4(light.x, light.y, light.z, Float(0.0));
}
