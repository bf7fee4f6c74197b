#include "model/virtual_dome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace airlight {
namespace {

using std::numbers::pi;
using Point = std::array<double, 3>;

// Gauss and Legendre's rule of five points, on [0, 1].
constexpr std::array<double, 5> nodes{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842, 0.953089922969332};
constexpr std::array<double, 5> weights{0.118463442528095, 0.239314335249683, 0.284444444444444, 0.239314335249683,
                                        0.118463442528095};

/// Downhill simplex (Nelder & Mead 1965, doi:10.1093/comjnl/7.4.308) in three dimensions.
template <class Function>
Point least(const Function& f, const Point& start, const Point& spread) {
  struct Corner {
    Point at;
    double value;
  };
  std::vector<Corner> simplex{{start, f(start)}};
  for (std::size_t i = 0; i < 3; ++i) {
    Point p = start;
    p[i] += spread[i];
    simplex.push_back({p, f(p)});
  }
  for (int step = 0; step < 400; ++step) {
    std::ranges::sort(simplex, {}, &Corner::value);
    Point middle{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 3; ++i) middle[i] += simplex[c].at[i] / 3;
    const auto away = [&](double factor) {
      Point p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = middle[i] + factor * (simplex[3].at[i] - middle[i]);
      return Corner{p, f(p)};
    };
    const Corner mirrored = away(-1);
    if (mirrored.value < simplex[0].value) {
      const Corner further = away(-2);
      simplex[3] = further.value < mirrored.value ? further : mirrored;
    } else if (mirrored.value < simplex[2].value) {
      simplex[3] = mirrored;
    } else if (const Corner nearer = away(0.5); nearer.value < simplex[3].value) {
      simplex[3] = nearer;
    } else {
      for (std::size_t c = 1; c < 4; ++c) {
        for (std::size_t i = 0; i < 3; ++i) simplex[c].at[i] = (simplex[c].at[i] + simplex[0].at[i]) / 2;
        simplex[c].value = f(simplex[c].at);
      }
    }
  }
  return std::ranges::min(simplex, {}, &Corner::value).at;
}

}  // namespace

double dome_path(const DomeAir& air, double zenith) {
  const double mu = std::cos(zenith), r = air.radius, along = r * mu;
  // Root of |ground + s view| = r + top, without cancellation.
  const double gap = air.top * (2 * r + air.top), reach = gap / (along + std::sqrt(along * along + gap));
  constexpr int panels = 256;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double s = reach * (i + nodes[k]) / panels;
      const double altitude = s * (2 * along + s) / (std::sqrt(r * r + s * (2 * along + s)) + r);
      sum += weights[k] * std::exp(-altitude / air.height);
    }
  }
  return sum * reach / panels;
}

double DomeFit::at(double zenith) const {
  return height / (std::cos(zenith) + a * std::pow(b - zenith * 180 / pi, -c));
}

DomeFit fit_dome(const DomeAir& air) {
  const DomeAir earth;
  if (air.radius == earth.radius && air.top == earth.top) {
    if (air.height == 8000) return {8000, 1.351853, 98.052785, 1.853915};
    if (air.height == 1200) return {1200, 0.0362133, 92.297249, 1.434145};
  }
  std::vector<std::array<double, 2>> samples;  // zenith, path
  for (int i = 0; i <= 60; ++i) {
    const double rest = 1 - i / 60.0, zenith = pi / 2 * (1 - rest * rest);
    samples.push_back({zenith, dome_path(air, zenith)});
  }
  const auto surface = [&](const Point& p) {
    return DomeFit{air.height, std::exp(p[0]), 90 + std::exp(p[1]), std::exp(p[2])};
  };
  // A high power of the errors' norm stands for the largest, and is smooth.
  const auto error = [&](const Point& p) {
    const DomeFit fit = surface(p);
    double sum = 0;
    for (const auto& [zenith, path] : samples) sum += std::pow(fit.at(zenith) / path - 1, 16);
    return std::isfinite(sum) ? std::pow(sum, 1 / 16.0) : 1e9;
  };
  // Scale of angles near the horizon: there a ray rises by a scale height within sqrt(2 height / radius).
  const double scale = std::sqrt(2 * air.height / air.radius) * 180 / pi, c = 1.6;
  const double level = samples.back()[1] / air.height, b = std::log(2.4 * scale);
  Point p{c * b - std::log(level), b, std::log(c)};
  for (int restart = 0; restart < 3; ++restart) p = least(error, p, {0.3, 0.2, 0.1});
  return surface(p);
}

}  // namespace airlight
