#include "reference/adding_doubling_matrix.h"

#include <algorithm>
#include <cmath>

namespace airlight::reference {

Matrix solve(Matrix a, Matrix b) {
  const int n = a.rows;
  const auto subtract = [](Matrix& m, int row, double factor, int pivot, int from) {
    double* const target = m.row(row);
    const double* const source = m.row(pivot);
    for (int j = from; j < m.columns; ++j) target[j] -= factor * source[j];
  };
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
    if (pivot != k) {
      std::swap_ranges(a.row(k), a.row(k) + n, a.row(pivot));
      std::swap_ranges(b.row(k), b.row(k) + b.columns, b.row(pivot));
    }
    for (int i = k + 1; i < n; ++i) {
      const double factor = a(i, k) / a(k, k);
      subtract(a, i, factor, k, k + 1);
      subtract(b, i, factor, k, 0);
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int i = k + 1; i < n; ++i) subtract(b, k, a(k, i), i, 0);
    for (int j = 0; j < b.columns; ++j) b(k, j) /= a(k, k);
  }
  std::fill(b.values.begin() + std::ptrdiff_t(n) * b.columns, b.values.end(), 0.0);
  return b;
}

}  // namespace airlight::reference
