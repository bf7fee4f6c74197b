// Illuminance of level ground under a clear sky, from day to twilight, against published values.
#pragma once
#include <functional>
#include <vector>

#include "airlight/sky.h"

namespace airlight::validation {

/// Illuminance [lx] under an average clear sky: polynomials of Janiczek & DeYoung 1987 (U.S. Naval Observatory Circular 171), as in
/// Seidelmann (ed.) 1992, Explanatory Supplement to the Astronomical Almanac.
/// @param elevation  of the sun [degrees], -18 to 90
double published_illuminance(double elevation);

/// Elevations [degrees] of the comparison, +60 to -12.
std::vector<double> illuminance_elevations();

/// Spectral irradiance of level ground [W m^-2 nm^-1], skylight and sunlight, for one elevation of the sun [degrees].
using LevelIrradiance = std::function<std::vector<double>(double elevation, const std::vector<double>& wavelengths)>;
/// [lx], for each of the elevations.
/// @param wavelengths  [nm]; photometric_wavelengths(), or a few, which are weighed as pictures in this air weigh them
std::vector<double> illuminances(const LevelIrradiance& irradiance, const std::vector<double>& wavelengths,
                                 const Atmosphere& air);

}  // namespace airlight::validation
