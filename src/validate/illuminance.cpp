#include "validate/illuminance.h"

#include <array>
#include <cmath>

#include "optics/colour.h"

namespace airlight::validation {

double published_illuminance(double elevation) {
  struct Piece {
    double from;
    std::array<double, 4> coefficients;
  };
  // log10 of the illuminance, in powers of elevation / 90 degrees.
  constexpr Piece pieces[] = {{20, {3.74, 3.97, -4.07, 1.47}},         {5, {3.05, 13.28, -45.98, 64.33}},
                              {-0.8, {2.88, 22.26, -207.64, 1034.30}}, {-5, {2.88, 21.81, -258.11, -858.36}},
                              {-12, {2.70, 12.17, -431.69, -1899.83}}, {-18, {13.84, 262.72, 1447.42, 2797.93}}};
  const Piece* piece = pieces;
  while (elevation < piece->from && piece + 1 != std::end(pieces)) ++piece;
  const double x = elevation / 90;
  const auto& c = piece->coefficients;
  return std::pow(10, ((c[3] * x + c[2]) * x + c[1]) * x + c[0]);
}

std::vector<double> illuminance_elevations() { return {60, 40, 20, 10, 5, 2, 0, -2, -4, -6, -8, -10, -12}; }

std::vector<double> illuminances(const LevelIrradiance& irradiance, const std::vector<double>& wavelengths,
                                 const Atmosphere& air) {
  const std::vector<Xyz> weights = colour_weights(air, wavelengths);
  std::vector<double> values;
  for (const double elevation : illuminance_elevations()) {
    const std::vector<double> spectrum = irradiance(elevation, wavelengths);
    double lux = 0;
    for (std::size_t w = 0; w < spectrum.size(); ++w) lux += weights[w][1] * spectrum[w];
    values.push_back(lux);
  }
  return values;
}

}  // namespace airlight::validation
