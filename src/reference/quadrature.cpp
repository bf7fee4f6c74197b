#include "reference/quadrature.h"

#include <cmath>
#include <numbers>

namespace airlight::reference {

GaussRule::GaussRule(int n) : nodes(n), weights(n) {
  for (int i = 0; i < n; ++i) {
    // Newton's method on the Legendre polynomial, from Tricomi's estimate of its zeros: 5 steps reach rounding.
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 0;
    for (int step = 0; step < 6; ++step) {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (before - x * p) / ((1 - x) * (1 + x));
      x -= p / slope;
    }
    nodes[i] = 0.5 * (1 + x);
    weights[i] = 1 / ((1 - x) * (1 + x) * slope * slope);
  }
}

}  // namespace airlight::reference
