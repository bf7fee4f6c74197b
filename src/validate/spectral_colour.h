// What few wavelengths cost in colour, and which four serve the eye best.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "optics/colour.h"
#include "optics/solve_four.h"

namespace airlight::validation {

/// A sky's light in one direction, at many wavelengths.
struct SkySpectrum {
  std::string where, atmosphere;
  double sun_elevation;          ///< [degrees]
  std::vector<double> radiance;  ///< [W m^-2 sr^-1 nm^-1]
};

/// Skies of clear and hazy Earth, the sun from 60 degrees up to 12 below the horizon, from 2 m and 10 km, views from the horizon to the zenith
/// towards the sun, across and away from it.
std::vector<SkySpectrum> sky_spectra(const std::string& model, const std::vector<double>& wavelengths);

/// CIEDE2000 at the exposure that shows the truth as middle grey: brightness counts too.
struct ColourError {
  std::size_t count = 0;
  double median = 0, p90 = 0, worst = 0;
  std::string where;
};
struct ColourErrors {
  std::vector<double> wavelengths;
  ColourError day, twilight;  ///< sun at 0 degrees and higher; below the horizon
};

/// Colours by the rule that pictures use (colour_weights), against those of 40 wavelengths.
ColourErrors colour_errors(const std::string& model, const std::vector<double>& wavelengths);

/// Wavelengths that stand for `count`: 3: 440, 550 and 680 nm; 4: those of real time; else centres of equal bins of 380 to 780 nm.
std::vector<double> wavelengths_of(int count);

/// Four wavelengths, and what a unit of each adds to X, Y and Z, one matrix for all skies.
struct FittedQuad {
  std::array<double, 4> wavelengths;
  std::array<Xyz, 4> matrix;  ///< [cd m^-2 / (W m^-2 sr^-1 nm^-1)]
  ColourErrors errors;
};
/// The least squares of relative X, Y and Z over all these skies for given wavelengths (of photometric_wavelengths()).
FittedQuad fit_matrix(const std::vector<SkySpectrum>& skies, const std::array<double, 4>& wavelengths);
/// The best of all quads on the 10 nm grid from 405 to 705 nm.
FittedQuad fit_quad(const std::vector<SkySpectrum>& skies);

}  // namespace airlight::validation
