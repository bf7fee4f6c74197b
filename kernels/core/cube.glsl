#pragma once
#include "core/math.glsl"
// A cube map as a table: six square faces below each other, each with a border of one texel that holds what lies beyond its edge,
// so that filtering never meets another face. Faces and their axes are those of Camera: east, west, north, south, up, down.

/// Direction seen at a place of the table [1].
/// @param uv [1] in 0..1
/// @param width [1] in 66..1026  of the table: a face and its border
FN Vec3 cube_view(Vec2 uv, Scalar width) {
  Scalar per_texel = 2.0 / (width - 2.0);
  Float row = floor(uv.y * width * 6.0);
  Float face = floor((row + 0.5) * (1.0 / width));
  Float x = (floor(uv.x * width) - 0.5) * per_texel - 1.0;
  Float y = 1.0 - (row - face * width - 0.5) * per_texel;
  Vec3 side = select(face < 0.5, Vec3(Float(1.0), -x, y), select(face < 1.5, Vec3(Float(-1.0), x, y), select(face < 2.5, Vec3(x, Float(1.0), y), Vec3(-x, Float(-1.0), y))));
  Vec3 d = select(face < 3.5, side, select(face < 4.5, Vec3(x, -y, Float(1.0)), Vec3(x, y, Float(-1.0))));
  return d * (1.0 / sqrt(dot(d, d)));
}

/// Place of a direction in the table [1].
/// @param d [1] in -0.577..0.577
/// @param width [1] in 66..1026
/// @bound 2.0 scale 1   an edge between two faces is a decision
FN Vec2 cube_uv(Vec3 d, Scalar width) {
  Float ax = abs(d.x);
  Float ay = abs(d.y);
  Float az = abs(d.z);
  Bool vertical = (az >= ax) && (az >= ay);
  Bool along_x = ax >= ay;
  Float scale = 1.0 / max(max(ax, ay), max(az, 1.0e-20));
  Float face = select(along_x, select(d.x > 0.0, Float(0.0), Float(1.0)), select(d.y > 0.0, Float(2.0), Float(3.0)));
  Float x = select(along_x, select(d.x > 0.0, -d.y, d.y), select(d.y > 0.0, d.x, -d.x));
  face = select(vertical, select(d.z > 0.0, Float(4.0), Float(5.0)), face);
  x = select(vertical, d.x, x) * scale;
  Float y = select(vertical, select(d.z > 0.0, -d.y, d.y), d.z) * scale;
  Scalar half_face = 0.5 * (width - 2.0);
  Scalar texel = 1.0 / width;
  return Vec2((1.0 + (x + 1.0) * half_face) * texel, (face + (1.0 + (1.0 - y) * half_face) * texel) * (1.0 / 6.0));
}
