#pragma once
#include "precomputed/seen.glsl"
// All orders of scattering: the first marched along each ray or from tables, the others from tables. A ray is a texel of `eyes` and `suns`, as in `single`.

struct March {
  Scalar panels;  // [1] in 3..64  of a ray, see precomputed_march
  Scalar pad0;    // [1] in 0..1
  Scalar pad1;    // [1] in 0..1
  Scalar pad2;    // [1] in 0..1
};

/// The air's radiance along rays [W m^-2 sr^-1 nm^-1]; the ground's radiance, attenuated.
FN Vec4 precomputed_rays_pass(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, IN(March) march, Table2 phases, Table2 layers, Table2 sunlit, Table2 sunlight, Table2 optical_depth, Table3 source, Table2 ground_light, Table3 seen, Table3 seen_peak, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 view = Vec3(eye.y, eye.z, eye.w);
  Vec3 sun = Vec3(at.y, at.z, at.w);
  Vec4 light = precomputed_ray_light(air, lattice, sight, march.panels, phases, layers, sunlit, sunlight, optical_depth, source, ground_light, seen, seen_peak, eye.x, view, sun, at.x, ground);
  ground = ground * Vec4(air.solar_irradiance);
  return light * Vec4(air.solar_irradiance);
}

/// Transmittance of rays [1].
FN Vec4 precomputed_transmittance_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch_same(eyes, uv);
  return ray_transmittance(air, zones, profile, eye.x, Vec3(eye.y, eye.z, eye.w), fetch_same(suns, uv).x);
}

/// Skylight from one direction of the hemisphere (u) for one observer (v), times its weight, per solar irradiance [1/sr].
FN Vec4 precomputed_sky_light_pass(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, IN(March) march, Table2 phases, Table2 layers, Table2 sunlit, Table2 sunlight, Table2 optical_depth, Table3 source, Table2 ground_light, Table3 seen, Table3 seen_peak, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch(eyes, Float(0.0), floor(uv.y * height_of(eyes)));
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0), at.w, weight);
  Vec4 ground = Vec4(0.0);
  return precomputed_ray_light(air, lattice, sight, march.panels, phases, layers, sunlit, sunlight, optical_depth, source, ground_light, seen, seen_peak, eye.x, view, sun_ahead(Vec3(at.y, at.z, at.w)), Float(1.0e30), ground) * weight;
}

/// A picture, linear sRGB [cd/m^2].
FN Vec4 precomputed_picture_pass(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, IN(March) march, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 phases, Table2 layers, Table2 sunlit, Table2 sunlight, Table2 optical_depth, Table3 source, Table2 ground_light, Table3 seen, Table3 seen_peak, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec4 ground = Vec4(0.0);
  Vec4 light = precomputed_ray_light(air, lattice, sight, march.panels, phases, layers, sunlit, sunlight, optical_depth, source, ground_light, seen, seen_peak, Float(observer.altitude), view, sun, Float(1.0e30), ground);
  light = light + ground;
  if (display.disc > 0.5) light = light + disc_radiance(air, observer, display, optical_depth, view, one_minus_cos(view, sun));
  return display_colour(display, light * Vec4(air.solar_irradiance)) * inside;
}
