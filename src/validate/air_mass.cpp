#include "validate/air_mass.h"

#include <cmath>
#include <numbers>

#include "airlight/sky.h"

namespace airlight::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

double air_mass_kasten_young(double elevation) {
  return 1 / (std::sin(elevation * degree) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
}

double air_mass_young(double elevation) {
  const double c = std::sin(elevation * degree);
  return ((1.002432 * c + 0.148386) * c + 0.0096467) / (((c + 0.149864) * c + 0.0102963) * c + 0.000303978);
}

std::vector<AirMass> air_masses() {
  Atmosphere air = built_in_atmosphere("earth");
  std::erase_if(air.constituents, [](const Constituent& constituent) { return constituent.name != "molecules"; });
  const std::vector<double> elevations{90, 60, 45, 30, 20, 15, 10, 7, 5, 3, 2, 1, 0};
  std::vector<Ray> rays;
  for (const double elevation : elevations) rays.push_back({.altitude = 0, .view = direction(0, elevation * degree)});
  // Optical depth 0.026 at the zenith: far from 0 and from opaque at the horizon.
  const std::vector<double> wavelength{750};
  std::vector<double> transmittance(rays.size());
  Sky(air, "single").evaluate(Quantity::transmittance, rays, wavelength, transmittance);
  std::vector<AirMass> masses;
  for (std::size_t i = 0; i < rays.size(); ++i)
    masses.push_back({elevations[i], std::log(transmittance[i]) / std::log(transmittance[0]),
                      air_mass_kasten_young(elevations[i]), air_mass_young(elevations[i])});
  return masses;
}

}  // namespace airlight::validation
