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
FN Vec4 ground_radiance(IN(Air) air, Table2 sunlight, Table2 ground_light, int orders, Vec4 at, Float reach) {
  Float sun_below = ((air.ground_radius + at.x) * at.z + reach * at.w) * (1.0 / air.ground_radius);
  Vec4 arriving = sunlight_at(air, sunlight, Float(0.0), sun_below) * max(sun_below, 0.0);
  if (orders > 1) arriving = arriving + exp(-lookup_row(ground_light, ground_light_u(sun_below), 0));
  return arriving * Vec4(air.albedo) * 0.318309886183791;
}

/// What a view ray brings, per solar irradiance [1/sr]: the air's part; transmittance of the whole ray; light reflected by the
/// ground where the ray meets it, already attenuated.
FN_SHARED Vec4 ray_light(IN(Air) air, int orders, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple,
                  Table2 ground_light, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, distance, reach, whole, hits);
  Vec4 class0 = Vec4(0.0);
  Vec4 class1 = Vec4(0.0);
  Vec4 class2 = Vec4(0.0);
  Vec4 class3 = Vec4(0.0);
  Vec4 diffuse = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  gather_light(air, orders, zones, profile, sunlight, multiple, at, reach, class0, class1, class2, class3, diffuse, depth);
  transmittance = exp(-depth);
  ground = Vec4(0.0);
  if (any(hits)) ground = select(hits, ground_radiance(air, sunlight, ground_light, orders, at, reach) * transmittance, Vec4(0.0));
  return diffuse + apply_phases(air, phases, one_minus_cos(view, sun), class0, class1, class2, class3);
}

/// Transmittance of a view ray [1], by an integral of its own with three points a zone: it is held to 1e-5.
FN Vec4 ray_transmittance(IN(Air) air, Table2 zones, Table2 profile, Float altitude, Vec3 view, Float distance) {
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, view, distance, reach, whole, hits);
  return exp(-optical_depth_along(air, zones, profile, at.x, at.y, reach));
}

/// Sunlight normal to the beam at an observer, who may be in space, relative to that outside the atmosphere [1].
FN Vec4 sunlight_from(IN(Air) air, Table2 sunlight, Float altitude, Vec3 sun) {
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float skipped = enter_atmosphere(air.ground_radius, air.top_altitude, altitude, sun, start, mu);
  return select(skipped < 0.0, Vec4(1.0), sunlight_at(air, sunlight, start, mu));
}

// Light from all directions is gathered in two passes, one ray a texel and then a sum: rays run side by side, and no texel turns
// its loops more than 60000 times (Mesa's software driver leaves them after 65535, without a word).

/// Direction of the upper hemisphere, one of 256: 16 rings and 16 azimuths on one side of the x axis, along which the Sun stands and which
/// mirrors the other side [1]. What comes from there is kept times its weight.
/// @param index [1] in 0..255
/// @param mu_s [1] in -1..1
/// @param weight [1]  z, as a level plane gets light, times the direction's part of the hemisphere, of which the mean is 1
FN Vec3 hemisphere_direction(Float index, Float mu_s, OUT(Float) weight) {
  // Dust and droplets glow about the Sun. Rings are of equal height, but the higher the Sun the closer they are about the zenith.
  Float ring = floor((index + 0.5) * (1.0 / 16.0));
  Float from_top = 1.0 - (ring + 0.5) * (1.0 / 16.0);
  Float high = max(mu_s, 0.0);
  Float crowd = 1.0 + 2.0 * high * high * high * high;
  Float below = power(from_top, crowd);
  Float z = 1.0 - below;
  // Azimuths are half as far apart at the Sun's. They go round as evenly as a cosine does, and so a sum over them stays as good as one over
  // even ones is for a smooth sky.
  Float even = (floor(index + 0.5) - 16.0 * ring + 0.5) * 0.196349540849362;
  Float azimuth = even - 0.5 * sin(even);
  weight = z * (crowd * below / from_top) * (1.0 - 0.5 * cos(even));
  Float across = sqrt(1.0 - z * z);
  return Vec3(across * cos(azimuth), across * sin(azimuth), z);
}

/// The Sun turned about the vertical to the x axis [1].
/// @param sun [1] in -0.577..0.577
FN Vec3 sun_ahead(Vec3 sun) { return Vec3(sqrt(sun.x * sun.x + sun.y * sun.y), Float(0.0), sun.z); }

/// Sum of `count` texels of a row from a column on.
FN Vec4 sum_of_row(Table2 table, Float column, Float row, int count) {
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < count; ++i) sum = sum + fetch(table, column + Float(i), row);
  return sum;
}

/// Sum of `count` texels of a column from a row on.
FN Vec4 sum_of_column(Table2 table, Float column, Float row, int count) {
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < count; ++i) sum = sum + fetch(table, column, row + Float(i));
  return sum;
}

/// Skylight on a horizontal plane that faces up, of observers one a row [W m^-2 nm^-1]: the sum over a model's `sky_light`.
FN Vec4 sky_irradiance_pass(IN(Air) air, Table2 sky_light, Vec2 uv) {
  return sum_of_row(sky_light, Float(0.0), floor(uv.y * height_of(sky_light)), 256) * (6.28318530717959 / 256.0) * Vec4(air.solar_irradiance);
}

/// Sunlight on a plane normal to the beam [W m^-2 nm^-1].
FN Vec4 sun_irradiance_pass(IN(Air) air, Table2 sunlight, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 at = fetch_same(suns, uv);
  return sunlight_from(air, sunlight, fetch_same(eyes, uv).x, Vec3(at.y, at.z, at.w)) * Vec4(air.solar_irradiance);
}
