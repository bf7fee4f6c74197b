#include "reference/air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight::reference {
namespace {

constexpr int highest_order = 9;
constexpr double share_of_column = 1e-12;  // what a shell may neglect

double mass(const Profile& profile, double bottom, double top, const GaussRule& rule) {
  double sum = 0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k)
    sum += rule.weights[k] * density(profile, bottom + (top - bottom) * rule.nodes[k]);
  return (top - bottom) * sum;
}

}  // namespace

double half_chord(double radius, double impact) {
  return radius > impact ? std::sqrt((radius - impact) * (radius + impact)) : 0;
}

Air::Air(const Atmosphere& atmosphere, int fineness) : planet_radius_(atmosphere.planet.ground_radius) {
  // A polynomial of order n over altitude is one of order 2n over t where a line grazes the shell: n + 1 nodes.
  for (int order = 0; order <= highest_order; ++order) rules_.emplace_back((order + 1) * fineness);

  const double top = atmosphere.planet.top_altitude;
  std::vector<double> edges{0, top};
  for (const Constituent& constituent : atmosphere.constituents) {
    profiles_.push_back(constituent.profile);
    for (const double kink : kinks(constituent.profile, top)) edges.push_back(kink);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  find_landmarks(edges);

  const GaussRule fine(100);
  std::vector<double> tolerances, lowest;
  for (const Profile& profile : profiles_) {
    double column = 0;
    for (std::size_t i = 1; i < edges.size(); ++i) column += mass(profile, edges[i - 1], edges[i], fine);
    tolerances.push_back(share_of_column * column);
    lowest.push_back(density(profile, 0));
  }
  shells_.push_back({planet_radius_, 0, 1, lowest});
  for (std::size_t i = 1; i < edges.size(); ++i)
    for (int part = 0; part < fineness; ++part)
      add_shells(std::lerp(edges[i - 1], edges[i], part / double(fineness)),
                 std::lerp(edges[i - 1], edges[i], (part + 1) / double(fineness)), tolerances, 0);
}

void Air::add_shells(double bottom, double top, std::span<const double> tolerances, int depth) {
  // Interpolation at the Chebyshev points, see Trefethen, Approximation Theory and Approximation Practice, chapter 3.
  constexpr int points = highest_order + 1;
  const int count = constituents();
  std::vector<double> series(points * count, 0.0);
  for (int c = 0; c < count; ++c)
    for (int k = 0; k < points; ++k) {
      const double angle = std::numbers::pi * (k + 0.5) / points;
      const double value = density(profiles_[c], bottom + (top - bottom) * 0.5 * (1 + std::cos(angle)));
      for (int order = 0; order < points; ++order)
        series[order * count + c] += (order == 0 ? 1.0 : 2.0) / points * value * std::cos(order * angle);
    }
  const auto negligible = [&](int order) {
    for (int c = 0; c < count; ++c)
      if (std::abs(series[order * count + c]) * (top - bottom) > tolerances[c]) return false;
    return true;
  };
  constexpr int deepest = 20;  // a density without bounded slope cannot be resolved by halving; stop at 0.1 m of 120 km
  if (depth < deepest && !(negligible(highest_order) && negligible(highest_order - 1))) {
    add_shells(bottom, 0.5 * (bottom + top), tolerances, depth + 1);
    add_shells(0.5 * (bottom + top), top, tolerances, depth + 1);
    return;
  }
  int order = highest_order;
  while (order > 0 && negligible(order)) --order;
  series.resize((order + 1) * count);
  shells_.push_back({planet_radius_ + top, planet_radius_ + 0.5 * (bottom + top), 0.5 * (top - bottom), series});
}

void Air::find_landmarks(std::span<const double> edges) {
  const GaussRule rule(10);
  const auto seen = [&](double bottom, double top) {
    for (const Profile& profile : profiles_) {
      const double middle = 0.5 * (bottom + top);
      const double halves = mass(profile, bottom, middle, rule) + mass(profile, middle, top, rule);
      if (std::abs(mass(profile, bottom, top, rule) - halves) > 0.01 * halves) return false;
    }
    return true;
  };
  landmarks_.push_back(planet_radius_);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    int steps = 1;  // from a kink up, where densities are largest
    while (steps < 1024 && !seen(edges[i - 1], edges[i - 1] + (edges[i] - edges[i - 1]) / steps)) steps *= 2;
    for (int k = 1; k <= steps; ++k)
      landmarks_.push_back(planet_radius_ + std::lerp(edges[i - 1], edges[i], k / double(steps)));
  }

  for (const double edge : edges)
    for (const Profile& profile : profiles_) {
      const double below = density(profile, edge * (1 - 1e-9)),
                   above = edge == edges.back() ? 0 : density(profile, edge * (1 + 1e-9));
      if (edge > 0 && std::abs(above - below) > 1e-3 * std::max(above, below)) {
        jumps_.push_back(planet_radius_ + edge);
        break;
      }
    }
}

void Air::densities(double radius, std::span<double> densities) const {
  for (std::size_t c = 0; c < profiles_.size(); ++c) densities[c] = density(profiles_[c], radius - planet_radius_);
}

void Air::add_columns(double impact, double from, double to, std::span<double> columns) const {
  if (to <= 0) {
    add_rising_columns(impact, -to, -from, columns);
  } else if (from >= 0) {
    add_rising_columns(impact, from, to, columns);
  } else {
    add_rising_columns(impact, 0, -from, columns);
    add_rising_columns(impact, 0, to, columns);
  }
}

void Air::add_rising_columns(double impact, double from, double to, std::span<double> columns) const {
  const double radius = std::hypot(impact, from);
  auto shell =
      std::upper_bound(shells_.begin(), shells_.end(), radius, [](double r, const Shell& s) { return r < s.top; });
  for (; shell != shells_.end() && from < to; ++shell) {
    const double next = std::min(to, half_chord(shell->top, impact));
    if (next > from) {
      add_columns_inside(*shell, impact, from, next, columns);
      from = next;
    }
  }
}

void Air::add_columns_inside(const Shell& shell, double impact, double from, double to,
                             std::span<double> columns) const {
  const std::size_t count = profiles_.size(), orders = shell.series.size() / std::max<std::size_t>(count, 1);
  if (orders == 0) return;
  const GaussRule& rule = rules_[orders - 1];
  const double length = to - from;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = from + length * rule.nodes[k];
    const double z = (std::sqrt(impact * impact + t * t) - shell.middle) / shell.half_thickness;
    const double weight = length * rule.weights[k];
    for (std::size_t c = 0; c < count; ++c) {
      double last = 0, before = 0;  // Clenshaw's recurrence
      for (std::size_t order = orders - 1; order > 0; --order) {
        const double next = shell.series[order * count + c] + 2 * z * last - before;
        before = last;
        last = next;
      }
      columns[c] += weight * (shell.series[c] + z * last - before);
    }
  }
}

}  // namespace airlight::reference
