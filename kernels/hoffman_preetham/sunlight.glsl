#pragma once
#include "hoffman_preetham/dome.glsl"
#include "hoffman_preetham/scattering.glsl"
// Sunlight at the ground: one colour for a frame, for every path and for the land.

/// Relative air mass (Kasten's form, as Preetham, Shirley & Smits 1999 print it) [1].
/// @param mu [1] in -1..1  cosine of the Sun's zenith angle; below the horizon as on it
FN Float hoffman_preetham_air_mass(Float mu) {
  return 1.0 / (max(mu, 0.0) + 0.15 * exp(-1.253 * ln(93.885 - hoffman_preetham_degrees(mu))));
}

/// What clear air leaves of the sunlight at 650, 570 and 475 nm [1]: molecules, aerosols by Angstrom's law, 0.35 cm of ozone. Mixed gas and
/// water vapour absorb nothing there (Preetham, Shirley & Smits 1999, appendix A.1).
/// @param mu [1] in -1..1
/// @param turbidity [1] in 1..20
/// @param ozone [1] in 0..1  1: with ozone
FN Vec3 hoffman_preetham_clear_sky(Float mu, Scalar turbidity, Scalar ozone) {
  Float mass = hoffman_preetham_air_mass(mu);
  // Molecules: 0.008735 lambda^-4.08 [um]. Aerosols: b lambda^-1.3.
  Float b = Float(0.04608365822050 * turbidity - 0.04586025928522);
  Vec3 depth = Vec3(0.0506496459855208 + b * 1.75070364664789, 0.0865552665572463 + b * 2.07664704115535, 0.182118046027741 + b * 2.63207528672229);
  if (ozone > 0.5) depth = depth + Vec3(Float(0.35 * 0.067), Float(0.35 * 0.120), Float(0.35 * 0.0115));
  return hoffman_preetham_exp(depth * mass);
}

/// Sunlight normal to the beam at the ground [1].
/// @param mu [1] in -1..1  cosine of the Sun's zenith angle
/// @bound 1e-4 scale 1e3   how much of the disc has risen is a difference of angles
FN Vec3 hoffman_preetham_sunlight(IN(HoffmanPreetham) air, Float mu) {
  Vec3 left = Vec3(Float(1.0), Float(1.0), Float(1.0));
  if (air.dome_sunlight > 0.5) {
    Float rayleigh = hoffman_preetham_rayleigh_dome(air, mu);
    left = hoffman_preetham_exp((xyz(Vec4(air.beta_rayleigh)) + xyz(Vec4(air.beta_absorption))) * rayleigh + xyz(Vec4(air.beta_mie)) * hoffman_preetham_mie_dome(air, mu));
  } else {
    left = hoffman_preetham_clear_sky(mu, air.turbidity, air.ozone);
  }
  // The part of a disc of 0.54 degrees above the horizon.
  Float risen = clamp((90.27 - arc_cosine(mu) * 57.2957795130823) * (1.0 / 0.54), 0.0, 1.0);
  return left * xyz(Vec4(air.solar_irradiance)) * risen;
}
