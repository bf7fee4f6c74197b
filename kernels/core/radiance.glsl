#pragma once
#include "core/picture.glsl"
#include "core/tables.glsl"
// The four questions, answered by marching: what `single` is, and what `skyview` falls back to where its tables do not hold.

/// Place of the Sun's zenith cosine in the one-row table `ground_light` [1].
/// @param mu_s [1] in -1..1
FN Float ground_light_u(Float mu_s) {
  Float root = sqrt(abs(mu_s));
  return 0.5 + 0.5 * select(mu_s < 0.0, -root, root);
}

/// Radiance of the ground at the end of a ray, not yet attenuated, per solar irradiance [1/sr].
FN Vec4 ground_radiance(IN(Air) air, Table2 sunlight, Table2 ground_light, int orders, Float altitude, Float mu_s, Float nu, Float reach) {
  Float sun_below = ((air.ground_radius + altitude) * mu_s + reach * nu) * (1.0 / air.ground_radius);
  Vec4 arriving = sunlight_at(air, sunlight, Float(0.0), sun_below) * max(sun_below, 0.0);
  if (orders > 1) arriving = arriving + exp(-lookup_row(ground_light, ground_light_u(sun_below), 0));
  return arriving * Vec4(air.albedo) * 0.318309886183791;
}

/// What a view ray brings, per solar irradiance [1/sr]: the air's part; transmittance of the whole ray; light reflected by the
/// ground where the ray meets it, already attenuated.
FN_SHARED Vec4 ray_light(IN(Air) air, int orders, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple,
                  Table2 ground_light, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float mu_s = Float(0.0);
  Float nu = Float(0.0);
  Float reach = Float(0.0);
  Bool hits = reach > 1.0;
  meet_air(air, altitude, view, sun, distance, start, mu, mu_s, nu, reach, hits);
  Vec4 class0 = Vec4(0.0);
  Vec4 class1 = Vec4(0.0);
  Vec4 class2 = Vec4(0.0);
  Vec4 class3 = Vec4(0.0);
  Vec4 diffuse = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  gather_light(air, orders, zones, profile, sunlight, multiple, start, mu, mu_s, nu, reach, class0, class1, class2, class3, diffuse, depth);
  transmittance = exp(-depth);
  ground = Vec4(0.0);
  if (any(hits)) ground = select(hits, ground_radiance(air, sunlight, ground_light, orders, start, mu_s, nu, reach) * transmittance, Vec4(0.0));
  return diffuse + apply_phases(air, phases, one_minus_cos(view, sun), class0, class1, class2, class3);
}

/// Transmittance of a view ray [1], by an integral of its own with three points a zone: it is held to 1e-5.
FN Vec4 ray_transmittance(IN(Air) air, Table2 zones, Table2 profile, Float altitude, Vec3 view, Float distance) {
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float mu_s = Float(0.0);
  Float nu = Float(0.0);
  Float reach = Float(0.0);
  Bool hits = reach > 1.0;
  meet_air(air, altitude, view, view, distance, start, mu, mu_s, nu, reach, hits);
  return exp(-optical_depth_along(air, zones, profile, start, mu, reach));
}

/// Sunlight normal to the beam at an observer, who may be in space, relative to that outside the atmosphere [1].
FN Vec4 sunlight_from(IN(Air) air, Table2 sunlight, Float altitude, Vec3 sun) {
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float skipped = enter_atmosphere(air.ground_radius, air.top_altitude, altitude, sun, start, mu);
  return select(skipped < 0.0, Vec4(1.0), sunlight_at(air, sunlight, start, mu));
}

/// Skylight on a horizontal plane that faces up, per solar irradiance [1]: 16 rings x 32 directions of equal weight.
FN_SHARED Vec4 sky_irradiance_at(IN(Air) air, int orders, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple,
                          Float altitude, Vec3 sun) {
  Vec4 sum = Vec4(0.0);
  for (int ring = 0; ring < 16; ++ring) {
    Float sin_squared = (Float(ring) + 0.5) * (1.0 / 16.0);
    Float z = sqrt(1.0 - sin_squared);
    Float across = sqrt(sin_squared);
    for (int i = 0; i < 32; ++i) {
      Float azimuth = (Float(i) + 0.5) * 0.196349540849362;
      Vec3 view = Vec3(across * cos(azimuth), across * sin(azimuth), z);
      Vec4 transmittance = Vec4(0.0);
      Vec4 ground = Vec4(0.0);
      sum = sum + ray_light(air, orders, zones, profile, phases, sunlight, multiple, sunlight, altitude, view, sun, Float(1.0e30), transmittance, ground);
    }
  }
  return sum * (3.14159265358979 / 512.0);
}
