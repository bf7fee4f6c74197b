#pragma once
#include "core/air.glsl"
// Light gathered along a ray, zone by zone. Inside a zone all densities are smooth, so few Gauss points do: thin layers are
// zones of their own and are never missed, and the points crowd where zones are thin, around the lowest point of a ray
// (a leg ends there) and at the planet's shadow (a stretch ends there).

/// The zone that a ray crosses at a step of its way: all of them downwards, then all upwards.
FN Scalar4 zone_of_step(IN(Air) air, Table2 zones, int step) {
  int count = int(air.zones);
  int index = count - 1 - step;
  if (step >= count) index = step - count;
  return fetch_scalar(zones, index, 0);
}
/// The stretch of a ray that lies in a zone, as paths from its start [m]; empty where begin equals end.
/// @param zone [m] in 0..1e5  x: bottom, y: top
/// @param step [1] in 0..127
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param reach [m] in 0..1e6
/// @param begin [m]
/// @param end [m]
/// @bound 2e-5 scale 1e6
FN void stretch_in_zone(IN(Air) air, Scalar4 zone, int step, Float altitude, Float mu, Float reach, OUT(Float) begin, OUT(Float) end) {
  int leg = 0;
  if (step >= int(air.zones)) leg = 1;
  Float along = (air.ground_radius + altitude) * mu;
  Float low = clamp(-along, 0.0, reach);
  Float first = Float(0.0);
  Float last = low;
  if (leg == 1) {
    first = low;
    last = reach;
  }
  Float at_bottom = path_to_shell(air.ground_radius, altitude, along, Float(zone.x), leg);
  Float at_top = path_to_shell(air.ground_radius, altitude, along, Float(zone.y), leg);
  begin = clamp(min(at_bottom, at_top), first, last);
  end = clamp(max(at_bottom, at_top), first, last);
}

/// Optical depth along a stretch of a ray that ends before the ground and the top [1].
FN_SHARED Vec4 optical_depth_along(IN(Air) air, Table2 zones, Table2 profile, Float altitude, Float mu, Float reach) {
  Vec4 depth = Vec4(0.0);
  int steps = 2 * int(air.zones);
  int substeps = int(air.substeps);
  for (int step = 0; step < steps; ++step) {
    Scalar4 zone = zone_of_step(air, zones, step);
    Float begin = Float(0.0);
    Float end = Float(0.0);
    stretch_in_zone(air, zone, step, altitude, mu, reach, begin, end);
    Float stride = (end - begin) * (1.0 / air.substeps);
    if (any(stride > 0.0)) {
      for (int i = 0; i < substeps; ++i) {
        // Three-point Gauss: the answer to "transmittance" is held to 1e-5.
        for (int node = 0; node < 3; ++node) {
          Float place = (Float(i) + 0.5 + (Float(node) - 1.0) * 0.387298334620742) * stride;
          Float h = altitude_along(air.ground_radius, altitude, mu, begin + place);
          Float weight = select(abs(Float(node) - 1.0) < 0.5, Float(0.444444444444444), Float(0.277777777777778));
          depth = depth + lookup_cell(profile, profile_cell(air, zone, h), 0) * (weight * stride);
        }
      }
    }
  }
  return depth;
}

/// Zenith cosine of the Sun's upper limb from that of its centre [1].
/// @param mu_s [1] in -1..1
/// @bound 2e-5 scale 1   a cosine
FN Float upper_limb(IN(Air) air, Float mu_s) {
  Float sin_s = sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0));
  Float mu_limb = mu_s + air.sun_radius * (sin_s - 0.5 * air.sun_radius * mu_s);
  return select(mu_s > 1.0 - 0.5 * air.sun_radius * air.sun_radius, Float(1.0), mu_limb);
}
/// Sunlight at a place, relative to that outside the atmosphere: mean over the disc, hidden parts counting as dark [1].
FN Vec4 sunlight_at(IN(Air) air, Table2 sunlight, Float altitude, Float mu_s) {
  // The table's direction is that of the upper limb, so that it begins where the disc appears.
  Float mu_limb = upper_limb(air, mu_s);
  Vec4 light = exp(-lookup(sunlight, depth_uv(air, altitude, mu_limb, width_of(sunlight), height_of(sunlight))));
  return select(mu_limb > mu_horizon(air.ground_radius, altitude), light, Vec4(0.0));
}

// ---- light scattered more than once: table over the Sun's zenith cosine (u) and altitude (v) of -ln(source / solar irradiance) ----

/// Table coordinates [1]: dense where the Sun is near the horizon and near the ground.
/// @param altitude [m] in 0..1e4
/// @param mu_s [1] in -1..1
/// @param width [1] in 16..128
/// @param height [1] in 16..128
FN Vec2 multiple_uv(IN(Air) air, Float altitude, Float mu_s, Scalar width, Scalar height) {
  Float root = sqrt(abs(mu_s));
  Float u = 0.5 + 0.5 * select(mu_s < 0.0, -root, root);
  return Vec2(half_texel(u, width), half_texel(sqrt(clamp(altitude * (1.0 / air.top_altitude), 0.0, 1.0)), height));
}
/// Altitude [m] and the Sun's zenith cosine of a place in the table.
/// @param uv [1] in 0..1
/// @param width [1] in 16..128
/// @param height [1] in 16..128
/// @param mu_s [1]
/// @bound 2e-5 scale 1e5
FN Float multiple_place(IN(Air) air, Vec2 uv, Scalar width, Scalar height, OUT(Float) mu_s) {
  Float u = 2.0 * from_half_texel(uv.x, width) - 1.0;
  mu_s = u * abs(u);
  Float v = from_half_texel(uv.y, height);
  return v * v * air.top_altitude;
}

/// Where a view ray meets the air, and in which light. x: altitude [m] at its start inside the air; y: its zenith cosine there;
/// z: the Sun's; w: cosine of the angle between ray and Sun.
/// @param altitude [m] in 0..1e6
/// @param view [1] in -0.577..0.577
/// @param sun [1] in -0.577..0.577
/// @param distance [m] in 1..1e7 log
/// @param reach [m]  the ray's path inside the air
/// @param whole [m]  what it would be without an end to `distance`: to the ground or the top
/// @param hits [1]   it ends on the ground
/// @bound 1 scale 1e30   whether a grazing ray meets the air or the ground may differ: compared as part of the passes
FN Vec4 meet_air(IN(Air) air, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Float) reach, OUT(Float) whole, OUT(Bool) hits) {
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float skipped = enter_atmosphere(air.ground_radius, air.top_altitude, altitude, view, start, mu);
  Float nu = 1.0 - one_minus_cos(view, sun);
  Float mu_s = clamp(((air.ground_radius + altitude) * sun.z + max(skipped, 0.0) * nu) / (air.ground_radius + start), -1.0, 1.0);
  Bool down = mu < mu_horizon(air.ground_radius, start);
  whole = select(down, distance_to_ground(air.ground_radius, start, mu), distance_to_shell(air.ground_radius, start, Float(air.top_altitude), mu));
  Float left = distance - max(skipped, 0.0);
  Bool misses = skipped < 0.0;
  hits = down && (left >= whole) && !misses;
  whole = select(misses, Float(0.0), max(whole, 0.0));
  reach = clamp(left, 0.0, whole);
  return Vec4(start, mu, mu_s, nu);
}

/// The stretch that a point of a two-point Gauss step stands for, weakened by the air before it [m].
/// @param node [1] in 0..1
/// @param depth [1] in 0..4  before the step
/// @param extinction0 [1] in 0..4  what the whole step would have if all of it were as the first point
/// @param extinction1 [1] in 0..4  as the second
/// @param stride [m] in 0..1
FN Vec4 gauss_weight(int node, Vec4 depth, Vec4 extinction0, Vec4 extinction1, Float stride) {
  // The depth up to each point by the matching collocation (Butcher 1964): order 4.
  Vec4 passed = depth + 0.25 * extinction0 - 0.0386751345948129 * extinction1;
  if (node == 1) passed = depth + 0.538675134594813 * extinction0 + 0.25 * extinction1;
  Vec4 through = exp(-max(passed, 0.0)) * (0.5 * stride);
  Vec4 both = extinction0 + extinction1;
  Bool thick = max(max(both.x, both.y), max(both.z, both.w)) > 2.0;
  if (any(thick)) {
    // Deeper than 1 in a step: each point stands for its half, uniform, whose light is (1 - exp(-depth)) / extinction.
    Vec4 half_depth = 0.5 * extinction0;
    Vec4 before = depth;
    if (node == 1) {
      before = depth + half_depth;
      half_depth = 0.5 * extinction1;
    }
    Vec4 share = (Vec4(1.0) - exp(-half_depth)) / max(half_depth, 1.0e-3);
    through = select(thick, exp(-before) * share * (0.5 * stride), through);
  }
  return through;
}

/// The stretch of a ray that no sunlight reaches, as paths from its start [m]; empty: begin >= end.
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param mu_s [1] in -1..1   cosine of the Sun's zenith angle at the start
/// @param nu [1] in -1..1     cosine of the angle between ray and Sun
/// @param begin [m]
/// @param end [m]
/// @bound 1 scale 1e30   as planet_shadow
FN void umbra_along(IN(Air) air, Float altitude, Float mu, Float mu_s, Float nu, OUT(Float) begin, OUT(Float) end) {
  // A smaller planet casts the shadow: what remains outside includes all of the penumbra, which the disc throws into the air.
  Scalar penumbra = air.sun_radius * sqrt(2.0 * air.top_altitude * (air.ground_radius + air.top_altitude));
  Scalar shadow_radius = max(air.ground_radius - penumbra, 0.5 * air.ground_radius);
  planet_shadow(shadow_radius, altitude + (air.ground_radius - shadow_radius), mu, mu_s, nu, begin, end);
}

/// Light gathered along a ray: for each phase class the integral of scattering x sunlight x transmittance (to be multiplied by
/// its phase function and the solar irradiance), the light scattered more than once (orders > 1; else `multiple` is not read),
/// and the optical depth of the whole path. `at` is where the ray meets the air, as meet_air says.
FN_SHARED void gather_light(IN(Air) air, int orders, Table2 zones, Table2 profile, Table2 sunlight, Table2 multiple, Vec4 at, Float reach,
                            OUT(Vec4) class0, OUT(Vec4) class1, OUT(Vec4) class2, OUT(Vec4) class3, OUT(Vec4) diffuse, OUT(Vec4) depth) {
  Float altitude = at.x;
  Float mu = at.y;
  Float mu_s = at.z;
  Float nu = at.w;
  class0 = Vec4(0.0);
  class1 = Vec4(0.0);
  class2 = Vec4(0.0);
  class3 = Vec4(0.0);
  diffuse = Vec4(0.0);
  depth = Vec4(0.0);
  Float radius = air.ground_radius + altitude;
  Float dark = Float(0.0);
  Float light_again = Float(0.0);
  umbra_along(air, altitude, mu, mu_s, nu, dark, light_again);
  int steps = 2 * int(air.zones);
  int substeps = int(air.substeps);
  for (int step = 0; step < steps; ++step) {
    Scalar4 zone = zone_of_step(air, zones, step);
    Float enter = Float(0.0);
    Float leave = Float(0.0);
    stretch_in_zone(air, zone, step, altitude, mu, reach, enter, leave);
    if (any(leave > enter)) {
      Float cut0 = clamp(dark, enter, leave);
      Float cut1 = clamp(light_again, cut0, leave);
      for (int piece = 0; piece < 3; ++piece) {  // before, inside and behind the planet's shadow
        Float begin = enter;
        Float end = cut0;
        if (piece == 1) {
          begin = cut0;
          end = cut1;
        }
        if (piece == 2) {
          begin = cut1;
          end = leave;
        }
        Float stride = (end - begin) * (1.0 / air.substeps);
        if (any(stride > 0.0)) {
          for (int i = 0; i < substeps; ++i) {
            // Two-point Gauss, and the depth up to each point by the matching collocation (Butcher 1964): order 4.
            Float path0 = begin + (Float(i) + 0.211324865405187) * stride;
            Float path1 = begin + (Float(i) + 0.788675134594813) * stride;
            Float altitude0 = altitude_along(air.ground_radius, altitude, mu, path0);
            Float altitude1 = altitude_along(air.ground_radius, altitude, mu, path1);
            Float cell0 = profile_cell(air, zone, altitude0);
            Float cell1 = profile_cell(air, zone, altitude1);
            Vec4 extinction0 = lookup_cell(profile, cell0, 0) * stride;
            Vec4 extinction1 = lookup_cell(profile, cell1, 0) * stride;
            for (int node = 0; node < 2; ++node) {
              Float path = path0;
              Float h = altitude0;
              Float cell = cell0;
              if (node == 1) {
                path = path1;
                h = altitude1;
                cell = cell1;
              }
              Vec4 through = gauss_weight(node, depth, extinction0, extinction1, stride);
              Float sun = (radius * mu_s + path * nu) / (air.ground_radius + h);
              Vec4 scattering = lookup_cell(profile, cell, 1);
              Vec4 lit = Vec4(0.0);
              if (piece != 1) {
                lit = sunlight_at(air, sunlight, h, sun) * through;
                class0 = class0 + scattering * lit;
              }
              if (air.classes > 1.5) {
                Vec4 more = lookup_cell(profile, cell, 2);
                scattering = scattering + more;
                class1 = class1 + more * lit;
              }
              if (air.classes > 2.5) {
                Vec4 more = lookup_cell(profile, cell, 3);
                scattering = scattering + more;
                class2 = class2 + more * lit;
              }
              if (air.classes > 3.5) {
                Vec4 more = lookup_cell(profile, cell, 4);
                scattering = scattering + more;
                class3 = class3 + more * lit;
              }
              if (orders > 1) {
                Vec4 source = exp(-lookup(multiple, multiple_uv(air, h, sun, width_of(multiple), height_of(multiple))));
                diffuse = diffuse + scattering * source * through;
              }
            }
            depth = depth + 0.5 * (extinction0 + extinction1);
          }
        }
      }
    }
  }
}

/// The light of the phase classes seen under one scattering angle, per solar irradiance [1/sr].
FN Vec4 apply_phases(IN(Air) air, Table2 phases, Float one_minus_cos, Vec4 class0, Vec4 class1, Vec4 class2, Vec4 class3) {
  Float x = sqrt(max(0.5 * one_minus_cos, 0.0));
  Vec4 sum = class0 * lookup_row(phases, x, 0);
  if (air.classes > 1.5) sum = sum + class1 * lookup_row(phases, x, 1);
  if (air.classes > 2.5) sum = sum + class2 * lookup_row(phases, x, 2);
  if (air.classes > 3.5) sum = sum + class3 * lookup_row(phases, x, 3);
  return sum;
}

/// The part of uniform light around a place that reaches it from one direction scattered or reflected once more [1].
FN_SHARED Vec4 scattered_again(IN(Air) air, Table2 zones, Table2 profile, Float altitude, Float mu) {
  Bool down = mu < mu_horizon(air.ground_radius, altitude);
  Float reach = select(down, distance_to_ground(air.ground_radius, altitude, mu), distance_to_shell(air.ground_radius, altitude, Float(air.top_altitude), mu));
  Vec4 sum = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  int steps = 2 * int(air.zones);
  for (int step = 0; step < steps; ++step) {
    Scalar4 zone = zone_of_step(air, zones, step);
    Float enter = Float(0.0);
    Float leave = Float(0.0);
    stretch_in_zone(air, zone, step, altitude, mu, reach, enter, leave);
    Float stride = leave - enter;
    if (any(stride > 0.0)) {
      Float cell = profile_cell(air, zone, altitude_along(air.ground_radius, altitude, mu, enter + 0.5 * stride));
      Vec4 extinction = lookup_cell(profile, cell, 0) * stride;
      Vec4 scattering = lookup_cell(profile, cell, 1);
      if (air.classes > 1.5) scattering = scattering + lookup_cell(profile, cell, 2);
      if (air.classes > 2.5) scattering = scattering + lookup_cell(profile, cell, 3);
      if (air.classes > 3.5) scattering = scattering + lookup_cell(profile, cell, 4);
      sum = sum + scattering * stride * exp(-(depth + 0.5 * extinction));
      depth = depth + extinction;
    }
  }
  return sum + select(down, exp(-depth) * Vec4(air.albedo), Vec4(0.0));
}
