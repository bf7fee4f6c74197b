// Clear-sky spectral radiance as it was measured (Kider et al. 2014), and what a model says of it.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "airlight/sky.h"
#include "validate/standard_spectrum.h"

namespace airlight::validation {

struct MeasuredSky {
  struct Scan {
    std::string local_time;
    double sun_elevation;        ///< [degrees]
    std::vector<Ray> rays;       ///< without the directions that are known to be wrong
    std::vector<double> values;  ///< [W m^-2 sr^-1 nm^-1] ray by ray, a value for each wavelength
  };
  std::vector<double> wavelengths;  ///< [nm], centres of the 10 nm boxes
  std::vector<Scan> scans;
};

/// @param path  data/measured/measured_sky_20130527.json
/// @throws InputError naming the file
MeasuredSky read_measured_sky(const std::string& path);

/// The same at every so many-th of its wavelengths.
MeasuredSky at_every(const MeasuredSky& sky, std::size_t stride);

/// The air of that day with one mode of aerosol (data/measured/README.md): Earth's molecules and ozone, grass on the ground;
/// sunlight in the boxes of the measurement, which have the stated wavelengths in their middles: only so the lines of sunlight are found
/// in the sky where they are, within a nanometre.
Atmosphere air_of_measured_sky(const MeasuredSky& sky, const StandardSpectrum& standard);

/// Spectral radiance of rays, as Sky::evaluate gives it.
using Radiance = std::function<std::vector<double>(std::span<const Ray>, const std::vector<double>& wavelengths)>;

struct MeasuredSkyError {
  std::vector<double> scans;  ///< relative root mean square error of each scan
  double all;   ///< sqrt(mean (value - measured)^2 / mean measured^2) over all scans, directions and wavelengths
  double bias;  ///< mean (value - measured) / mean measured
};
MeasuredSkyError compare_with_measured_sky(const MeasuredSky& sky, const Radiance& radiance);

}  // namespace airlight::validation
