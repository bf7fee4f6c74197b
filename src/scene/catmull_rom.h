#pragma once
#include <array>

namespace airlight {

/// Weights of four neighbours at -1, 0, 1, 2 for a place t in [0, 1]: a cubic through the middle two, with continuous slope.
inline std::array<double, 4> catmull_rom(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {0.5 * (-t + 2 * t2 - t3), 0.5 * (2 - 5 * t2 + 3 * t3), 0.5 * (t + 4 * t2 - 3 * t3), 0.5 * (t3 - t2)};
}

}  // namespace airlight
