// Mountains made of noise.
#pragma once
#include <cstdint>

namespace airlight {

struct ReliefSettings {
  std::uint32_t seed = 1;
  double height = 2500;        ///< of the highest summits above the plain [m]
  double wavelength = 12'000;  ///< from massif to massif [m]
  double ruggedness = 0.5;     ///< 0: smooth hills, 1: all cliffs
};

/// Height [m] in [0, settings.height] at a place on the plane [m]: deterministic on every machine.
/// @param cell  leaves out what is smaller than this [m]
double relief(const ReliefSettings& settings, double east, double north, double cell);

}  // namespace airlight
