// Rayleigh scattering by dry air, from its refractive index.
#pragma once

namespace airlight {

/// King factor of dry air at a wavelength [nm]: molecules that are not round scatter about 5 % more than round ones.
double king_factor_of_air(double wavelength);

/// Scattering cross-section of the mean molecule of dry air [m^2] at a wavelength [nm].
double rayleigh_cross_section_of_air(double wavelength);

/// Depolarisation factor of natural light that belongs to a King factor: F = (6 + 3 d) / (6 - 7 d).
constexpr double depolarisation_from_king_factor(double king) { return 6 * (king - 1) / (3 + 7 * king); }

}  // namespace airlight
