#pragma once
#include <array>
#include <functional>
#include <optional>

#include "airlight/camera.h"
#include "model/model.h"

namespace airlight {

/// The kernels' struct Camera.
Fields camera_fields(const Camera& camera);

/// A function of picture coordinates like view_direction(), for many pixels; none outside a fisheye's circle.
std::function<std::optional<Direction>(double u, double v)> viewer(const Camera& camera);

/// What makes the pixels of the Sun's disc add up to its irradiance, however few they are.
struct DiscInPicture {
  double radius, edge;           ///< [rad] as drawn: at least about a pixel, soft by a pixel
  std::array<double, 4> gain{};  ///< [1/sr]: 1 / (sum over pixels of shape x solid angle)
};
/// @param exponent  limb darkening at the four wavelengths
DiscInPicture disc_in_picture(const Camera& camera, Direction sun, double angular_radius,
                              const std::array<double, 4>& exponent);

/// The disc's radiance before the air, per solar irradiance [1/sr], at an angle from the Sun given by its 1 - cos.
std::array<double, 4> disc_radiance(const DiscInPicture& disc, const std::array<double, 4>& exponent,
                                    double one_minus_cos);

}  // namespace airlight
