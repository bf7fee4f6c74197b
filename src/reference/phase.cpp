#include "reference/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight::reference {
namespace {

constexpr double sphere = 4 * std::numbers::pi;  // [sr]

// Henyey & Greenstein 1941. 1 + g^2 - 2 g cos written without cancellation at the forward peak.
double henyey_greenstein(double g, double one_minus_cos) {
  const double d = (1 - g) * (1 - g) + 2 * g * one_minus_cos;
  return (1 - g) * (1 + g) / (sphere * d * std::sqrt(d));
}

struct Evaluate {
  double m;  // 1 - cos
  double c = 1 - m;

  // Chandrasekhar 1950 (sections 16 and 18): gamma = depolarisation / (2 - depolarisation) for unpolarised light.
  double operator()(const RayleighPhase& p) const {
    const double gamma = p.depolarisation / (2 - p.depolarisation);
    return 3 / (4 * sphere * (1 + 2 * gamma)) * (1 + 3 * gamma + (1 - gamma) * c * c);
  }
  double operator()(const IsotropicPhase&) const { return 1 / sphere; }
  double operator()(const HenyeyGreensteinPhase& p) const { return henyey_greenstein(p.g, m); }
  // Cornette & Shanks 1992, eq. 8.
  double operator()(const CornetteShanksPhase& p) const {
    return 1.5 * (1 + c * c) / (2 + p.g * p.g) * henyey_greenstein(p.g, m);
  }
  double operator()(const DoubleHenyeyGreensteinPhase& p) const {
    return p.weight * henyey_greenstein(p.g1, m) + (1 - p.weight) * henyey_greenstein(p.g2, m);
  }
  double operator()(const TablePhase& p) const {
    const double angle = 2 * std::asin(std::sqrt(std::clamp(0.5 * m, 0.0, 1.0)));
    const auto above = std::upper_bound(p.angles.begin(), p.angles.end(), angle);
    if (above == p.angles.begin()) return p.values.front();
    if (above == p.angles.end()) return p.values.back();
    const auto i = above - p.angles.begin();
    return std::lerp(p.values[i - 1], p.values[i], (angle - p.angles[i - 1]) / (p.angles[i] - p.angles[i - 1]));
  }
};

}  // namespace

double phase(const Phase& phase, double one_minus_cos) { return std::visit(Evaluate{one_minus_cos}, phase); }

}  // namespace airlight::reference
