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
  Scalar show;      // [1] in 0..2  0: the picture; 1: slice of J through the axis and the eye; 2: across it, at the eye
  Scalar pad0;      // [1] in 0..1
  Scalar pad1;      // [1] in 0..1
  Scalar pad2;      // [1] in 0..1
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
  // The cliff's face lies in the plane where sea and land meet: rounding would mix both.
  Bool bare = (p.x > 16.0) || (p.x < -16.5) || ((abs(p.x + 5.0) < 0.002) && (rama_square(p) < 63.9));
  // Fields and woods: a pattern to see distances by, its mean 1.
  Float angle = arc_tangent2(p.z, p.y);
  Float large = sin(5.3 * p.x + 3.0 * sin(4.0 * angle)) * sin(31.0 * angle + 2.0 * sin(1.7 * p.x));
  Float small = sin(23.0 * p.x + 5.0 * sin(9.0 * angle)) * sin(173.0 * angle);
  Float shade = rama.albedo.x * (1.0 + 0.35 * large + 0.2 * small);
  Vec4 land = Vec4(shade * (0.9 + 0.2 * large), shade * 1.1, shade * (0.7 - 0.1 * large), Float(0.0));
  Vec4 rock = Vec4(rama.albedo.x * 1.1, rama.albedo.x * 1.05, Float(rama.albedo.x), Float(0.0));
  Vec4 water = Vec4(rama.albedo.x * 0.15, rama.albedo.x * 0.3, rama.albedo.x * 0.5, Float(0.0));
  return clamp(select(bare, rock, select(sea, water, land)), 0.0, 1.0);
}

/// Light that leaves the hull at a place [W m^-2 sr^-1].
FN_SHARED Vec4 rama_surface(IN(Rama) rama, Table2 lights, Vec3 p, Vec3 normal) {
  // The cliff's face lies in the plane that its shadows begin at: from a metre before it, all of it sees north.
  Vec3 before = Vec3(p.x + 0.001 * normal.x, p.y, p.z);
  Vec4 light = rama_irradiance(rama, lights, before, normal) * rama_albedo(rama, p) * 0.318309886183791;
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

/// Light that the air of a plane scatters [W m^-2 sr^-1 km^-1], 0 outside the hull. Along the axis: x to the right from end to end, the
/// eye's side below; across it: the strip at 0 degrees is above, the southern end behind.
FN_SHARED Vec4 rama_slice(IN(Rama) rama, IN(RamaEye) eye, IN(GridSize) size, Table2 lights, Table3 source, Vec2 uv) {
  Float x = Float(eye.x);
  Float y = 8.0 - 16.0 * uv.y;
  Float z = (16.0 * uv.x - 8.0) * (size.width / size.height);
  if (eye.show < 1.5) {
    // As many kilometres a pixel both ways, and the whole hull: 48 km by 16, 27 where the picture is 16 to 9.
    Float scale = max(Float(48.0), Float(16.0 * size.width / size.height));
    x = scale * (uv.x - 0.5);
    Float r = scale * (uv.y - 0.5) * (size.height / size.width);
    y = r * eye.c;
    z = r * eye.s;
  }
  Vec3 q = Vec3(x, y, z);
  Float beyond = select(x > 16.0, x - 16.0, select(x < -16.5, x + 16.5, 0.0));
  Float wall = select(x < -5.0, Float(56.25), Float(64.0));
  Vec4 light = Vec4(0.0);
  if (rama.exact > 0.5) {
    light = rama_source(rama, lights, q, Vec3(1.0, 0.0, 0.0), 0.0);
  } else {
    light = lookup(source, rama_texture_coordinate(q));
  }
  return select(rama_square(q) + beyond * beyond < wall, light, Vec4(0.0));
}

/// A picture of Rama, linear sRGB [cd/m^2].
FN Vec4 rama_picture_pass(IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Rama) rama, IN(RamaEye) eye, IN(GridSize) size, Table2 lights, Table3 source, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 d = rama_frame(eye, camera_view(camera, uv, inside));
  Vec3 p = rama_eye(eye, Float(observer.altitude));
  Vec3 normal = Vec3(0.0, 0.0, 0.0);
  Vec3 q = p + d * rama_hull(p, d, normal);
  Vec4 through = Vec4(1.0);
  if (rama.air > 0.5) {
    if (rama.fast > 0.5) {
      through = rama_transmittance_fast(rama, p, q);
    } else {
      through = rama_transmittance(rama, p, q);
    }
  }
  Vec4 light = Vec4(0.0);
  if (eye.show > 0.5) {
    light = rama_slice(rama, eye, size, lights, source, uv);
    inside = Float(1.0);
  } else {
    light = rama_gather(rama, lights, source, p, q) + rama_surface(rama, lights, q, normal) * through;
  }
  return display_colour(display, light) * inside;
}
