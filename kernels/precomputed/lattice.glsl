#pragma once
#include "core/air.glsl"
// Where the light of higher orders is known: a lattice of altitudes, Suns and directions. Light that has been scattered is smooth,
// so the lattice is small; it is dense where that light is not: near the ground, at the horizon, and with the Sun about the horizon.
//
// `light`   what arrives at a place, per solar irradiance [1/sr]. Columns: Suns; rows: directions, a band for each altitude.
// `source`  -ln of what the air there sends into a direction, per solar irradiance and scattering coefficient [1/sr]. Columns: Suns;
//           rows: zenith angle, 0 to pi, a band for each altitude; slices: azimuth from the Sun, 0 to pi.

struct Lattice {
  Scalar suns;       // [1] in 2..96   zenith cosines of the Sun
  Scalar altitudes;  // [1] in 2..64
  Scalar rings;      // [1] in 2..32   of directions that light comes from: half of them above the horizon, half below
  Scalar sectors;    // [1] in 2..32   of a ring, on one side of the Sun's plane, which mirrors the other
  Scalar zeniths;    // [1] in 2..32   zenith angles that light is sent into
  Scalar azimuths;   // [1] in 2..32   azimuths that light is sent into
  Scalar panels;     // [1] in 3..64   of a ray, as precomputed_march takes them, while the tables are made
  Scalar straight;   // [1] in 0..1    sine of half the angle within which light counts as scattered straight on
};

/// How far below the horizon the Sun is followed, as a sine [1]: 25 degrees. On planets greater than Earth air of the same height sees the
/// Sun for less, as a root of their radius, and dusk is shorter.
FN Scalar precomputed_nightfall(IN(Air) air) { return 0.42 * min(1.0, sqrt(6.4e6 / air.ground_radius)); }
/// Place of a zenith cosine of the Sun among the lattice's [1]. Suns crowd at the horizon, where -ln of light turns from a steep slope to a
/// gentle one: between two of them it goes straight. On either side the place is a multiple of a / (a + k), which is steep where the sine a of
/// the Sun's height is below k and flat beyond: k is 0.3 by day, 10/7 of `nightfall` (0.6 on Earth) below the horizon. The horizon is at 0.55
/// of the way; what is left on each side must end at 1 and 0, where a is 1 and `nightfall`: so the multiples are 0.45 (1 + 0.3) = 0.585 and
/// 0.55 (1 + 10/7) = 1.3357.
/// @param mu_s [1] in -1..1
FN Float precomputed_sun_place(IN(Air) air, Float mu_s) {
  Scalar last = precomputed_nightfall(air);
  Bool set = mu_s < 0.0;
  Float away = min(abs(mu_s), select(set, Float(last), Float(1.0)));
  return 0.55 + select(set, Float(-1.33571428571429), Float(0.585)) * away / (away + select(set, Float(1.42857142857143 * last), Float(0.3)));
}
/// Zenith cosine of the Sun at a place among the lattice's [1].
/// @param u [1] in 0..1
FN Float precomputed_sun(IN(Air) air, Float u) {
  Float up = clamp(u - 0.55, 0.0, 0.45);
  Float down = clamp(0.55 - u, 0.0, 0.55);
  return 0.3 * up / (0.585 - up) - 1.42857142857143 * precomputed_nightfall(air) * down / (1.33571428571429 - down);
}

/// One of the lattice's altitudes [m]. They crowd at the ground: with s the root of an altitude over the air's height, its place is
/// p = 3 s / (s + 2): steps of s are two thirds of even ones at the ground, one and a half times as long at the top.
/// @param index [1] in 0..2
FN Float precomputed_altitude(IN(Air) air, IN(Lattice) lattice, Float index) {
  Float part = clamp(index * (1.0 / (lattice.altitudes - 1.0)), 0.0, 1.0);
  Float root = 2.0 * part / (3.0 - part);
  return root * root * air.top_altitude;
}
/// Its inverse: how many altitudes lie below one [1].
/// @param altitude [m] in 0..1e4
FN Float precomputed_altitude_place(IN(Air) air, IN(Lattice) lattice, Float altitude) {
  Float root = sqrt(clamp(altitude * (1.0 / air.top_altitude), 0.0, 1.0));
  return 3.0 * root / (root + 2.0) * (lattice.altitudes - 1.0);
}

/// One of the directions that light comes from; the x axis points to the Sun's azimuth [1]. Rings crowd at the horizon on both sides of it.
/// @param index [1] in 0..4
/// @param horizon [1] in -0.5..0  mu_horizon
/// @param solid_angle [sr]  of the direction alone, without its mirror image
FN Vec3 precomputed_direction(IN(Lattice) lattice, Float index, Float horizon, OUT(Float) solid_angle) {
  Float ring = floor((index + 0.5) * (1.0 / lattice.sectors));
  Float azimuth = (index - ring * lattice.sectors + 0.5) * (3.14159265358979 / lattice.sectors);
  Scalar half_rings = 0.5 * lattice.rings;
  Bool below = ring > half_rings - 0.5;
  // The midpoint rule after a substitution whose derivative vanishes at both ends: of order 4. In twilight most light comes from a strip
  // along the horizon narrower than a degree: with 3 t^2 - 2 t^3, deep twilight was a fifth too dark.
  Float t = (select(below, ring - half_rings, ring) + 0.5) * (1.0 / half_rings);
  Float part = t * t * t * (4.0 - 3.0 * t);
  Float span = select(below, -(1.0 + horizon), 1.0 - horizon);
  Float mu = horizon + part * span;
  solid_angle = abs(span) * 12.0 * t * t * (1.0 - t) * (3.14159265358979 / lattice.sectors) * (1.0 / half_rings);
  Float across = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
  return Vec3(across * cos(azimuth), across * sin(azimuth), mu);
}

/// -ln of what the air sends into a direction, per solar irradiance and scattering coefficient [1/sr].
FN Vec4 precomputed_source_at(IN(Air) air, IN(Lattice) lattice, Table3 source, Float altitude, Float mu, Float mu_s, Float nu) {
  Float across = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0)) * sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0));
  // With the view or the Sun at the zenith azimuth means nothing, and the source does not depend on it.
  Float azimuth = arc_cosine((nu - mu * mu_s) / max(across, 1.0e-6));
  Float w = half_texel(azimuth * 0.318309886183791, lattice.azimuths);
  Float u = half_texel(precomputed_sun_place(air, mu_s), lattice.suns);
  Float zenith = half_texel(arc_cosine(mu) * 0.318309886183791, lattice.zeniths);
  Float height = precomputed_altitude_place(air, lattice, altitude);
  Float band = min(floor(height), lattice.altitudes - 2.0);
  Vec4 lower = lookup(source, Vec3(u, (band + zenith) * (1.0 / lattice.altitudes), w));
  Vec4 upper = lookup(source, Vec3(u, (band + 1.0 + zenith) * (1.0 / lattice.altitudes), w));
  return mix(lower, upper, height - band);
}
