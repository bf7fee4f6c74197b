#pragma once
#include "core/picture.glsl"
#include "core/tables.glsl"
#include "rama/hull.glsl"
#include "rama/light.glsl"
// Rama's answers: the table of scattered light, places, rays, pictures. World frame: east, north, up, up being towards the axis.

struct RamaEye {
  Scalar x;         // [km] in -24..24  along the axis
  Scalar c;         // [1] in -1..1  cosine and
  Scalar s;         // [1] in -1..1  sine of the angle about it
  Scalar radius;    // [km] in 7.5..8  of the ground that altitudes are counted from
};

/// A direction or difference of the world in Rama's frame [1].
/// @param v [1] in -1..1
FN Vec3 rama_frame(IN(RamaEye) eye, Vec3 v) {
  return Vec3(v.y, v.x * eye.s - v.z * eye.c, -v.x * eye.c - v.z * eye.s);
}

/// Place of an observer at an altitude [km].
/// @param altitude [m] in 0..8000
FN Vec3 rama_eye(IN(RamaEye) eye, Float altitude) {
  Float r = eye.radius - altitude * 0.001;
  return Vec3(Float(eye.x), r * eye.c, r * eye.s);
}

/// Light that a texel's air scatters to all sides [W m^-2 sr^-1 km^-1].
FN Vec4 rama_source_pass(IN(Rama) air_of_table, Table2 lights, Vec3 uvw) {
  Vec3 q = rama_texel_point(floor(uvw.x * 49.0), floor(uvw.y * 33.0), floor(uvw.z * 33.0));
  return rama_source(air_of_table, lights, q, Vec3(1.0, 0.0, 0.0), 0.0);
}

/// Light that the air at places scatters to all sides [W m^-2 sr^-1 km^-1].
FN Vec4 rama_places_pass(IN(Rama) rama, Table2 lights, Table2 places, Vec2 uv) {
  return rama_source(rama, lights, xyz(fetch_same(places, uv)), Vec3(1.0, 0.0, 0.0), 0.0);
}

/// Light that the air adds between places [W m^-2 sr^-1].
FN Vec4 rama_between_pass(IN(Rama) rama, Table2 lights, Table3 source, Table2 places, Table2 ends, Vec2 uv) {
  return rama_gather(rama, lights, source, xyz(fetch_same(places, uv)), xyz(fetch_same(ends, uv)));
}

/// Albedo of the hull at a place [1]: fields on the plains, dark water, grey cliff and caps.
/// @param p [km] in -8..8
FN Vec4 rama_albedo(IN(Rama) rama, Vec3 p) {
  Bool sea = (abs(p.x) < 5.0) && (rama_square(p) > 57.0);
  Bool cap = (p.x > 16.0) || (p.x < -16.5);
  // Fields and woods: a pattern to see distances by, its mean 1.
  Float angle = arc_tangent2(p.z, p.y);
  Float large = sin(5.3 * p.x + 3.0 * sin(4.0 * angle)) * sin(31.0 * angle + 2.0 * sin(1.7 * p.x));
  Float small = sin(23.0 * p.x + 5.0 * sin(9.0 * angle)) * sin(173.0 * angle);
  Float shade = rama.albedo.x * (1.0 + 0.35 * large + 0.2 * small);
  Vec4 land = Vec4(shade * (0.9 + 0.2 * large), shade * 1.1, shade * (0.7 - 0.1 * large), Float(0.0));
  Vec4 rock = Vec4(rama.albedo.x * 1.1, rama.albedo.x * 1.05, Float(rama.albedo.x), Float(0.0));
  Vec4 water = Vec4(rama.albedo.x * 0.15, rama.albedo.x * 0.3, rama.albedo.x * 0.5, Float(0.0));
  return clamp(select(sea, water, select(cap, rock, land)), 0.0, 1.0);
}

/// Light that leaves the hull at a place [W m^-2 sr^-1].
FN_SHARED Vec4 rama_surface(IN(Rama) rama, Table2 lights, Vec3 p, Vec3 normal) {
  Vec4 light = rama_irradiance(rama, lights, p, normal) * rama_albedo(rama, p) * 0.318309886183791;
  int count = int(width_of(lights));
  for (int l = 0; l < count; ++l) {
    Scalar4 place = fetch_scalar(lights, l, 0);
    Scalar4 ends = fetch_scalar(lights, l, 1);
    Float side = p.z * place.y - p.y * place.z;
    Bool strip = (abs(side) < 0.5 * ends.z) && (p.y * place.y + p.z * place.z > 0.0) && (p.x > ends.x) && (p.x < ends.y);
    light = select(strip, Vec4(place.w), light);
  }
  return light;
}

/// The air's light along rays that end on the hull, or before it [W m^-2 sr^-1]; transmittance; the hull's light, attenuated.
FN Vec4 rama_rays_pass(IN(Rama) rama, IN(RamaEye) eye, Table2 lights, Table3 source, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 from = fetch_same(eyes, uv);
  Vec3 p = rama_eye(eye, from.x);
  Vec3 d = rama_frame(eye, Vec3(from.y, from.z, from.w));
  Float distance = fetch_same(suns, uv).x * 0.001;
  Vec3 normal = Vec3(0.0, 0.0, 0.0);
  Float reach = rama_hull(p, d, normal);
  Vec3 q = p + d * min(distance, reach);
  transmittance = rama_transmittance(rama, p, q);
  if (rama.air < 0.5) transmittance = Vec4(1.0);
  ground = select(distance >= reach, rama_surface(rama, lights, q, normal) * transmittance, Vec4(0.0));
  return rama_gather(rama, lights, source, p, q);
}

/// A picture of Rama, linear sRGB [cd/m^2].
FN Vec4 rama_picture_pass(IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Rama) rama, IN(RamaEye) eye, Table2 lights, Table3 source, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 d = rama_frame(eye, camera_view(camera, uv, inside));
  Vec3 p = rama_eye(eye, Float(observer.altitude));
  Vec3 normal = Vec3(0.0, 0.0, 0.0);
  Vec3 q = p + d * rama_hull(p, d, normal);
  Vec4 through = rama_transmittance_fast(rama, p, q);
  if (rama.air < 0.5) through = Vec4(1.0);
  Vec4 light = rama_gather(rama, lights, source, p, q) + rama_surface(rama, lights, q, normal) * through;
  return display_colour(display, light) * inside;
}
