#pragma once
#include "core/math.glsl"
// All directions around an observer as a table: half a dome, since the Sun's azimuth mirrors the other half. u is the sine of half
// the azimuth from the Sun; v runs from the horizon up, then from it down, dense at the horizon and never across it.

struct Dome {
  Scalar width;    // [1] in 32..256  of the table
  Scalar height;   // [1] in 32..256
  Scalar depth;    // [1] in 2..64    of a table that also has distances
  Scalar horizon;  // [1] in -0.5..0  mu_horizon at the observer
};

/// Table coordinates of a view [1].
/// @param horizon [1] in -0.5..0  mu_horizon at the observer
/// @param view [1] in -0.577..0.577
/// @param sun [1] in -0.577..0.577
/// @param width [1] in 32..256
/// @param height [1] in 32..256
/// @bound 1e-3 scale 1   the square root at the horizon: half the digits, a hundredth of a texel
FN Vec2 dome_uv(Scalar horizon, Vec3 view, Vec3 sun, Scalar width, Scalar height) {
  Float view_across = max(sqrt(view.x * view.x + view.y * view.y), 1.0e-12);
  Float sun_across = max(sqrt(sun.x * sun.x + sun.y * sun.y), 1.0e-12);
  Float x = view.x / view_across - sun.x / sun_across;
  Float y = view.y / view_across - sun.y / sun_across;
  Float u = 0.5 * sqrt(x * x + y * y);
  Float above = view.z - horizon;
  Float up = sqrt(clamp(above * (1.0 / (1.0 - horizon)), 0.0, 1.0));
  Float down = sqrt(clamp(-above * (1.0 / (1.0 + horizon)), 0.0, 1.0));
  Scalar half_height = 0.5 * height;
  Float v = select(above < 0.0, 0.5 + 0.5 * half_texel(down, half_height), 0.5 * half_texel(up, half_height));
  return Vec2(half_texel(clamp(u, 0.0, 1.0), width), v);
}
/// The view of a place in the table, in the frame whose x axis points to the Sun's azimuth [1].
/// @param horizon [1] in -0.5..0
/// @param uv [1] in 0..1
/// @param width [1] in 32..256
/// @param height [1] in 32..256
/// @bound 1e-3 scale 1   towards the zenith and nadir the horizontal part is the root of what float leaves of 1 - mu^2: half the digits
FN Vec3 dome_view(Scalar horizon, Vec2 uv, Scalar width, Scalar height) {
  Scalar half_height = 0.5 * height;
  Float u = from_half_texel(uv.x, width);
  Bool below = uv.y > 0.5;
  Float c = from_half_texel(select(below, 2.0 * uv.y - 1.0, 2.0 * uv.y), half_height);
  // Never on the horizon itself, where rounding would decide between sky and ground.
  Float mu = select(below, horizon - max(c * c, 1.0e-6) * (1.0 + horizon), horizon + max(c * c, 1.0e-6) * (1.0 - horizon));
  mu = clamp(mu, -1.0, 1.0);
  Float across = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
  return Vec3(across * (1.0 - 2.0 * u * u), across * 2.0 * u * sqrt(max(1.0 - u * u, 0.0)), mu);
}
