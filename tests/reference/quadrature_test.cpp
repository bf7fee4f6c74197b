#include "reference/quadrature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "reference/adaptive.h"

namespace airlight::reference {
namespace {

TEST(Quadrature, gauss_legendre_is_exact_up_to_degree_2n_minus_1_and_no_further) {
  for (const int n : {1, 5, 10, 20}) {
    const GaussRule rule(n);
    const auto error = [&](int degree) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
      return std::abs(sum * (degree + 1) - 1);
    };
    for (int degree = 0; degree < 2 * n; ++degree) EXPECT_LT(error(degree), 1e-13) << n << " nodes, degree " << degree;
    if (n <= 10) {  // for more nodes that error drowns in rounding
      EXPECT_GT(error(2 * n), 1e-11) << n;
    }
  }
}

// Exact degrees: 13 for 7 Gauss points, 22 (by symmetry 23) for 15 Kronrod points. A wrong digit in the table fails.
TEST(Quadrature, gauss_kronrod_pair_is_exact_up_to_degrees_13_and_23) {
  for (int degree = 0; degree <= 22; degree += 2) {
    double kronrod = 0, gauss = 0;
    for (int i = 0; i < kronrod::points; ++i) {
      const auto [node, weight, gauss_weight] = kronrod::point(i);
      kronrod += weight * std::pow(node, degree);
      gauss += gauss_weight * std::pow(node, degree);
    }
    EXPECT_NEAR(kronrod, 2.0 / (degree + 1), 1e-15) << degree;
    if (degree <= 12) {
      EXPECT_NEAR(gauss, 2.0 / (degree + 1), 1e-15) << degree;
    }
  }
}

// A square root at a break, a narrow peak and a constant, integrated together: each meets the tolerance.
TEST(Quadrature, adaptive_integration_meets_its_tolerance_for_every_function) {
  const double breaks[] = {0.0, 0.25, 1.0};
  const auto integral = integrate(breaks, std::array{0.0, 0.0, 0.0}, 1e-8, 1, [](double t, std::span<double> values) {
    values[0] = t < 0.25 ? 0 : std::sqrt(t - 0.25);
    values[1] = 1 / (1e-6 + (t - 0.6) * (t - 0.6));
    values[2] = 1;
  });
  EXPECT_NEAR(integral[0], 2.0 / 3 * std::pow(0.75, 1.5), 1e-9);
  EXPECT_NEAR(integral[1], 1e3 * (std::atan(0.4e3) + std::atan(0.6e3)), 1e-5);
  EXPECT_NEAR(integral[2], 1, 1e-14);
}

}  // namespace
}  // namespace airlight::reference
