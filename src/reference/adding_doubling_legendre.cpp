#include "reference/adding_doubling_legendre.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

std::vector<double> powers(double g, int count) {
  std::vector<double> moments(count);
  double power = 1;
  for (double& moment : moments) moment = std::exchange(power, power * g);
  return moments;
}

/// Moments of cos times the function of these moments; one fewer.
std::vector<double> times_cosine(const std::vector<double>& moments) {
  std::vector<double> result(moments.size() - 1);
  for (std::size_t l = 0; l < result.size(); ++l) {
    const double below = l > 0 ? moments[l - 1] : 0, n = double(l);
    result[l] = ((n + 1) * moments[l + 1] + n * below) / (2 * n + 1);
  }
  return result;
}

struct Moments {
  int count;

  std::vector<double> operator()(const IsotropicPhase&) const { return powers(0, count); }
  std::vector<double> operator()(const RayleighPhase& p) const {
    std::vector<double> moments = powers(0, count);
    const double gamma = p.depolarisation / (2 - p.depolarisation);
    if (count > 2) moments[2] = 0.1 * (1 - gamma) / (1 + 2 * gamma);
    return moments;
  }
  std::vector<double> operator()(const HenyeyGreensteinPhase& p) const { return powers(p.g, count); }
  std::vector<double> operator()(const DoubleHenyeyGreensteinPhase& p) const {
    std::vector<double> moments = powers(p.g1, count);
    const std::vector<double> others = powers(p.g2, count);
    for (int l = 0; l < count; ++l) moments[l] = p.weight * moments[l] + (1 - p.weight) * others[l];
    return moments;
  }
  // Henyey-Greenstein times 3/2 (1 + cos^2) / (2 + g^2).
  std::vector<double> operator()(const CornetteShanksPhase& p) const {
    std::vector<double> moments = powers(p.g, count + 2);
    const std::vector<double> squared = times_cosine(times_cosine(moments));
    moments.resize(count);
    for (int l = 0; l < count; ++l) moments[l] = 1.5 * (moments[l] + squared[l]) / (2 + p.g * p.g);
    return moments;
  }
  // Linear in the angle between its angles: Gauss in parts so short that the highest polynomial turns less than once.
  std::vector<double> operator()(const TablePhase& p) const {
    static const GaussRule rule(12);
    std::vector<double> moments(count);
    for (std::size_t i = 1; i < p.angles.size(); ++i) {
      const double width = p.angles[i] - p.angles[i - 1];
      const int parts = 1 + int(width * count / 3);
      for (int part = 0; part < parts; ++part)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
          const double share = (part + rule.nodes[k]) / parts, angle = p.angles[i - 1] + share * width;
          const double light = 2 * std::numbers::pi * std::lerp(p.values[i - 1], p.values[i], share) * std::sin(angle) *
                               rule.weights[k] * width / parts;
          const std::vector<double> legendre = legendre_functions(0, count, std::cos(angle));
          for (int l = 0; l < count; ++l) moments[l] += light * legendre[l];
        }
    }
    return moments;
  }
};

}  // namespace

std::vector<double> legendre_moments(const Phase& phase, int count) { return std::visit(Moments{count}, phase); }

std::vector<double> legendre_functions(int m, int count, double mu) {
  std::vector<double> f(count, 0.0);
  if (m >= count) return f;
  // f_m^m = sqrt((2m)!) / (2^m m!) sin^m, up to a sign that products of two lose.
  const double sine = std::sqrt(std::max((1 - mu) * (1 + mu), 0.0));
  f[m] = 1;
  for (int k = 1; k <= m; ++k) f[m] *= sine * std::sqrt((2 * k - 1) / (2.0 * k));
  for (int l = m; l + 1 < count; ++l) {
    const double below = l > m ? std::sqrt(double(l * l - m * m)) * f[l - 1] : 0;
    f[l + 1] = ((2 * l + 1) * mu * f[l] - below) / std::sqrt(double((l + 1) * (l + 1) - m * m));
  }
  return f;
}

}  // namespace airlight::reference
