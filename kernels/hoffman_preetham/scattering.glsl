#pragma once
#include "core/math.glsl"
#include "core/phase.glsl"
#include "hoffman_preetham/parameters.glsl"
// Light lost and gained on a path through air of constant density.

/// Rayleigh scattering coefficient of air [1/m]: 8 pi^3 (n^2 - 1)^2 / (3 N lambda^4) (6 + 3 p) / (6 - 7 p), with
/// n = 1.0003, N = 2.545e25 per cubic metre, p = 0.035.
/// @param wavelength [um] in 0.3..1
/// @bound 2e-5 scale 1e-6
FN Float hoffman_preetham_beta_rayleigh(Float wavelength) {
  Float squared = wavelength * wavelength;
  return 1.24109116311225e-6 / (squared * squared);
}

/// Mie scattering coefficient of the authors' theses [1/m]: 0.434 c pi (2 pi / lambda)^2 K, c = (6.544 T - 6.51) 1e-17. A thousand
/// times too large for clear air: later samples scale it down.
/// @param wavelength [um] in 0.3..1
/// @param k [1] in 0.5..1
/// @param turbidity [1] in 1..20
/// @bound 2e-5 scale 1e-3
FN Float hoffman_preetham_beta_mie_thesis(Float wavelength, Float k, Float turbidity) {
  return 5.38268963170005e-4 * (6.544 * turbidity - 6.51) * k / (wavelength * wavelength);
}

/// Phase function of aerosols [1/sr]. The authors' theta lies between the view ray and the way the sunlight travels, so that
/// their g < 0 is forward: Henyey and Greenstein's g of the scattering angle is -g. As printed it is (1 - g) / (1 + g) times as large.
/// @param g [1] in -0.98..0.98
/// @param printed [1] in 0..1
/// @param one_minus_cos [1] in 0..2
FN Float hoffman_preetham_phase(Scalar g, Scalar printed, Float one_minus_cos) {
  Float p = phase_henyey_greenstein(-g, one_minus_cos);
  if (printed > 0.5) p = p * ((1.0 - g) / (1.0 + g));
  return p;
}

/// exp of minus each component [1].
/// @param x [1] in 0..20
FN Vec3 hoffman_preetham_exp(Vec3 x) { return Vec3(exp(-x.x), exp(-x.y), exp(-x.z)); }

/// (1 - exp(-x)) / x [1], 1 at x = 0.
/// @param x [1] in 0..40
FN Float hoffman_preetham_mean_left(Float x) {
  return select(x < 1.0e-4, 1.0 - 0.5 * x, one_minus_exp(x) / max(x, 1.0e-4));
}

/// Light that air adds to a path, per sunlight [1/sr]; its optical depth. Both species keep their ground density along a path of their
/// own length: the same one in front of land, that of the virtual dome for the sky.
/// @param rayleigh_path [m] in 0..3e5
/// @param mie_path [m] in 0..3e5
/// @param one_minus_cos [1] in 0..2
/// @param depth [1]
/// @bound 1e-4 scale 1   the peak of g = 0.999 is (1 - |g|)^-2, of which float holds four digits
FN Vec3 hoffman_preetham_inscatter(IN(HoffmanPreetham) air, Float rayleigh_path, Float mie_path, Float one_minus_cos, OUT(Vec3) depth) {
  Vec3 molecules = xyz(Vec4(air.beta_rayleigh)) * rayleigh_path;
  Vec3 aerosols = xyz(Vec4(air.beta_mie)) * mie_path;
  depth = (molecules + aerosols + xyz(Vec4(air.beta_absorption)) * rayleigh_path) * Float(air.extinction_scale);
  Float rayleigh = phase_rayleigh(one_minus_cos);
  Float mie = hoffman_preetham_phase(air.g, air.printed, one_minus_cos);
  Vec3 scattered = molecules * rayleigh + aerosols * mie;
  Vec3 left = Vec3(hoffman_preetham_mean_left(depth.x), hoffman_preetham_mean_left(depth.y), hoffman_preetham_mean_left(depth.z));
  return scattered * left * Float(air.inscatter_scale);
}

/// A colour as eight bits hold it, of a display that shows 1 / gain as white [1].
/// @param x [1] in 0..1
/// @param gain [1] in 0.5..20
/// @bound 1.0 scale 1   which of two steps is nearer is a decision
FN Float hoffman_preetham_8bit(Float x, Float gain) { return floor(clamp(x * gain, 0.0, 1.0) * 255.0 + 0.5) / (255.0 * gain); }
