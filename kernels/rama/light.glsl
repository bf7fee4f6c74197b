#pragma once
#include "rama/air.glsl"
#include "rama/warp.glsl"
// Light of Rama's six strips: what the air scatters at a place, what reaches a surface, what a ray gathers.
//
// `lights` has a strip a column; row 0: radius [km], cosine and sine of its angle, radiance [W m^-2 sr^-1]; row 1: its ends and its width [km]

// A strip seen from a place is integrated over psi, the angle of its points about its foot: x = q.x + distance tan(psi). The integrand
// is smooth there; three-point Gauss in eight parts is exact to 1e-9, in two parts to 1e-4.

/// A strip seen from a place: the place's height over the strip's plane [km]; its squared distance from the strip's line [km^2], psi where
/// the visible part begins, how much of psi there is [rad].
FN Float rama_foot(Table2 lights, int l, Vec3 q, Scalar least_square, OUT(Float) square, OUT(Float) first, OUT(Float) wide) {
  Scalar4 place = fetch_scalar(lights, l, 0);
  Scalar4 ends = fetch_scalar(lights, l, 1);
  Float height = max(place.x - (q.y * place.y + q.z * place.z), 0.0);
  Float side = q.z * place.y - q.y * place.z;
  square = max(height * height + side * side, least_square);
  Vec2 seen = rama_visible(q, place.x, place.y, place.z, ends.x, ends.y);
  first = arc_tangent2(seen.x - q.x, sqrt(square));
  wide = max(arc_tangent2(seen.y - q.x, sqrt(square)) - first, 0.0);
  return height;
}
/// The strip's point at an angle psi [km]; the angle's cosine.
FN Vec3 rama_strip_point(Table2 lights, int l, Vec3 q, Float distance, Float psi, OUT(Float) c) {
  Scalar4 place = fetch_scalar(lights, l, 0);
  c = cos(psi);
  return Vec3(q.x + distance * sin(psi) / max(c, 1.0e-6), Float(place.x * place.y), Float(place.x * place.z));
}

/// One strip's light at a place, a sum over its visible points: of solid angle times transmittance, and, where `phased` is 1, four pi times
/// Rayleigh's phase towards `view` [sr].
FN_SHARED Vec4 rama_strip(IN(Rama) rama, Table2 lights, int l, Vec3 q, Vec3 view, Scalar phased) {
  Scalar4 place = fetch_scalar(lights, l, 0);
  Scalar4 ends = fetch_scalar(lights, l, 1);
  Float square = Float(0.0);
  Float first = Float(0.0);
  Float wide = Float(0.0);
  Float height = rama_foot(lights, l, q, 1.0e-10, square, first, wide);
  Float distance = sqrt(square);
  Float part = wide * (1.0 / 8.0);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 24; ++i) {
    Vec2 point = gauss_three(i);
    Float weight = point.y;
    Float c = Float(0.0);
    Vec3 s = rama_strip_point(lights, l, q, distance, first + part * (Float(i / 3) + point.x), c);
    if (phased > 0.5) {
      Float mu = dot(s - q, view) * c / distance;
      weight = weight * 0.75 * (1.0 + mu * mu);
    }
    sum = sum + rama_transmittance(rama, s, q) * (weight * c);
  }
  sum = sum * (part * ends.z * height / square);
  // The line has no width: near it its light would grow without bound, the strip's does not.
  Float omega = rama_solid_angle(q, place.x, place.y, place.z, ends.x, ends.y, ends.z);
  Vec4 capped = sum * (6.28318530717959 / max(omega, 6.28318530717959));
  Bool on = (square < 1.0e-8) && (q.x > ends.x) && (q.x < ends.y);
  return select(on, Vec4(6.28318530717959), capped);
}

/// Light that the air at a place scatters, a kilometre of it [W m^-2 sr^-1 km^-1]: equally to all sides, or towards `view`.
FN_SHARED Vec4 rama_source(IN(Rama) rama, Table2 lights, Vec3 q, Vec3 view, Scalar phased) {
  Vec4 sum = Vec4(0.0);
  int count = int(width_of(lights));
  for (int l = 0; l < count; ++l) sum = sum + rama_strip(rama, lights, l, q, view, phased) * fetch_scalar(lights, l, 0).w;
  return sum * Vec4(rama.scattering) * (rama_density(rama, rama_square(q)) * 0.0795774715459477);
}

/// Light that the air adds between two places [W m^-2 sr^-1].
FN_SHARED Vec4 rama_gather(IN(Rama) rama, Table2 lights, Table3 source, Vec3 c, Vec3 p) {
  Vec3 d = p - c;
  Float length = sqrt(dot(d, d));
  Vec3 view = d * (1.0 / max(length, 1.0e-9));
  int count = int(rama.samples);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < count; ++i) {
    Vec3 q = c + d * ((Float(i) + 0.5) * (1.0 / rama.samples));
    Vec4 light = Vec4(0.0);
    if (rama.exact > 0.5) {
      light = rama_source(rama, lights, q, view, rama.exact - 1.0);
    } else {
      light = lookup(source, rama_texture_coordinate(q));
    }
    Vec4 through = Vec4(0.0);
    if (rama.fast > 0.5) {
      through = rama_transmittance_fast(rama, c, q);
    } else {
      through = rama_transmittance(rama, c, q);
    }
    sum = sum + through * light;
  }
  return sum * (length * (rama.air / rama.samples));
}

/// Irradiance of a surface [W m^-2]: each strip in two parts of three-point Gauss.
FN_SHARED Vec4 rama_irradiance(IN(Rama) rama, Table2 lights, Vec3 p, Vec3 normal) {
  Vec4 total = Vec4(0.0);
  int count = int(width_of(lights));
  for (int l = 0; l < count; ++l) {
    Scalar4 place = fetch_scalar(lights, l, 0);
    Scalar4 ends = fetch_scalar(lights, l, 1);
    Float square = Float(0.0);
    Float first = Float(0.0);
    Float wide = Float(0.0);
    Float height = rama_foot(lights, l, p, 1.0e-6, square, first, wide);
    Float distance = sqrt(square);
    Float part = wide * 0.5;
    Vec4 sum = Vec4(0.0);
    for (int i = 0; i < 6; ++i) {
      Vec2 point = gauss_three(i);
      Float c = Float(0.0);
      Vec3 s = rama_strip_point(lights, l, p, distance, first + part * (Float(i / 3) + point.x), c);
      Vec4 through = Vec4(1.0);
      if (rama.air > 0.5) through = rama_through(rama, rama_depth_fast(rama, s, p));
      sum = sum + through * (point.y * c * c * max(dot(normal, s - p), 0.0));
    }
    total = total + sum * (part * ends.z * height / (square * distance) * place.w);
  }
  return total;
}
