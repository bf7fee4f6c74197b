#include "optics/rayleigh_air.h"

#include <numbers>

namespace airlight {
namespace {

// Volume fraction of carbon dioxide. A decade's growth changes the coefficient by 3e-5, so the year does not matter.
constexpr double carbon_dioxide = 400e-6;

// Molecules per cubic metre of the air that Peck & Reeder measured: 15 degrees C, 1013.25 hPa.
constexpr double measured_density = 2.546899e25;

/// Refractive index minus 1 at 15 degrees C and 1013.25 hPa.
double refractivity_of_air(double wavelength) {
  const double inverse_square = 1e6 / (wavelength * wavelength);  // 1/um^2
  // Peck & Reeder 1972, J. Opt. Soc. Am. 62, 958: dry air with 300 ppm of carbon dioxide; Bodhaine et al. 1999, eq. 18.
  const double at_300_ppm =
      1e-8 * (8060.51 + 2480990 / (132.274 - inverse_square) + 17455.7 / (39.32957 - inverse_square));
  return at_300_ppm * (1 + 0.54 * (carbon_dioxide - 300e-6));  // Bodhaine et al. 1999, eq. 19
}

}  // namespace

double king_factor_of_air(double wavelength) {
  const double inverse_square = 1e6 / (wavelength * wavelength);  // 1/um^2
  // Bates 1984, Planet. Space Sci. 32, 785, as eqs. 5, 6 and 23 of Bodhaine et al. 1999; fractions in percent.
  const double nitrogen = 1.034 + 3.17e-4 * inverse_square;
  const double oxygen = 1.096 + 1.385e-3 * inverse_square + 1.448e-4 * inverse_square * inverse_square;
  const double argon = 1.00, dioxide = 1.15, dioxide_percent = 100 * carbon_dioxide;
  return (78.084 * nitrogen + 20.946 * oxygen + 0.934 * argon + dioxide_percent * dioxide) /
         (78.084 + 20.946 + 0.934 + dioxide_percent);
}

double rayleigh_cross_section_of_air(double wavelength) {
  const double refractivity = refractivity_of_air(wavelength);
  // n^2 - 1 = (n - 1)(n + 1): squaring n first would lose four of sixteen digits.
  const double polarisation = refractivity * (refractivity + 2), n_squared = polarisation + 1;
  const double lorentz = polarisation / (n_squared + 2);
  const double metres = wavelength * 1e-9, square = metres * metres;
  constexpr double pi = std::numbers::pi;
  // Bodhaine, Wood, Dutton & Slusser 1999, J. Atmos. Oceanic Technol. 16, 1854, eq. 2.
  return 24 * pi * pi * pi * lorentz * lorentz / (square * square * measured_density * measured_density) *
         king_factor_of_air(wavelength);
}

}  // namespace airlight
