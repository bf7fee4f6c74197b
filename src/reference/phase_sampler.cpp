#include "reference/phase_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {

// 1 - cos = 2 v^2, so that solid angle is 4 pi d(v^2).
PhaseSampler::PhaseSampler(const Phase& law) {
  // A table may rise between two nodes only; a millionth, drawn evenly, finds that too.
  constexpr double even = 1e-6;
  const GaussRule rule(6);
  cumulative_[0] = 0;
  for (int i = 0; i < cells; ++i) {
    const double low = double(i) / cells, high = double(i + 1) / cells, area = (high - low) * (high + low);
    double mean = 0;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k)
      mean += rule.weights[k] * phase(law, 2 * (low * low + rule.nodes[k] * area));
    cumulative_[i + 1] = cumulative_[i] + area * ((1 - even) * 4 * std::numbers::pi * mean + even);
  }
  for (double& sum : cumulative_) sum /= cumulative_[cells];
}

double PhaseSampler::one_minus_cos(double uniform) const {
  const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, uniform);
  const int i = int(above - cumulative_.begin()) - 1;
  const double share = (uniform - cumulative_[i]) / (cumulative_[i + 1] - cumulative_[i]);
  return 2.0 * (double(i) * i + share * (2 * i + 1)) / (double(cells) * cells);
}

double PhaseSampler::density(double one_minus_cos) const {
  const int i = std::clamp(int(std::sqrt(0.5 * one_minus_cos) * cells), 0, cells - 1);
  return (cumulative_[i + 1] - cumulative_[i]) * double(cells) * cells / ((2 * i + 1) * 4 * std::numbers::pi);
}

}  // namespace airlight::reference
