// Random directions in proportion to a phase function.
#pragma once
#include <array>

#include "airlight/atmosphere.h"

namespace airlight::reference {

/// One method for all phase functions, tables included: equal cells of v = sin(scattering angle / 2), within which
/// solid angle is drawn evenly. The drawn density is known exactly, so weights are exact, and nearly constant.
class PhaseSampler {
 public:
  explicit PhaseSampler(const Phase& phase);

  /// 1 - cos(scattering angle) for a uniform number in [0, 1).
  double one_minus_cos(double uniform) const;
  /// Density of the drawn directions [1/sr].
  double density(double one_minus_cos) const;

 private:
  static constexpr int cells = 1024;
  std::array<double, cells + 1> cumulative_;
};

}  // namespace airlight::reference
