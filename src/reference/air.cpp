#include "reference/air.h"

#include <algorithm>
#include <cmath>

namespace airlight::reference {

double half_chord(double radius, double impact) {
  return radius > impact ? std::sqrt((radius - impact) * (radius + impact)) : 0;
}

Air::Air(const Atmosphere& atmosphere, int nodes) : planet_radius_(atmosphere.planet.ground_radius), rule_(nodes) {
  const double top = atmosphere.planet.top_altitude;
  std::vector<double> edges{0, top};
  for (const Constituent& constituent : atmosphere.constituents) {
    profiles_.push_back(constituent.profile);
    for (const double kink : airlight::kinks(constituent.profile, top)) edges.push_back(kink);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const double edge : edges) kinks_.push_back(planet_radius_ + edge);

  // An error of the optical depth counts absolutely (T = exp(-tau)), so one tolerance serves all altitudes.
  std::vector<double> tolerances;
  const GaussRule fine(200);
  for (const Profile& profile : profiles_) {
    double column = 0;
    for (std::size_t i = 1; i < edges.size(); ++i)
      for (std::size_t k = 0; k < fine.nodes.size(); ++k) {
        const double thickness = edges[i] - edges[i - 1];
        column += thickness * fine.weights[k] * density(profile, edges[i - 1] + thickness * fine.nodes[k]);
      }
    tolerances.push_back(1e-11 * column);
  }
  shells_.push_back(kinks_.front());
  for (std::size_t i = 1; i < edges.size(); ++i) add_shells(edges[i - 1], edges[i], tolerances, 0);
}

void Air::add_shells(double bottom, double top, std::span<const double> tolerances, int depth) {
  const auto column = [&](const Profile& profile, double from, double to, bool grazing) {
    double sum = 0;
    for (std::size_t k = 0; k < rule_.nodes.size(); ++k) {
      const double u = std::lerp(from, to, rule_.nodes[k]);
      const double altitude = bottom + (top - bottom) * (grazing ? u * u : u);
      sum += (to - from) * rule_.weights[k] * density(profile, altitude);
    }
    return (top - bottom) * sum;
  };
  const double middle = 0.5 * (bottom + top);
  constexpr int deepest = 20;  // a density without bounded slope cannot be resolved by halving; stop at 0.1 m of 120 km
  bool resolved = true;
  for (std::size_t c = 0; c < profiles_.size(); ++c)
    for (const bool grazing : {false, true}) {
      const auto& profile = profiles_[c];
      const double halves = column(profile, 0, 0.5, grazing) + column(profile, 0.5, 1, grazing);
      resolved = resolved && std::abs(halves - column(profile, 0, 1, grazing)) <= tolerances[c];
    }
  if (resolved || depth == deepest) {
    shells_.push_back(planet_radius_ + top);
  } else {
    add_shells(bottom, middle, tolerances, depth + 1);
    add_shells(middle, top, tolerances, depth + 1);
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
  auto shell = std::upper_bound(shells_.begin(), shells_.end(), std::hypot(impact, from));
  for (; shell != shells_.end() && from < to; ++shell) {
    const double next = std::min(to, half_chord(*shell, impact));
    if (next > from) {
      add_smooth_columns(impact, from, next, columns);
      from = next;
    }
  }
}

void Air::add_smooth_columns(double impact, double from, double to, std::span<double> columns) const {
  const double length = to - from;
  for (std::size_t k = 0; k < rule_.nodes.size(); ++k) {
    const double t = from + length * rule_.nodes[k];
    const double altitude = std::sqrt(impact * impact + t * t) - planet_radius_;
    const double weight = length * rule_.weights[k];
    for (std::size_t c = 0; c < profiles_.size(); ++c) columns[c] += weight * density(profiles_[c], altitude);
  }
}

}  // namespace airlight::reference
