// US Standard Atmosphere 1976 (NOAA-S/T 76-1562): number density relative to sea level, 0 to 120 km.
#pragma once
#include <vector>

namespace airlight::standard_atmosphere {

/// Highest altitude [m]; no air above.
inline constexpr double top = 120'000;

/// Number density / number density at sea level, at an altitude [m] in [0, top].
double density(double altitude);

/// Mean of density() between two altitudes [m] with no edge between them.
double mean_density(double from, double to);

/// Altitudes [m] in (0, top) where the temperature's slope, or the density's, jumps.
const std::vector<double>& edges();

}  // namespace airlight::standard_atmosphere
