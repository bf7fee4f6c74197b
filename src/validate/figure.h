// How far many answers are from the truth, in a few numbers.
#pragma once
#include <string>
#include <vector>

namespace airlight::validation {

/// How far one answer is from the truth.
struct Deviation {
  double error = 0;    ///< (value - truth) / truth, or value - truth where the quantity is stated so
  double counted = 0;  ///< its magnitude; 0 inside the truth's own uncertainty
  std::string where;
};

struct Figure {
  std::size_t count = 0;
  double median = 0, p90 = 0, p99 = 0, worst = 0;  ///< of Deviation::counted
  std::string where;                               ///< of the worst
  double bias = 0;                                 ///< mean of Deviation::error
};

/// An answer that is no number counts as infinitely far.
Figure figure_of(std::vector<Deviation> deviations);

/// The value that so large a part of all is not above. @param values  in any order; none: 0
double percentile(std::vector<double> values, double part);

}  // namespace airlight::validation
