#pragma once
#include "core/geometry.glsl"
#include "core/math.glsl"
#include "core/phase.glsl"
// Air as the host bakes it, for four wavelengths: any list of constituents costs the same.
//
// `zones`    one row: the altitudes between which all densities are smooth; x: bottom, y: top, z: 1 / thickness, w: number
// `profile`  cells of equal height inside each zone, two texels a cell (value at its lower and upper end)
//            row 0: extinction coefficient [1/m]; row 1 + c: scattering coefficient of phase class c
// `phases`   row c: phase function of class c over sqrt(one_minus_cos / 2) [1/sr]

struct Air {
  Scalar4 albedo;             // [1] in 0..1
  Scalar4 solar_irradiance;   // [W m^-2 nm^-1] in 0..2
  Scalar4 limb_darkening;     // [1] in 0..1  exponent a of radiance(mu) = mu^a over the disc
  Scalar4 disc_light;         // [1] in 0.1..1  the whole disc's, as sunlight_pass sums it: mean of sin(phi)^(a + 2) over its slices
  Scalar ground_radius;       // [m] in 1e6..1e8 log
  Scalar top_altitude;        // [m] in 1e4..2e5
  Scalar sun_radius;          // [rad] in 1e-3..1e-2  angular radius of the Sun
  Scalar classes;             // [1] in 1..4  phase classes in use
  Scalar zones;               // [1] in 1..64  zones in use
  Scalar cells;               // [1] in 16..1024  cells a zone
  Scalar substeps;            // [1] in 1..4  two-point Gauss steps a zone
  Scalar pad;                 // [1] in 0..1
};

/// Which cell of the profile, and how far into it, an altitude of a zone has [1].
/// @param zone [m] in 0..1  x: bottom, z: 1 / thickness, w: number
/// @param altitude [m] in 0..2
/// @bound 2e-5 scale 1
FN Float profile_cell(IN(Air) air, Scalar4 zone, Float altitude) {
  return (zone.w + clamp((altitude - zone.x) * zone.z, 0.0, 0.999999)) * air.cells;
}

// ---- optical depth to space: table over altitude (v) and direction (u) of rays that miss the ground ----
// Mapping after Bruneton & Neyret 2008 (doi:10.1111/j.1467-8659.2008.01245.x), in altitudes.

/// Table coordinates of an altitude and a zenith cosine above the horizon [1].
/// @param altitude [m] in 0..1e4
/// @param mu [1] in 0..1
/// @param width [1] in 32..512
/// @param height [1] in 32..512
FN Vec2 depth_uv(IN(Air) air, Float altitude, Float mu, Scalar width, Scalar height) {
  Scalar longest = sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  Float rho = sqrt(max(radius_gap(air.ground_radius, altitude, Float(0.0)), 0.0));
  Float shortest = air.top_altitude - altitude;
  Float path = distance_to_shell(air.ground_radius, altitude, Float(air.top_altitude), mu);
  Float x = (path - shortest) / max(rho + longest - shortest, 1.0e-3);
  return Vec2(half_texel(clamp(x, 0.0, 1.0), width), half_texel(clamp(rho * (1.0 / longest), 0.0, 1.0), height));
}
/// Altitude [m] and zenith cosine of a place in the table.
/// @param uv [1] in 0..1
/// @param width [1] in 32..512
/// @param height [1] in 32..512
/// @param mu [1]
/// @bound 2e-5 scale 1e5
FN Float depth_place(IN(Air) air, Vec2 uv, Scalar width, Scalar height, OUT(Float) mu) {
  Scalar longest = sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  Float rho = longest * from_half_texel(uv.y, height);
  Float altitude = min(rho * rho / (air.ground_radius + sqrt(air.ground_radius * air.ground_radius + rho * rho)), air.top_altitude);
  Float shortest = air.top_altitude - altitude;
  Float path = shortest + from_half_texel(uv.x, width) * (rho + longest - shortest);
  Float gap = shortest * (2.0 * air.ground_radius + air.top_altitude + altitude);
  mu = clamp((gap - path * path) / (2.0 * (air.ground_radius + altitude) * max(path, 1.0e-3)), -1.0, 1.0);
  mu = select(path < 1.0e-2, Float(1.0), mu);
  return altitude;
}
