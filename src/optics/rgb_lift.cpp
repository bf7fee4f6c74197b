#include "optics/rgb_lift.h"

#include <algorithm>
#include <cmath>

namespace airlight {

// Three bands, blue up to 488 nm, red from 588 nm, green between, each passing into the next over about 40 nm. The two places
// are fitted: least squares of what red, green and blue come back as from the CIE 1931 observer under sunlight, white to white.
// Steeper edges would come back better still (0.6 % at 24 nm) but resemble no pigment.
std::array<double, 3> lift_weights(double wavelength) {
  const double above_blue = 0.5 * (1 + std::tanh((wavelength - 487.8) / 20));
  const double red = 0.5 * (1 + std::tanh((wavelength - 588.1) / 20));
  return {red, std::max(above_blue - red, 0.0), 1 - above_blue};
}

void lift_rgb(const std::array<double, 3>& rgb, std::span<const double> wavelengths, std::span<double> albedo) {
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    const auto weights = lift_weights(wavelengths[i]);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * std::clamp(rgb[k], 0.0, 1.0);
    albedo[i] = std::min(sum, 1.0);
  }
}

}  // namespace airlight
