#pragma once
#include "core/march.glsl"
// Tables that all models of a spherical atmosphere share.

struct GridSize {
  Scalar width;   // [1] in 32..512
  Scalar height;  // [1] in 32..512
  Scalar pad0;    // [1] in 0..1
  Scalar pad1;    // [1] in 0..1
};

/// Optical depth to space of rays that miss the ground [1].
FN Vec4 optical_depth_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Vec2 uv) {
  Float mu = Float(0.0);
  Float altitude = depth_place(air, uv, size.width, size.height, mu);
  Float reach = distance_to_shell(air.ground_radius, altitude, Float(air.top_altitude), mu);
  return optical_depth_along(air, zones, profile, altitude, mu, reach);
}

/// -ln of the sunlight that reaches a place relative to that outside the atmosphere [1]: mean of the transmittance over the limb-
/// darkened disc, parts below the horizon counting as dark. The direction is that of the disc's upper limb.
FN Vec4 disc_depth(IN(Air) air, Table2 optical_depth, Float altitude, Float mu_limb) {
  Float horizon = mu_horizon(air.ground_radius, altitude);
  Float sin_limb = sqrt(max((1.0 - mu_limb) * (1.0 + mu_limb), 0.0));
  Float sin_horizon = sqrt(max((1.0 - horizon) * (1.0 + horizon), 0.0));
  // How far the upper limb stands above the horizon, in disc radii.
  Float above = (sin_horizon * mu_limb - horizon * sin_limb) * (1.0 / air.sun_radius);
  above = select(mu_limb - horizon > 0.1, Float(2.0), clamp(above, 0.0, 2.0));
  Float last = arc_cosine(1.0 - above);  // the disc's slices y = cos(phi) from its upper limb to the horizon
  // A slice of the disc with radiance mu^a carries sin(phi)^(a + 1) dy = sin(phi)^(a + 2) dphi.
  Vec4 exponent = Vec4(air.limb_darkening) + Vec4(2.0);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 24; ++i) {
    Float part = (Float(i) + 0.5) * (1.0 / 24.0);
    Float phi = part * last;
    Float down = air.sun_radius * (1.0 - cos(phi));
    Float mu = max(mu_limb * (1.0 - 0.5 * down * down) - sin_limb * down, horizon);
    Vec4 through = exp(-lookup(optical_depth, depth_uv(air, altitude, mu, width_of(optical_depth), height_of(optical_depth))));
    sum = sum + through * power4(sin(phi), exponent);
  }
  // Of the mean over the slices seen, the part of pi that they take.
  return -ln4(max(sum * (last * (1.0 / (24.0 * 3.14159265358979))) / Vec4(air.disc_light), 1.0e-30));
}

/// The table of that.
FN Vec4 sunlight_pass(IN(Air) air, IN(GridSize) size, Table2 optical_depth, Vec2 uv) {
  Float mu_limb = Float(0.0);
  Float altitude = depth_place(air, uv, size.width, size.height, mu_limb);
  return disc_depth(air, optical_depth, altitude, mu_limb);
}
