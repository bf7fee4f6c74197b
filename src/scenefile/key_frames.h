// A number that changes over time, given at some times.
#pragma once
#include <vector>

namespace airlight {

struct KeyFrames {
  enum class Interpolation {
    linear,
    smooth,  ///< starts and stops gently, never swings past the values given
  };

  std::vector<double> at, values;  ///< as many of each, one at least; `at` strictly increasing
  Interpolation interpolation = Interpolation::linear;

  /// Before the first and after the last: their values.
  double value(double time) const;
};

}  // namespace airlight
