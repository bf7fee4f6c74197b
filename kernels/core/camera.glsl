#pragma once
#include "core/math.glsl"
// Where a picture's coordinates look: (0, 0) top left, (1, 1) bottom right. Frame: east, north, up.

struct Camera {
  Scalar4 right;         // [1] in -1..1  unit vector towards the picture's right
  Scalar4 up;            // [1] in -1..1
  Scalar4 forward;       // [1] in -1..1  the optical axis
  Scalar projection;     // [1] in 0..3  0: equirectangular, 1: fisheye, 2: flat (perspective, cube face)
  Scalar half_width;     // [1] in 0.1..2  flat: tangent of half the horizontal field; fisheye: half the field [rad]
  Scalar half_height;    // [1] in 0.1..2
  Scalar pad;            // [1] in 0..1
};

/// Unit vector seen at picture coordinates [1].
/// @param uv [1] in 0..1
/// @param inside [1]  0 where a fisheye picture is black
/// @bound 2e-5 scale 10   the random frames of the test are no rotations
FN Vec3 camera_view(IN(Camera) camera, Vec2 uv, OUT(Float) inside) {
  Float x = 2.0 * uv.x - 1.0;
  Float y = 1.0 - 2.0 * uv.y;
  inside = Float(1.0);
  Vec3 local = Vec3(x * camera.half_width, y * camera.half_height, Float(1.0));
  if (camera.projection < 0.5) {
    Float azimuth = x * 3.14159265358979;
    Float elevation = y * 1.57079632679490;
    Float c = cos(elevation);
    local = Vec3(c * sin(azimuth), sin(elevation), c * cos(azimuth));
  } else if (camera.projection < 1.5) {
    Float px = x * camera.half_width;
    Float py = y * camera.half_height;
    Float angle = sqrt(px * px + py * py);
    inside = select(angle > camera.half_width, Float(0.0), Float(1.0));
    Float a = min(angle, 3.14159265358979);
    Float s = sin(a) / max(angle, 1.0e-12);
    local = Vec3(px * s, py * s, cos(a));
  } else {
    local = local * (1.0 / sqrt(dot(local, local)));
  }
  return Vec3(local.x * camera.right.x + local.y * camera.up.x + local.z * camera.forward.x,
              local.x * camera.right.y + local.y * camera.up.y + local.z * camera.forward.y,
              local.x * camera.right.z + local.y * camera.up.z + local.z * camera.forward.z);
}
