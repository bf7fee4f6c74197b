#include "validate/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight::validation {

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto rank = std::size_t(std::ceil(part * double(values.size())));
  const auto at = values.begin() + std::ptrdiff_t(std::clamp<std::size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Figure figure_of(std::vector<Deviation> deviations) {
  Figure figure;
  figure.count = deviations.size();
  std::vector<double> sizes;
  for (Deviation& d : deviations) {
    if (!std::isfinite(d.counted)) d.counted = std::numeric_limits<double>::infinity();
    sizes.push_back(d.counted);
    figure.bias += d.error / double(deviations.size());
    if (figure.where.empty() || d.counted > figure.worst) {
      figure.worst = d.counted;
      figure.where = d.where;
    }
  }
  figure.median = percentile(sizes, 0.5);
  figure.p90 = percentile(sizes, 0.9);
  figure.p99 = percentile(sizes, 0.99);
  return figure;
}

}  // namespace airlight::validation
