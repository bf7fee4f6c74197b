#include "reference/phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

// Integral over the sphere of phase times cos^power.
double moment(const Phase& p, int power) {
  static const GaussRule rule(200);
  double sum = 0;
  for (int i = 0; i < 200; ++i) {
    const double m = 2 * rule.nodes[i];
    sum += 4 * std::numbers::pi * rule.weights[i] * std::pow(1 - m, power) * phase(p, m);
  }
  return sum;
}

const TablePhase table{{0, std::numbers::pi}, {0.5 / std::numbers::pi, 0}};  // (1 - angle / pi) / (2 pi), integral 1

TEST(Phase, integrates_to_one_over_the_sphere) {
  for (const Phase& p : {Phase(RayleighPhase{0.0}), Phase(RayleighPhase{0.03}), Phase(IsotropicPhase{}),
                         Phase(HenyeyGreensteinPhase{0.8}), Phase(HenyeyGreensteinPhase{-0.4}),
                         Phase(CornetteShanksPhase{0.7}), Phase(DoubleHenyeyGreensteinPhase{})})
    EXPECT_NEAR(moment(p, 0), 1, 1e-12) << p.index();
  EXPECT_NEAR(moment(table, 0), 1, 1e-4);  // square root of 1 - cos at both ends: the rule converges slowly
}

// Positive g sends light forward, where 1 - cos is 0.
TEST(Phase, mean_cosine_is_the_asymmetry) {
  EXPECT_NEAR(moment(RayleighPhase{0.03}, 1), 0, 1e-14);
  EXPECT_NEAR(moment(HenyeyGreensteinPhase{0.8}, 1), 0.8, 1e-12);
  EXPECT_NEAR(moment(DoubleHenyeyGreensteinPhase{0.8, -0.3, 0.9}, 1), 0.9 * 0.8 - 0.1 * 0.3, 1e-12);
  // Cornette & Shanks 1992, eq. 9: g 3 (4 + g^2) / (5 (2 + g^2)).
  EXPECT_NEAR(moment(CornetteShanksPhase{0.7}, 1), 0.7 * 3 * (4 + 0.49) / (5 * (2 + 0.49)), 1e-12);
}

// Light scattered at a right angle over light scattered forward: (1 + d) / 2, the definition of the depolarisation
// factor.
TEST(Phase, depolarisation_fills_the_minimum_at_right_angles) {
  for (const double d : {0.0, 0.03, 0.2})
    EXPECT_NEAR(phase(RayleighPhase{d}, 1) / phase(RayleighPhase{d}, 0), (1 + d) / 2, 1e-15);
}

TEST(Phase, table_is_linear_in_the_scattering_angle) {
  EXPECT_NEAR(phase(table, 0), 0.5 / std::numbers::pi, 1e-15);
  EXPECT_NEAR(phase(table, 1 - std::cos(0.3)), 0.5 / std::numbers::pi * (1 - 0.3 / std::numbers::pi), 1e-15);
  EXPECT_NEAR(phase(table, 2), 0, 1e-15);
}

}  // namespace
}  // namespace airlight::reference
