// What the sky is asked on the command line.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/sky.h"

namespace airlight::cli {

/// A quantity by its outside name. Photometric ones are the eye's weight on a spectral one.
struct Asked {
  std::string_view name, unit;
  Quantity spectral;  ///< what is asked of the sky
  bool photometric;   ///< one number: 683 lm/W times the integral over the luminous efficiency
  bool with_sun;      ///< the direct sun on a horizontal plane is added
  bool along_view;    ///< needs the view
};
/// radiance, path_radiance, transmittance, sun_irradiance, sky_irradiance, luminance, sun_illuminance, sky_illuminance,
/// global_illuminance
std::span<const Asked> all_asked();
/// @throws InputError with "did you mean".
const Asked& asked(std::string_view name);

/// A question that can be answered together with others that differ only in their rays.
struct Topic {
  std::string atmosphere, model;
  const Asked* asked = nullptr;
  std::vector<double> wavelengths = {};  ///< [nm]; empty: photometric_wavelengths()
  int max_order = 0;                     ///< 0: all
  std::string own = {};  ///< what only this model is asked, as canonical JSON; read where it is answered
  auto operator<=>(const Topic&) const = default;
};

}  // namespace airlight::cli
