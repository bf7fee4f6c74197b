#pragma once
#include "core/math.glsl"
// Air inside a spinning cylinder, after E. Bruneton's "Rama" page: density, transmittance, and the shape of what holds it.
// Lengths are kilometres; frame: x along the spin axis, north positive, 0 in the middle of the sea; y, z across.

struct Rama {
  Scalar4 scattering;   // [1/km] in 0..0.4  red, green, blue: of all extinction there is, at 8 km from the axis
  Scalar4 albedo;       // [1] in 0..1  x: mean of the ground
  Scalar kappa;         // [1/km^2] in 0..0.05  density is exp(-kappa (64 - r^2))
  Scalar line_start;    // [1] in 0..1  best straight line for it: line_start + line_rise (r / 8)^2
  Scalar line_rise;     // [1] in 0..1
  Scalar fast;          // [1] in 0..1  1: rays take the straight line
  Scalar samples;       // [1] in 4..128  of a ray
  Scalar exact;         // [1] in 0..2  light of a sample: 0: from the table; 1: its own, isotropic; 2: its own, with Rayleigh's phase
  Scalar air;           // [1] in 0..1  0: none
  Scalar pad;           // [1] in 0..1
};

/// Squared distance from the axis [km^2].
/// @param p [km] in -8..8
FN Float rama_square(Vec3 p) { return p.y * p.y + p.z * p.z; }

/// Density of the air relative to that 8 km from the axis [1]: hydrostatic balance at one temperature under centrifugal force.
/// @param square [km^2] in 0..64
FN Float rama_density(IN(Rama) rama, Float square) { return exp(-rama.kappa * (64.0 - square)); }

/// Length of air between two places, reduced to the density 8 km from the axis [km]: six-point Gauss-Legendre, error below 1e-8.
/// @param p [km] in -8..8
/// @param q [km] in -8..8
FN Float rama_depth(IN(Rama) rama, Vec3 p, Vec3 q) {
  Vec3 d = q - p;
  // r^2 = middle + u (slope + u rise) for u in -1..1
  Vec3 m = 0.5 * (p + q);
  Float middle = rama_square(m);
  Float slope = m.y * d.y + m.z * d.z;
  Float rise = 0.25 * rama_square(d);
  Float a = 0.238619186083197;
  Float b = 0.661209386466265;
  Float c = 0.932469514203152;
  Float sum = 0.233956967286346 * (rama_density(rama, middle + a * (slope + a * rise)) + rama_density(rama, middle - a * (slope - a * rise))) +
              0.180380786524069 * (rama_density(rama, middle + b * (slope + b * rise)) + rama_density(rama, middle - b * (slope - b * rise))) +
              0.085662246189585 * (rama_density(rama, middle + c * (slope + c * rise)) + rama_density(rama, middle - c * (slope - c * rise)));
  return sum * sqrt(dot(d, d));
}

/// The same with density a straight line in r^2: its integral is exact, its density wrong by up to 0.011 [km].
/// @param p [km] in -8..8
/// @param q [km] in -8..8
FN Float rama_depth_fast(IN(Rama) rama, Vec3 p, Vec3 q) {
  Vec3 d = q - p;
  Float square = (rama_square(p) + p.y * q.y + p.z * q.z + rama_square(q)) * (1.0 / 3.0);
  return sqrt(dot(d, d)) * (rama.line_start + rama.line_rise * (1.0 / 64.0) * square);
}

/// Transmittance of a reduced length of air [1]; w is 1.
/// @param depth [km] in 0..60
FN Vec4 rama_through(IN(Rama) rama, Float depth) {
  return Vec4(exp(-rama.scattering.x * depth), exp(-rama.scattering.y * depth), exp(-rama.scattering.z * depth), Float(1.0));
}

/// Transmittance between two places [1].
/// @param p [km] in -8..8
/// @param q [km] in -8..8
FN Vec4 rama_transmittance(IN(Rama) rama, Vec3 p, Vec3 q) { return rama_through(rama, rama_depth(rama, p, q)); }

/// Transmittance between two places, with density a straight line in r^2 [1].
/// @param p [km] in -8..8
/// @param q [km] in -8..8
FN Vec4 rama_transmittance_fast(IN(Rama) rama, Vec3 p, Vec3 q) { return rama_through(rama, rama_depth_fast(rama, p, q)); }

/// Which part of a light strip a place sees past the cliff, the ring at x = -5 between r = 7.5 and 8: its ends along the axis [km], the
/// first not smaller than the second where it sees none.
/// @param q [km] in -7..7
/// @param radius [km] in 7.5..8  of the strip
/// @param c [1] in -1..1  cosine and
/// @param s [1] in -1..1  sine of its angle
/// @param x1 [km] in -17..-16
/// @param x2 [km] in -15..-5
/// @bound 2e-2 scale 10   where a line of sight touches the edge, the root of the discriminant has half the digits
FN Vec2 rama_visible(Vec3 q, Scalar radius, Scalar c, Scalar s, Scalar x1, Scalar x2) {
  // A line of sight from q to the strip passes x = -5 at the part f of its way, there r^2 is a quadratic of f: open between its roots.
  Float y = radius * c - q.y;
  Float z = radius * s - q.z;
  Float a = max(y * y + z * z, 1.0e-12);
  Float b = q.y * y + q.z * z;
  Float k = rama_square(q) - 56.25;
  Float discriminant = b * b - a * k;
  Float root = sqrt(max(discriminant, 0.0));
  // The root whose sum would cancel comes from the product of both.
  Float large = abs(b) + root;
  Float first = select(b > 0.0, -large / a, k / max(large, 1.0e-12));
  Float second = select(b > 0.0, -k / max(large, 1.0e-12), large / a);
  Float away = abs(q.x + 5.0);
  Float farthest = select(first > 1.0e-6, away / max(first, 1.0e-6), 1.0e6);
  Float nearest = select(second > 1.0e-6, away / max(second, 1.0e-6), 1.0e6);
  Bool north = q.x >= -5.0;
  Float low = select(north, q.x - farthest, q.x + nearest);
  Float high = select(north, q.x - nearest, q.x + farthest);
  // Strips end before the cliff: all of one lies on one side.
  Bool across = select(north, Float(-5.0 - x2), Float(x1 + 5.0)) >= 0.0;
  Bool open = discriminant > 0.0;
  Float from = select(across, max(low, Float(x1)), Float(x1));
  Float to = select(across, select(open, max(min(high, Float(x2)), Float(x1)), Float(x1)), Float(x2));
  return Vec2(from, to);
}

/// How much of the way between two places is open: 0 where the cliff stands between them [1].
/// @param a [km] in -16..16
/// @param b [km] in -16..16
/// @bound 1.0 scale 1   a decision at the cliff's edge
FN Float rama_sees(Vec3 a, Vec3 b) {
  Float from = a.x + 5.0;
  Float to = b.x + 5.0;
  Float f = from / select(abs(from - to) > 1.0e-9, from - to, 1.0e-9);
  Float y = a.y + f * (b.y - a.y);
  Float z = a.z + f * (b.z - a.z);
  return select((from * to < 0.0) && (y * y + z * z > 56.25), Float(0.0), Float(1.0));
}

/// Solid angle of a narrow strip's line, before its width shows [sr].
/// @param q [km] in -7..7
/// @param radius [km] in 7.5..8
/// @param c [1] in -1..1
/// @param s [1] in -1..1
/// @param x1 [km] in -17..-16
/// @param x2 [km] in -15..-5
/// @param width [km] in 0.05..0.2
/// @bound 1e-3 scale 1   close to the strip's line its height over the place cancels
FN Float rama_solid_angle(Vec3 q, Scalar radius, Scalar c, Scalar s, Scalar x1, Scalar x2, Scalar width) {
  Float height = max(radius - (q.y * c + q.z * s), 0.0);
  Float side = q.z * c - q.y * s;
  Float square = max(height * height + side * side, 1.0e-10);
  Float u = x1 - q.x;
  Float v = x2 - q.x;
  return width * height / square * (v / sqrt(v * v + square) - u / sqrt(u * u + square));
}
