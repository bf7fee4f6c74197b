// Mountains made of noise.
#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace airlight {

struct ReliefSettings {
  std::uint32_t seed = 1;
  double height = 2500;        ///< of the highest summits above the plain [m]
  double wavelength = 12'000;  ///< from massif to massif [m]
  double ruggedness = 0.5;     ///< depth of gullies, 0 .. 1
};

/// Heights [m] in [0, settings.height] at places (east, north) on the plane [m]: the same bits on every machine, however
/// many places are asked for at once. Places lie within 1000 wavelengths of the origin: they are floats inside.
/// @param cell  leaves out what is smaller than two of these [m]; 0: nothing
void relief(const ReliefSettings& settings, std::span<const std::array<double, 2>> places, double cell,
            std::span<float> heights);

}  // namespace airlight
