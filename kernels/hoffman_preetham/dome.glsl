#pragma once
#include "core/math.glsl"
#include "hoffman_preetham/parameters.glsl"
// The virtual dome: how long a path through air of ground density is that holds as much as a ray of the sky. Heights and the three
// numbers of the fitted surface come from the host (src/model/virtual_dome.h).

/// Zenith angle down to the horizon, below which it stays [degrees].
/// @param mu [1] in -1..1  cosine
/// @bound 2e-5 scale 90
FN Float hoffman_preetham_degrees(Float mu) { return arc_cosine(max(mu, 0.0)) * 57.2957795130823; }

/// Fitted surface [m].
/// @param height [m] in 500..20000
/// @param a [1] in 0.01..2
/// @param b [degrees] in 91..120
/// @param c [1] in 1..3
/// @param mu [1] in -1..1  cosine of the zenith angle
/// @bound 2e-5 scale 1e5
FN Float hoffman_preetham_dome(Scalar height, Scalar a, Scalar b, Scalar c, Float mu) {
  Float below = max(b - hoffman_preetham_degrees(mu), 0.1);
  return height / (max(mu, 0.0) + a * exp(-c * ln(below)));
}

/// Dome of molecules [m]; the only one in the authors' mode.
/// @param mu [1] in -1..1
/// @bound 2e-5 scale 1e5
FN Float hoffman_preetham_rayleigh_dome(IN(HoffmanPreetham) air, Float mu) {
  return hoffman_preetham_dome(air.rayleigh_height, air.rayleigh_a, air.rayleigh_b, air.rayleigh_c, mu);
}

/// Dome of aerosols [m]: that of molecules unless each species has its own.
/// @param mu [1] in -1..1
/// @bound 2e-5 scale 1e5
FN Float hoffman_preetham_mie_dome(IN(HoffmanPreetham) air, Float mu) {
  Float path = hoffman_preetham_rayleigh_dome(air, mu);
  if (air.per_species > 0.5) path = hoffman_preetham_dome(air.mie_height, air.mie_a, air.mie_b, air.mie_c, mu);
  return path;
}
