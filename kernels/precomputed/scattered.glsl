#pragma once
#include "core/radiance.glsl"
#include "precomputed/lattice.glsl"
// Light of the second order and higher along a ray.

/// Light that the air sends along a ray as `source` says, per solar irradiance [1/sr]; the optical depth of the path. `at` is where
/// the ray meets the air, as meet_air says.
FN_SHARED Vec4 precomputed_gather(IN(Air) air, IN(Lattice) lattice, Table2 zones, Table2 profile, Table3 source, Vec4 at, Float reach, OUT(Vec4) depth) {
  Float radius = air.ground_radius + at.x;
  Vec4 sum = Vec4(0.0);
  depth = Vec4(0.0);
  int steps = 2 * int(air.zones);
  int substeps = int(air.substeps);
  for (int step = 0; step < steps; ++step) {
    Scalar4 zone = zone_of_step(air, zones, step);
    Float enter = Float(0.0);
    Float leave = Float(0.0);
    stretch_in_zone(air, zone, step, at.x, at.y, reach, enter, leave);
    Float stride = (leave - enter) * (1.0 / air.substeps);
    if (any(stride > 0.0)) {
      for (int i = 0; i < substeps; ++i) {
        Float path0 = enter + (Float(i) + 0.211324865405187) * stride;
        Float path1 = enter + (Float(i) + 0.788675134594813) * stride;
        Float altitude0 = altitude_along(air.ground_radius, at.x, at.y, path0);
        Float altitude1 = altitude_along(air.ground_radius, at.x, at.y, path1);
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
          Vec4 scattering = lookup_cell(profile, cell, 1);
          if (air.classes > 1.5) scattering = scattering + lookup_cell(profile, cell, 2);
          if (air.classes > 2.5) scattering = scattering + lookup_cell(profile, cell, 3);
          if (air.classes > 3.5) scattering = scattering + lookup_cell(profile, cell, 4);
          Float from_centre = 1.0 / (air.ground_radius + h);
          Float mu = clamp((radius * at.y + path) * from_centre, -1.0, 1.0);
          Float mu_s = clamp((radius * at.z + path * at.w) * from_centre, -1.0, 1.0);
          Vec4 sent = precomputed_source_at(air, lattice, source, h, mu, mu_s, at.w);
          sum = sum + scattering * sent * gauss_weight(node, depth, extinction0, extinction1, stride);
        }
        depth = depth + 0.5 * (extinction0 + extinction1);
      }
    }
  }
  return sum;
}

/// What the ground sends back of the light that reaches it, per solar irradiance [1/sr]. `at` and `reach` are those of a ray that ends there.
FN Vec4 precomputed_ground(IN(Air) air, Table2 ground_light, Vec4 at, Float reach) {
  Float mu_s = ((air.ground_radius + at.x) * at.z + reach * at.w) * (1.0 / air.ground_radius);
  return exp(-lookup_row(ground_light, precomputed_sun_place(mu_s), 0)) * Vec4(air.albedo) * 0.318309886183791;
}

/// What a view ray brings, all orders of scattering, per solar irradiance [1/sr]: the air's part; transmittance of the whole ray; light
/// reflected by the ground where the ray meets it, already attenuated.
FN_SHARED Vec4 precomputed_ray_light(IN(Air) air, IN(Lattice) lattice, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table3 source,
                           Table2 ground_light, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 light = ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, altitude, view, sun, distance, transmittance, ground);
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, distance, reach, whole, hits);
  Vec4 depth = Vec4(0.0);
  light = light + precomputed_gather(air, lattice, zones, profile, source, at, reach, depth);
  ground = ground + select(hits, precomputed_ground(air, ground_light, at, reach) * exp(-depth), Vec4(0.0));
  return light;
}
