#pragma once
#include "core/geometry.glsl"
#include "core/phase.glsl"
// The textbook march: single scattering of exponential molecules and aerosol, 16 samples along the view, each with 4 towards the
// Sun, all by midpoints. No table; 16 (2 + 4 2 + 4) = 224 exps a pixel. What a number type is worth shows here undisturbed.

struct March {
  Scalar4 molecules;           // [1/m] in 0..1e-4  scattering coefficient at altitude 0
  Scalar4 aerosol;             // [1/m] in 0..1e-4
  Scalar4 sun;                 // [1] in -1..1  unit vector towards the Sun, z up
  Scalar ground_radius;        // [m] in 1e6..1e8
  Scalar top_altitude;         // [m] in 1e4..2e5
  Scalar molecule_thinning;    // [1/m] in 1e-5..1e-2  1 / scale height
  Scalar aerosol_thinning;     // [1/m] in 1e-5..1e-2
  Scalar aerosol_extinction;   // [1] in 1..2  extinction / scattering
  Scalar asymmetry;            // [1] in 0..0.9
  Scalar altitude;             // [m] in 0..1e4
  Scalar pad;                  // [1] in 0..1
};

/// Radiance of the upper half of the sky, azimuth across and elevation up, per solar irradiance [1/sr].
FN Vec4 bench_march_pass(IN(March) air, Vec2 uv) {
  Float azimuth = uv.x * 6.28318530717959;
  Float elevation = (1.0 - uv.y) * 1.57079632679490;
  Vec3 view = Vec3(cos(elevation) * sin(azimuth), cos(elevation) * cos(azimuth), sin(elevation));
  Vec3 sun = Vec3(air.sun.x, air.sun.y, air.sun.z);
  Float altitude = Float(air.altitude);
  Float apart = one_minus_cos(view, sun);
  Float stride = distance_to_shell(air.ground_radius, altitude, Float(air.top_altitude), view.z) * 0.0625;
  Float molecules = Float(0.0);  // passed so far, as a path [m] through the air of altitude 0
  Float aerosol = Float(0.0);
  Vec4 by_molecules = Vec4(0.0);
  Vec4 by_aerosol = Vec4(0.0);
  for (int i = 0; i < 16; ++i) {
    Float path = (Float(i) + 0.5) * stride;
    Float h = altitude_along(air.ground_radius, altitude, view.z, path);
    Float mu_s = ((air.ground_radius + altitude) * sun.z + path * (1.0 - apart)) / (air.ground_radius + h);
    Float molecules_here = exp(-h * air.molecule_thinning) * stride;
    Float aerosol_here = exp(-h * air.aerosol_thinning) * stride;
    Float step_up = distance_to_shell(air.ground_radius, h, Float(air.top_altitude), mu_s) * 0.25;
    Float molecules_up = Float(0.0);
    Float aerosol_up = Float(0.0);
    for (int k = 0; k < 4; ++k) {
      Float up = max(altitude_along(air.ground_radius, h, mu_s, (Float(k) + 0.5) * step_up), 0.0);
      molecules_up = molecules_up + exp(-up * air.molecule_thinning);
      aerosol_up = aerosol_up + exp(-up * air.aerosol_thinning);
    }
    Vec4 depth = Vec4(air.molecules) * (molecules + 0.5 * molecules_here + molecules_up * step_up) +
                 Vec4(air.aerosol) * ((aerosol + 0.5 * aerosol_here + aerosol_up * step_up) * air.aerosol_extinction);
    Vec4 light = select(mu_s > mu_horizon(air.ground_radius, h), exp(-depth), Vec4(0.0));
    by_molecules = by_molecules + light * molecules_here;
    by_aerosol = by_aerosol + light * aerosol_here;
    molecules = molecules + molecules_here;
    aerosol = aerosol + aerosol_here;
  }
  return Vec4(air.molecules) * by_molecules * phase_rayleigh(apart) +
         Vec4(air.aerosol) * by_aerosol * phase_cornette_shanks(air.asymmetry, apart);
}
