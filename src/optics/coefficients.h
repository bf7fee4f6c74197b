// From quantities that are measured (columns, extinction and albedo, optical depth) to coefficients, and back.
#pragma once
#include "airlight/atmosphere.h"

namespace airlight {

/// Integral of relative density from the ground to the planet's top [m]: vertical optical depth = coefficient * path
/// length.
double path_length(const Profile& profile, double top);

/// Absorption coefficient of a gas with a vertical column [Dobson units] and a cross-section [m^2].
Spectrum column_absorption(double dobson, const Spectrum& cross_section, const Profile& profile, double top);

struct Coefficients {
  Spectrum scattering, absorption;  ///< [1/m]
};
/// Scattering and absorption of an extinction [1/m] and a single-scattering albedo.
Coefficients split_extinction(const Spectrum& extinction, const Spectrum& single_scattering_albedo);

}  // namespace airlight
