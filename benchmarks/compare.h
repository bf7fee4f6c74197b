#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace airlight::bench {

/// Difference from the truth, relative to the larger of the true value and a floor: 1e-4 of the brightest, unless given.
/// @param part  of all values that may differ by at most what is returned: 1 is the largest difference
template <class A, class B>
double difference(const std::vector<A>& got, const std::vector<B>& truth, double part = 1, double floor = 0) {
  double brightest = 0;
  for (const B v : truth) brightest = std::max(brightest, double(std::fabs(v)));
  if (floor == 0) floor = 1e-4 * brightest;
  std::vector<double> all;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double d = std::fabs(double(got[i]) - double(truth[i])) / std::max(double(std::fabs(truth[i])), floor);
    all.push_back(std::isfinite(d) ? d : 1e30);
  }
  const auto at = all.begin() + std::ptrdiff_t(std::ceil(part * double(all.size() - 1)));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

}  // namespace airlight::bench
