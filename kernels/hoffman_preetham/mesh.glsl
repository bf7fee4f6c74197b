#pragma once
#include "hoffman_preetham/sky.glsl"
// The vertex renderer: the formula at the corners of the dome's triangles, and what a rasteriser makes of it between them. The mesh has
// the dome's shape and the viewer in its middle: columns of equal azimuth, rings that crowd towards the horizon,
// zenith_k = 90 (1 - (1 - k / last)^2) degrees. A skirt repeats the horizon's ring below it.

struct DomeMesh {
  Scalar columns;  // [1] in 8..256  of triangles around; the table of corners repeats the first behind the last
  Scalar rings;    // [1] in 9..129  of corners, the zenith's included
  Scalar pad0;     // [1] in 0..1
  Scalar pad1;     // [1] in 0..1
};

/// Colour of each corner (column u, ring v) [1/sr]; its place [m].
FN Vec4 hoffman_preetham_corners_pass(IN(HoffmanPreetham) hoffman_preetham, IN(DomeMesh) mesh, IN(SunDirection) sun_direction, Table2 sunlight, Vec2 uv, OUT(Vec4) corner_places) {
  Float ring = floor(uv.y * mesh.rings) * (1.0 / (mesh.rings - 1.0));
  Float zenith = (1.0 - (1.0 - ring) * (1.0 - ring)) * 1.57079632679490;
  Float azimuth = floor(uv.x * (mesh.columns + 1.0)) * (6.28318530717959 / mesh.columns);
  Float across = sin(zenith);
  Vec3 view = Vec3(across * sin(azimuth), across * cos(azimuth), max(cos(zenith), 0.0));
  Vec3 sun = Vec3(sun_direction.direction.x, sun_direction.direction.y, sun_direction.direction.z);
  Vec3 left = sun;
  Vec3 light = hoffman_preetham_dome_light(hoffman_preetham, view.z, one_minus_cos(view, sun), xyz(Vec4(fetch_scalar(sunlight, 0, 0))), left);
  light = hoffman_preetham_kept(hoffman_preetham, light, Float(hoffman_preetham.exposure));
  Vec3 place = view * hoffman_preetham_rayleigh_dome(hoffman_preetham, view.z);
  corner_places = Vec4(place.x, place.y, place.z, Float(0.0));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// Six times the volume between three vectors.
/// @param a [1] in -1..1
/// @param b [1] in -1..1
/// @param c [1] in -1..1
FN Float hoffman_preetham_volume(Vec3 a, Vec3 b, Vec3 c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

/// A corner's place [m]; one ring below the horizon's, two degrees down, ends the skirt.
FN Vec3 hoffman_preetham_corner(IN(DomeMesh) mesh, Table2 corner_places, Float column, Float ring) {
  Vec3 place = xyz(fetch(corner_places, column, min(ring, Float(mesh.rings - 1.0))));
  Float down = sqrt(place.x * place.x + place.y * place.y) * 0.0349207694917477;
  return Vec3(place.x, place.y, select(ring > mesh.rings - 0.5, -down, place.z));
}

/// The triangle of the mesh in a direction: its quad's column and ring, and those of the corner that is not on the quad's diagonal. The
/// diagonal runs from the upper left to the lower right.
FN Vec4 hoffman_preetham_triangle(IN(DomeMesh) mesh, Table2 corner_places, Vec3 view) {
  Float turn = arc_tangent2(view.x, view.y) * 0.159154943091895;
  Float around = clamp(turn - floor(turn), 0.0, 1.0) * mesh.columns;
  Float column = min(floor(around), Float(mesh.columns - 1.0));
  // Edges of rings are chords, which sag below the ring's zenith angle between two corners: seen from the middle they lie in a plane,
  // in which tan(zenith) cos(azimuth from the column's middle) is that of the corners.
  Scalar half_column = 3.14159265358979 / mesh.columns;
  Float across = sqrt(view.x * view.x + view.y * view.y) * cos((around - column - 0.5) * (2.0 * half_column));
  Float zenith = arc_tangent2(across, max(view.z, 0.0) * cos(Float(half_column)));
  Float rest = sqrt(clamp(1.0 - zenith * 0.636619772367581, 0.0, 1.0));
  Float ring = clamp(floor((mesh.rings - 1.0) * (1.0 - rest)), 0.0, mesh.rings - 2.0);
  ring = select(view.z < 0.0, Float(mesh.rings - 1.0), ring);
  Vec3 upper_left = hoffman_preetham_corner(mesh, corner_places, column, ring);
  Vec3 lower_right = hoffman_preetham_corner(mesh, corner_places, column + 1.0, ring + 1.0);
  // Which side of the plane through the diagonal and the eye. At the zenith the other triangle has no area.
  Bool left_side = (hoffman_preetham_volume(upper_left, lower_right, view) > 0.0) || (ring < 0.5);
  return Vec4(column, ring, select(left_side, column, column + 1.0), select(left_side, ring + 1.0, ring));
}

/// The mesh in a direction: its corners' colours, interpolated over the triangle that the view ray hits [1/sr].
FN Vec3 hoffman_preetham_mesh_colour(IN(DomeMesh) mesh, Table2 corners, Table2 corner_places, Vec3 view) {
  // Below the horizon the skirt: the colour straight above, on the horizon.
  Vec3 d = Vec3(view.x, view.y, max(view.z, 0.0));
  Vec4 at = hoffman_preetham_triangle(mesh, corner_places, d);
  Vec3 upper_left = xyz(fetch(corner_places, at.x, at.y));
  Vec3 lower_right = xyz(fetch(corner_places, at.x + 1.0, at.y + 1.0));
  Vec3 third = xyz(fetch(corner_places, at.z, at.w));
  // d = a A + b B + c C: the weights of a point of the triangle are in proportion.
  Float a = abs(hoffman_preetham_volume(d, lower_right, third));
  Float b = abs(hoffman_preetham_volume(upper_left, d, third));
  Float c = abs(hoffman_preetham_volume(upper_left, lower_right, d));
  Float all = 1.0 / max(a + b + c, 1.0e-20);
  return xyz(fetch(corners, at.x, at.y)) * (a * all) + xyz(fetch(corners, at.x + 1.0, at.y + 1.0)) * (b * all) + xyz(fetch(corners, at.z, at.w)) * (c * all);
}

/// Sine of the angle between a direction and the plane through the eye and an edge [1].
/// @param view [1] in -0.577..0.577
/// @param a [m] in 1e3..1e5
/// @param b [m] in -1e5..-1e3
FN Float hoffman_preetham_from_edge(Vec3 view, Vec3 a, Vec3 b) {
  Vec3 n = Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return abs(dot(view, n)) / sqrt(max(dot(n, n), 1.0e-20));
}

/// A picture of the dome's mesh and its skirt as wires a pixel and a half wide, white on half its colours, linear sRGB [cd/m^2].
FN Vec4 hoffman_preetham_wire_picture_pass(IN(HoffmanPreetham) hoffman_preetham, IN(DomeMesh) mesh, IN(Camera) camera, IN(Display) display, Table2 corners, Table2 corner_places, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec4 at = hoffman_preetham_triangle(mesh, corner_places, view);
  Vec3 upper_left = hoffman_preetham_corner(mesh, corner_places, at.x, at.y);
  Vec3 lower_right = hoffman_preetham_corner(mesh, corner_places, at.x + 1.0, at.y + 1.0);
  Vec3 third = hoffman_preetham_corner(mesh, corner_places, at.z, at.w);
  Float apart = min(hoffman_preetham_from_edge(view, upper_left, lower_right), min(hoffman_preetham_from_edge(view, upper_left, third), hoffman_preetham_from_edge(view, lower_right, third)));
  Float wire = clamp(1.25 - apart * (1.0 / display.disc_edge), 0.0, 1.0);
  // Under the skirt there is nothing.
  inside = inside * select(view.z < -0.0349207694917477 * sqrt(view.x * view.x + view.y * view.y), Float(0.0), Float(1.0));
  Vec3 light = hoffman_preetham_mesh_colour(mesh, corners, corner_places, view) * (0.5 - 0.5 * wire) + Vec3(wire, wire, wire) * (1.0 / hoffman_preetham.exposure);
  return display_colour(display, Vec4(light.x, light.y, light.z, Float(0.0))) * inside;
}

/// A picture of the dome's mesh, linear sRGB [cd/m^2].
FN Vec4 hoffman_preetham_vertex_picture_pass(IN(DomeMesh) mesh, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 sunlight, Table2 corners, Table2 corner_places, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec3 light = hoffman_preetham_mesh_colour(mesh, corners, corner_places, view);
  return hoffman_preetham_shown(display, xyz(Vec4(fetch_scalar(sunlight, 0, 0))), light, one_minus_cos(view, sun), view.z) * inside;
}

/// The air before corners of land's triangles, by the formula at each, and the sky of the dome's mesh [1/sr]; transmittance [1]. Between its
/// corners land has what lies between their values.
FN Vec4 hoffman_preetham_vertex_haze_pass(IN(HoffmanPreetham) hoffman_preetham, IN(DomeMesh) mesh, IN(Observer) observer, Table2 sunlight, Table2 corners, Table2 corner_places, Table2 points, Vec2 uv, OUT(Vec4) transmittance) {
  Vec4 sight = fetch_same(points, uv);
  Vec3 view = xyz(sight);
  Bool sky = sight.w > 9.9e14;
  Vec3 left = view;
  Vec3 light = hoffman_preetham_sight(hoffman_preetham, view, sight.w, Vec3(observer.sun.x, observer.sun.y, observer.sun.z), xyz(Vec4(fetch_scalar(sunlight, 0, 0))), left);
  if (any(sky)) light = select(sky, hoffman_preetham_mesh_colour(mesh, corners, corner_places, view), light);
  transmittance = Vec4(left.x, left.y, left.z, Float(0.0));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}
