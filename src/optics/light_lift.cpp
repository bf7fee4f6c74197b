#include "optics/light_lift.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "airlight/error.h"
#include "optics/colour.h"

namespace airlight {
namespace {

using Row = std::array<double, 4>;

double dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/// What is perpendicular to three rows: the cross product of four dimensions.
Row perpendicular(const std::array<Row, 3>& m) {
  Row n{};
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<std::size_t, 3> c{};
    for (std::size_t i = 0, j = 0; j < 4; ++j)
      if (j != k) c[i++] = j;
    const auto minor = [&](std::size_t i, std::size_t j) { return m[1][c[i]] * m[2][c[j]] - m[1][c[j]] * m[2][c[i]]; };
    n[k] = (k % 2 ? -1 : 1) * (m[0][c[0]] * minor(1, 2) - m[0][c[1]] * minor(0, 2) + m[0][c[2]] * minor(0, 1));
  }
  return n;
}

/// The inverse, by Gauss and Jordan with the largest pivots; false: there is none.
bool invert(std::array<Row, 4> a, std::array<Row, 4>& inverse) {
  inverse = {Row{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < 4; ++j)
      if (std::abs(a[j][i]) > std::abs(a[pivot][i])) pivot = j;
    // Rows come scaled to about 1, so that this is rounding.
    if (!(std::abs(a[pivot][i]) > 1e-12)) return false;
    std::swap(a[i], a[pivot]), std::swap(inverse[i], inverse[pivot]);
    const double scale = 1 / a[i][i];
    for (std::size_t k = 0; k < 4; ++k) a[i][k] *= scale, inverse[i][k] *= scale;
    for (std::size_t j = 0; j < 4; ++j) {
      const double factor = a[j][i];
      if (j == i) continue;
      for (std::size_t k = 0; k < 4; ++k) a[j][k] -= factor * a[i][k], inverse[j][k] -= factor * inverse[i][k];
    }
  }
  return true;
}

}  // namespace

std::array<double, 4> LightLift::spectrum(const std::array<double, 3>& rgb) const {
  std::array<double, 4> out{};
  for (std::size_t k = 0; k < 4; ++k)
    out[k] = to_spectrum[k][0] * rgb[0] + to_spectrum[k][1] * rgb[1] + to_spectrum[k][2] * rgb[2];
  return out;
}

std::array<double, 3> LightLift::srgb(const std::array<double, 4>& spectrum) const {
  return {dot(to_srgb[0], spectrum), dot(to_srgb[1], spectrum), dot(to_srgb[2], spectrum)};
}

LightLift light_lift(const Atmosphere& atmosphere, const std::array<double, 4>& wavelengths) {
  LightLift lift;
  Row sunlight{};
  std::array<Row, 3> seen{};  // colour of a ratio to sunlight
  const auto weights = colour_weights(atmosphere, wavelengths);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto rgb = xyz_to_srgb(weights[k]);
    sunlight[k] = atmosphere.sun.irradiance.at(wavelengths[k]);
    for (std::size_t c = 0; c < 3; ++c) {
      lift.to_srgb[c][k] = rgb[c];
      seen[c][k] = rgb[c] * sunlight[k];
    }
  }
  double scale = 0;
  for (const Row& row : seen) scale = std::max(scale, std::sqrt(dot(row, row)));
  for (Row& row : seen)
    for (double& v : row) v = scale > 0 ? v / scale : 0;

  // Ratios r of one colour differ by multiples of n, which has none. Bending r^T S r, the squared changes of slope, is least where
  // n^T S r = 0: a fourth linear equation beside the three of the colour. (Steps in place of bends would take reddened light for
  // whiter than it is: twice the error through haze for rock, snow and water.)
  Row n = perpendicular(seen), fourth{};
  const double length = std::sqrt(dot(n, n));
  for (std::size_t k = 0; k < 2 && length > 0; ++k) {
    const double before = 50 / (wavelengths[k + 1] - wavelengths[k]),
                 after = 50 / (wavelengths[k + 2] - wavelengths[k + 1]);
    const std::array<double, 3> bend{before, -before - after, after};
    double of_n = 0;
    for (std::size_t i = 0; i < 3; ++i) of_n += bend[i] * n[k + i] / length;
    for (std::size_t i = 0; i < 3; ++i) fourth[k + i] += of_n * bend[i];
  }
  std::array<Row, 4> inverse{};
  if (!invert({seen[0], seen[1], seen[2], fourth}, inverse))
    throw InputError("'" + atmosphere.name +
                     "': its sun is too dark at the wavelengths of real time to tell colours apart");
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c) lift.to_spectrum[k][c] = sunlight[k] * inverse[k][c] / scale;
  return lift;
}

}  // namespace airlight
