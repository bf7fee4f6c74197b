#include "validate/direct_spectrum.h"

#include <cmath>
#include <vector>

#include "airlight/sky.h"
#include "validate/standard_spectrum.h"

namespace airlight::validation {
namespace {

bool compared(double wavelength) {
  const auto within = [&](double low, double high) { return wavelength >= low && wavelength <= high; };
  return within(400, 680) && !within(585, 600) && !within(625, 635);
}

Atmosphere air_of_g173() {
  return with_overrides(built_in_atmosphere("earth"),
                        {.aerosol_optical_depth = g173_aerosol * std::pow(550.0 / 500, -g173_angstrom),
                         .angstrom = g173_angstrom,
                         .ozone = g173_ozone});
}

}  // namespace

DirectSpectrumError compare_with_g173(const std::string& path) {
  const StandardSpectrum standard = read_standard_spectrum(path);
  std::vector<double> wavelengths, above, direct;
  for (std::size_t i = 0; i < standard.wavelengths.size(); ++i) {
    if (!compared(standard.wavelengths[i])) continue;
    wavelengths.push_back(standard.wavelengths[i]);
    above.push_back(standard.above[i]);
    direct.push_back(standard.direct[i]);
  }
  const double sun = std::asin(1 / g173_air_mass);  // elevation; the standard's 48.2 degrees from the zenith
  const Ray ray{.altitude = 0, .view = direction(0, sun), .sun = direction(0, sun)};
  // Optical depth is smooth between the bends of ozone's 10 nm table, which lie on this grid.
  std::vector<double> grid, depth;
  for (double w = 400; w <= 680; w += 5) grid.push_back(w);
  depth.resize(grid.size());
  Sky(air_of_g173(), "single").evaluate(Quantity::transmittance, {&ray, 1}, grid, depth);
  for (double& value : depth) value = -std::log(value);
  const Spectrum slant_optical_depth(TableSpectrum{grid, depth, Sampling::point, ""});

  DirectSpectrumError result{wavelengths.size(), 0, 0, 0, 0};
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    const double error = above[i] * std::exp(-slant_optical_depth.at(wavelengths[i])) / direct[i] - 1;
    result.rms += error * error / double(wavelengths.size());
    result.bias += error / double(wavelengths.size());
    if (std::abs(error) > std::abs(result.worst)) result.worst = error, result.worst_wavelength = wavelengths[i];
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

}  // namespace airlight::validation
