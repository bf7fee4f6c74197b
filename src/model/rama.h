// Rama, a spinning cylinder with air in it: its constants as the kernels take them. Kilometres, as its specification has them.
#pragma once
#include <array>
#include <vector>

#include "model/model.h"

namespace airlight {

struct RamaSettings {
  double spin = 2 * 3.14159265358979323846 / 180;                  ///< [rad/s]
  double temperature = 288.15;                                     ///< [K]
  std::array<double, 3> scattering{5.802e-3, 13.558e-3, 33.1e-3};  ///< [1/km] at 680, 550, 440 nm, 8 km from the axis
  double power = 2410.71e6 * 133;                                  ///< of all strips [W]
  double albedo = 0.15;
  int samples = 30;
  bool fast = false;  ///< transmittance along rays from a straight line
  bool air = true;
  int single_light = 0;  ///< 1 to 6: this strip alone
  enum class Source { texture, own, own_rayleigh } source = Source::texture;
};

/// Squared radii's factor in the density's exponent [1/km^2].
double rama_kappa(const RamaSettings& settings);
/// Radiance of the northern and of the southern strips [W m^-2 sr^-1].
std::array<double, 2> rama_strip_radiance(const RamaSettings& settings);
/// The best straight line a + b (r/8)^2 for the density.
std::array<double, 2> rama_density_line(double kappa);

/// The kernels' struct Rama.
Fields rama_fields(const RamaSettings& settings);
/// The table `lights`: a strip a column, two rows.
std::vector<double> rama_lights(const RamaSettings& settings);

inline constexpr Shape rama_texture{49, 33, 33};

}  // namespace airlight
