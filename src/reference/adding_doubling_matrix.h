// The little linear algebra that adding-doubling needs.
#pragma once
#include <cstddef>
#include <vector>

namespace airlight::reference {

/// Rows one after the other.
struct Matrix {
  Matrix(int rows_, int columns_) : rows(rows_), columns(columns_), values(std::size_t(rows_) * columns_) {}

  double& operator()(int i, int j) { return values[std::size_t(i) * columns + j]; }
  double operator()(int i, int j) const { return values[std::size_t(i) * columns + j]; }
  double* row(int i) { return values.data() + std::size_t(i) * columns; }
  const double* row(int i) const { return values.data() + std::size_t(i) * columns; }

  int rows, columns;
  std::vector<double> values;
};

/// x of a x = b, by elimination with partial pivoting; `a` is square.
/// @param b  has at least as many rows; those beyond a's are zero in the result
Matrix solve(Matrix a, Matrix b);

}  // namespace airlight::reference
