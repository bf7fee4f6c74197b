#pragma once
// Phase functions [1/sr], 1 over the sphere. They take 1 - cos of the scattering angle (0 = forward), which is
// |view - sun|^2 / 2 and does not cancel near the Sun: the cosine itself loses up to 42 % of a sharp peak in float.

/// 1 - cos of the angle between two unit vectors [1].
/// @param a [1] in -0.577..0.577
/// @param b [1] in -0.577..0.577
FN Float one_minus_cos(Vec3 a, Vec3 b) {
  Vec3 apart = a - b;
  return 0.5 * dot(apart, apart);
}

/// Isotropic [1/sr].
/// @param one_minus_cos [1] in 0..2
FN Float phase_isotropic(Float one_minus_cos) { return 0.0795774715459477 + 0.0 * one_minus_cos; }

/// Rayleigh scattering [1/sr].
/// @param one_minus_cos [1] in 0..2
FN Float phase_rayleigh(Float one_minus_cos) {
  Float c = 1.0 - one_minus_cos;
  return 0.0596831036594607 * (1.0 + c * c);
}

/// Rayleigh scattering of molecules with depolarisation factor rho (Chandrasekhar 1950, section 18) [1/sr].
/// @param depolarisation [1] in 0..0.1
/// @param one_minus_cos [1] in 0..2
FN Float phase_rayleigh_depolarised(Scalar depolarisation, Float one_minus_cos) {
  Float c = 1.0 - one_minus_cos;
  return (0.119366207318922 / (2.0 + depolarisation)) * (1.0 + depolarisation + (1.0 - depolarisation) * c * c);
}

/// 1 + g^2 - 2 g cos of the scattering angle, without cancellation for either sign of g [1].
/// @param g [1] in -0.98..0.98
/// @param one_minus_cos [1] in 0..2
/// @bound 2e-5 scale 1e-3
FN Float peak_distance(Scalar g, Float one_minus_cos) {
  Scalar a = max(g, -g);
  Float x = one_minus_cos;
  if (g < 0.0) x = 2.0 - one_minus_cos;
  return (1.0 - a) * (1.0 - a) + 2.0 * a * x;
}

/// Henyey & Greenstein 1941 (doi:10.1086/144246), g > 0 forward [1/sr].
/// @param g [1] in -0.98..0.98
/// @param one_minus_cos [1] in 0..2
FN Float phase_henyey_greenstein(Scalar g, Float one_minus_cos) {
  Float d = peak_distance(g, one_minus_cos);
  return 0.0795774715459477 * (1.0 - g * g) / (d * sqrt(d));  // a general power is five times dearer
}

/// Cornette & Shanks 1992 (doi:10.1364/AO.31.003152), g > 0 forward [1/sr].
/// @param g [1] in -0.98..0.98
/// @param one_minus_cos [1] in 0..2
FN Float phase_cornette_shanks(Scalar g, Float one_minus_cos) {
  Float c = 1.0 - one_minus_cos;
  Float d = peak_distance(g, one_minus_cos);
  return 0.119366207318922 * (1.0 - g * g) * (1.0 + c * c) / ((2.0 + g * g) * d * sqrt(d));
}
