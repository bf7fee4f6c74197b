#pragma once
#include "core/radiance.glsl"
// Light scattered or reflected exactly once, by numerical integration along each ray. Any planet, any air.
// A ray is a texel of two tables: `eyes` (altitude, view) and `suns` (distance, direction of the Sun).

/// The air's radiance along rays [W m^-2 sr^-1 nm^-1]; the ray's transmittance; the ground's radiance, attenuated.
FN Vec4 single_rays_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 view = Vec3(eye.y, eye.z, eye.w);
  Vec3 sun = Vec3(at.y, at.z, at.w);
  Vec4 light = ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, eye.x, view, sun, at.x, transmittance, ground);
  ground = ground * Vec4(air.solar_irradiance);
  transmittance = ray_transmittance(air, zones, profile, eye.x, view, at.x);
  return light * Vec4(air.solar_irradiance);
}

/// Skylight from one direction of the hemisphere (u) for one observer (v), times its weight, per solar irradiance [1/sr].
FN Vec4 single_sky_light_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch(eyes, Float(0.0), floor(uv.y * height_of(eyes)));
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0), at.w, weight);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, eye.x, view, sun_ahead(Vec3(at.y, at.z, at.w)), Float(1.0e30), transmittance, ground) * weight;
}

/// A picture, linear sRGB [cd/m^2].
FN Vec4 single_picture_pass(IN(Air) air, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 optical_depth, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  Vec4 light = ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, Float(observer.altitude), view, sun, Float(1.0e30), transmittance, ground);
  light = light + ground;
  if (display.disc > 0.5) light = light + disc_radiance(air, observer, display, optical_depth, view, one_minus_cos(view, sun));
  return display_colour(display, light * Vec4(air.solar_irradiance)) * inside;
}
