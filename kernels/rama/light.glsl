#pragma once
#include "rama/air.glsl"
#include "rama/warp.glsl"
// Light of Rama's six strips: what the air scatters at a place, what reaches a surface, what a ray gathers.
//
// `lights` has a strip a column; row 0: radius [km], cosine and sine of its angle, radiance [W m^-2 sr^-1]; row 1: its ends and its width [km]

// A strip seen from a place is integrated over psi, the angle of its points about its foot: x = q.x + distance tan(psi). The integrand
// is smooth there; three-point Gauss in eight parts is exact to 1e-9, in two parts to 1e-4.

/// One strip's light at a place, a sum over its visible points: of solid angle times transmittance, and, where `phased` is 1, four pi times
/// Rayleigh's phase towards `view` [sr].
FN_SHARED Vec4 rama_strip(IN(Rama) rama, Table2 lights, int l, Vec3 q, Vec3 view, Scalar phased) {
  Scalar4 place = fetch_scalar(lights, l, 0);
  Scalar4 ends = fetch_scalar(lights, l, 1);
  Float height = max(place.x - (q.y * place.y + q.z * place.z), 0.0);
  Float side = q.z * place.y - q.y * place.z;
  Float square = max(height * height + side * side, 1.0e-10);
  Float distance = sqrt(square);
  Vec2 seen = rama_visible(q, place.x, place.y, place.z, ends.x, ends.y);
  Float first = arc_tangent2(seen.x - q.x, distance);
  Float part = max(arc_tangent2(seen.y - q.x, distance) - first, 0.0) * (1.0 / 8.0);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 24; ++i) {
    int third = i - 3 * (i / 3);
    Float weight = Float(5.0 / 18.0);
    Float node = Float(0.112701665379258);
    if (third == 1) {
      weight = Float(4.0 / 9.0);
      node = Float(0.5);
    }
    if (third == 2) node = Float(0.887298334620742);
    Float psi = first + part * (Float(i / 3) + node);
    Float c = cos(psi);
    Vec3 s = Vec3(q.x + distance * sin(psi) / max(c, 1.0e-6), Float(place.x * place.y), Float(place.x * place.z));
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
    Float height = max(place.x - (p.y * place.y + p.z * place.z), 0.0);
    Float side = p.z * place.y - p.y * place.z;
    Float square = max(height * height + side * side, 1.0e-6);
    Float distance = sqrt(square);
    Vec2 seen = rama_visible(p, place.x, place.y, place.z, ends.x, ends.y);
    Float first = arc_tangent2(seen.x - p.x, distance);
    Float part = max(arc_tangent2(seen.y - p.x, distance) - first, 0.0) * 0.5;
    Vec4 sum = Vec4(0.0);
    for (int i = 0; i < 6; ++i) {
      int third = i - 3 * (i / 3);
      Float weight = Float(5.0 / 18.0);
      Float node = Float(0.112701665379258);
      if (third == 1) {
        weight = Float(4.0 / 9.0);
        node = Float(0.5);
      }
      if (third == 2) node = Float(0.887298334620742);
      Float psi = first + part * (Float(i / 3) + node);
      Float c = cos(psi);
      Vec3 s = Vec3(p.x + distance * sin(psi) / max(c, 1.0e-6), Float(place.x * place.y), Float(place.x * place.z));
      Vec4 through = Vec4(1.0);
      if (rama.air > 0.5) through = rama_through(rama, rama_depth_fast(rama, s, p));
      sum = sum + through * (weight * c * c * max(dot(normal, s - p), 0.0));
    }
    total = total + sum * (part * ends.z * height / (square * distance) * place.w);
  }
  return total;
}
