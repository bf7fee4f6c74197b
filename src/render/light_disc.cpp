#include "render/light_disc.h"

#include <algorithm>

namespace airlight {
namespace {

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Camera nearest_face(Camera camera, int faces, const Direction& towards) {
  Camera nearest = camera;
  double greatest = -2;
  for (; camera.face < faces; ++camera.face) {
    const double cosine = dot(view_direction(camera, 0.5, 0.5), towards);
    if (cosine > greatest) greatest = cosine, nearest = camera;
  }
  return nearest;
}

std::array<double, 4> at(const Spectrum& spectrum, std::span<const double> wavelengths) {
  std::array<double, 4> values{};
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = spectrum.at(wavelengths[k]);
  return values;
}

}  // namespace

LightDisc::LightDisc(const Camera& camera, int faces, const Direction& towards, double angular_radius,
                     const std::array<double, 4>& limb, const std::array<double, 4>& irradiance)
    : towards_(towards),
      limb_(limb),
      irradiance_(irradiance),
      disc_(disc_in_picture(nearest_face(camera, faces, towards), towards, angular_radius, limb)) {}

LightDisc::LightDisc(const Camera& camera, int faces, const Direction& towards, const Sun& sun,
                     std::span<const double> wavelengths)
    : LightDisc(camera, faces, towards, sun.angular_radius, at(sun.limb_darkening, wavelengths),
                at(sun.irradiance, wavelengths)) {}

std::array<double, 4> LightDisc::radiance(const Direction& view) const {
  const double dx = view[0] - towards_[0], dy = view[1] - towards_[1], dz = view[2] - towards_[2];
  const double one_minus_cos = 0.5 * (dx * dx + dy * dy + dz * dz), reach = disc_.radius + disc_.edge;
  if (2 * one_minus_cos >= reach * reach) return {};
  auto radiance = disc_radiance(disc_, limb_, one_minus_cos);
  for (std::size_t k = 0; k < 4; ++k) radiance[k] *= irradiance_[k];
  return radiance;
}

}  // namespace airlight
