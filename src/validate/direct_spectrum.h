// Direct sunlight against the spectrum of ASTM G173-03.
#pragma once
#include <string>

namespace airlight::validation {

struct DirectSpectrumError {
  std::size_t count;               ///< wavelengths compared
  double rms, bias;                ///< of (value - standard) / standard
  double worst, worst_wavelength;  ///< [nm]
};

/// What G173 fixes: the sun through 1.5 air masses of the US Standard Atmosphere, aerosol of optical depth 0.084 at 500 nm.
inline constexpr double g173_air_mass = 1.5, g173_aerosol = 0.084;
/// That atmosphere's own ozone [Dobson units], and the aerosol's Ångström exponent, which is `earth`'s.
inline constexpr double g173_ozone = 344, g173_angstrom = 1.3;

/// Transmittance of `earth` with that ozone and aerosol times the standard's own extraterrestrial spectrum, against its direct normal
/// spectrum, which includes the sun's surroundings: 400 to 680 nm, without the bands of water and oxygen (585-600 and 625-635 nm).
/// @param path  data/measured/astm_g173.csv
/// @throws InputError naming file and line
DirectSpectrumError compare_with_g173(const std::string& path);

}  // namespace airlight::validation
