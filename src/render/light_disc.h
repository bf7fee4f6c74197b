// The disc of a light in a picture, before the air.
#pragma once
#include <array>

#include "airlight/atmosphere.h"
#include "sky/camera.h"

namespace airlight {

class LightDisc {
 public:
  /// @param camera   one face of a cube
  /// @param faces    6: a cube's; the disc is drawn for the one that looks nearest to the light
  /// @param towards  unit, in the eye's frame
  /// @param limb, irradiance  limb darkening's exponents and light, at four wavelengths, or as red, green, blue and 0
  LightDisc(const Camera& camera, int faces, const Direction& towards, double angular_radius,
            const std::array<double, 4>& limb, const std::array<double, 4>& irradiance);
  /// The same of a light outside the air. @param wavelengths  four [nm]
  LightDisc(const Camera& camera, int faces, const Direction& towards, const Sun& sun,
            std::span<const double> wavelengths);

  /// [W m^-2 sr^-1 nm^-1] along a unit vector in the eye's frame; 0 beside the disc.
  std::array<double, 4> radiance(const Direction& view) const;

 private:
  Direction towards_;
  std::array<double, 4> limb_, irradiance_;
  DiscInPicture disc_;
};

}  // namespace airlight
