#include "scenefile/key_frames.h"

#include <algorithm>

namespace airlight {
namespace {

/// Slope of the smooth curve at a key: none at the first, the last and where values turn; else the harmonic mean of the
/// slopes beside it, weighted by the intervals. The cubics between are then monotone (Fritsch & Butland 1984,
/// doi:10.1137/0905021), so a value never leaves the range that its neighbours span.
double slope(const KeyFrames& keys, std::size_t i) {
  if (i == 0 || i + 1 == keys.at.size()) return 0;
  const double before = keys.at[i] - keys.at[i - 1], after = keys.at[i + 1] - keys.at[i];
  const double left = (keys.values[i] - keys.values[i - 1]) / before,
               right = (keys.values[i + 1] - keys.values[i]) / after;
  if (left * right <= 0) return 0;
  return 3 * (before + after) / ((2 * after + before) / left + (after + 2 * before) / right);
}

}  // namespace

double KeyFrames::value(double time) const {
  const auto after = std::upper_bound(at.begin(), at.end(), time);
  if (after == at.begin()) return values.front();
  if (after == at.end()) return values.back();
  const std::size_t j = std::size_t(after - at.begin()), i = j - 1;
  const double width = at[j] - at[i], t = (time - at[i]) / width;
  double result = values[i] + t * (values[j] - values[i]);
  if (interpolation == Interpolation::smooth) {
    // The cubic of Hermite: both ends' values and slopes.
    const double s = 1 - t;
    result = values[i] * s * s * (1 + 2 * t) + values[j] * t * t * (1 + 2 * s) +
             width * t * s * (slope(*this, i) * s - slope(*this, j) * t);
  }
  // Rounding must not leave a range of which the keys are the ends.
  return std::clamp(result, std::min(values[i], values[j]), std::max(values[i], values[j]));
}

}  // namespace airlight
