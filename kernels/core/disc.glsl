#pragma once
#include "core/math.glsl"

/// Shape of the Sun's disc in a picture, soft by a pixel at its edge [1]. The host sums it over the pixels with this same function.
/// @param limb_darkening [1] in 0..1  exponent a of radiance(mu) = mu^a
/// @param radius [rad] in 1e-3..1e-1
/// @param edge [rad] in 1e-4..1e-2  width of the soft edge
/// @param one_minus_cos [1] in 0..1e-4  of the angle from the Sun's centre
/// @bound 1e-3 scale 1   at the limb the slope of mu^a is infinite
FN Vec4 disc_shape(Scalar4 limb_darkening, Scalar radius, Scalar edge, Float one_minus_cos) {
  Float angle = sqrt(max(2.0 * one_minus_cos, 0.0));
  Float inside = clamp((radius - angle) * (1.0 / edge) + 0.5, 0.0, 1.0);
  Float x = min(angle * (1.0 / radius), 0.9999);
  Float mu = sqrt((1.0 - x) * (1.0 + x));
  return power4(mu, Vec4(limb_darkening)) * inside;
}
