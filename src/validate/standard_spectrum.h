// The spectra of ASTM G173-03: sunlight above the air, and what of it arrives.
#pragma once
#include <string>
#include <vector>

namespace airlight::validation {

struct StandardSpectrum {
  std::vector<double> wavelengths;  ///< [nm]: 280 .. 400 every half, .. 1700 every one, then wider
  std::vector<double> above;        ///< extraterrestrial [W m^-2 nm^-1]
  std::vector<double> direct;       ///< direct normal with the sun's surroundings [W m^-2 nm^-1]

  /// Mean of sunlight above the air over a box of wavelengths [W m^-2 nm^-1].
  double above_in_box(double first, double last) const;
};

/// @param path  data/measured/astm_g173.csv
/// @throws InputError naming file and line
StandardSpectrum read_standard_spectrum(const std::string& path);

}  // namespace airlight::validation
