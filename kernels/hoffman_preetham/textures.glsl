#pragma once
#include "hoffman_preetham/sky.glsl"
// The texture renderer: extinction over distance in one row, light per sunlight over distance and angle in a plane. Rows and columns:
// u = 1 - exp(-distance / 30 km) and w = sine of half the angle from the Sun, first and last texel at 0 and 1.

/// Distance of a texture's coordinate [m], at most 400 km.
/// @param u [1] in 0..1
/// @bound 1e-4 scale 1e5   the last texels are hundreds of kilometres apart
FN Float hoffman_preetham_texture_distance(Float u) { return -30000.0 * ln(max(1.0 - u, 1.6e-6)); }

/// What a distance leaves of light [1].
FN Vec4 hoffman_preetham_extinction_texture_pass(IN(HoffmanPreetham) hoffman_preetham, IN(GridSize) size, Vec2 uv) {
  Float distance = hoffman_preetham_texture_distance(from_half_texel(uv.x, size.width));
  Vec3 depth = Vec3(Float(0.0), Float(0.0), Float(0.0));
  Vec3 light = hoffman_preetham_inscatter(hoffman_preetham, distance, distance, Float(1.0), depth);
  Vec3 left = hoffman_preetham_exp(depth);
  return Vec4(left.x, left.y, left.z, 0.0 * light.x);
}

/// What a distance adds, per sunlight [1/sr].
FN Vec4 hoffman_preetham_inscatter_texture_pass(IN(HoffmanPreetham) hoffman_preetham, IN(GridSize) size, Vec2 uv) {
  Float distance = hoffman_preetham_texture_distance(from_half_texel(uv.x, size.width));
  Float w = from_half_texel(uv.y, size.height);
  Vec3 depth = Vec3(Float(0.0), Float(0.0), Float(0.0));
  Vec3 light = hoffman_preetham_inscatter(hoffman_preetham, distance, distance, 2.0 * w * w, depth);
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// Both looked up: what a path adds per sunlight [1/sr]; what it leaves [1].
FN Vec3 hoffman_preetham_from_textures(Table2 extinction_texture, Table2 inscatter_texture, Float distance, Float one_minus_cos, OUT(Vec3) left) {
  Float u = one_minus_exp(distance * (1.0 / 30000.0));
  Float w = sqrt(max(0.5 * one_minus_cos, 0.0));
  left = xyz(lookup_row(extinction_texture, u, 0));
  return xyz(lookup(inscatter_texture, Vec2(half_texel(u, width_of(inscatter_texture)), half_texel(w, height_of(inscatter_texture)))));
}

/// Both for distances and angles asked, for tests of their error: `paths` x: distance [m], y: 1 - cos of the angle from the Sun.
FN Vec4 hoffman_preetham_texture_rays_pass(Table2 extinction_texture, Table2 inscatter_texture, Table2 paths, Vec2 uv, OUT(Vec4) transmittance) {
  Vec4 path = fetch_same(paths, uv);
  Vec3 left = xyz(path);
  Vec3 light = hoffman_preetham_from_textures(extinction_texture, inscatter_texture, path.x, path.y, left);
  transmittance = Vec4(left.x, left.y, left.z, Float(0.0));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// A picture of the sky from the textures, linear sRGB [cd/m^2].
FN Vec4 hoffman_preetham_texture_picture_pass(IN(HoffmanPreetham) hoffman_preetham, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 sunlight, Table2 extinction_texture, Table2 inscatter_texture, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec3 arriving = xyz(Vec4(fetch_scalar(sunlight, 0, 0)));
  Float apart = one_minus_cos(view, sun);
  Vec3 left = arriving;
  Vec3 light = hoffman_preetham_from_textures(extinction_texture, inscatter_texture, hoffman_preetham_rayleigh_dome(hoffman_preetham, view.z), apart, left) * arriving;
  light = hoffman_preetham_kept(hoffman_preetham, light, Float(hoffman_preetham.exposure));
  return hoffman_preetham_shown(display, arriving, light, apart, view.z) * inside;
}

/// The air before points in view, and the sky, from the textures [1/sr]; transmittance [1].
FN Vec4 hoffman_preetham_texture_haze_pass(IN(HoffmanPreetham) hoffman_preetham, IN(Observer) observer, Table2 sunlight, Table2 extinction_texture, Table2 inscatter_texture, Table2 points, Vec2 uv, OUT(Vec4) transmittance) {
  Vec4 sight = fetch_same(points, uv);
  Vec3 view = xyz(sight);
  Float distance = select(sight.w > 9.9e14, hoffman_preetham_rayleigh_dome(hoffman_preetham, view.z), sight.w);
  Vec3 left = view;
  Vec3 light = hoffman_preetham_from_textures(extinction_texture, inscatter_texture, distance, one_minus_cos(view, Vec3(observer.sun.x, observer.sun.y, observer.sun.z)), left) * xyz(Vec4(fetch_scalar(sunlight, 0, 0)));
  light = hoffman_preetham_kept(hoffman_preetham, light, Float(hoffman_preetham.exposure));
  left = hoffman_preetham_kept(hoffman_preetham, left, Float(1.0));
  transmittance = Vec4(left.x, left.y, left.z, Float(0.0));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}
