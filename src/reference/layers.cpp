#include "reference/layers.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace airlight::reference {

Layers::Layers(const Atmosphere& atmosphere)
    : constituents_(int(atmosphere.constituents.size())), planet_radius_(atmosphere.planet.ground_radius) {
  const double top = atmosphere.planet.top_altitude;
  std::vector<double> edges{0, top}, tolerances;
  for (const Constituent& constituent : atmosphere.constituents)
    for (const double kink : kinks(constituent.profile, top)) edges.push_back(kink);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  tops_.push_back(planet_radius_ * planet_radius_);
  scales_.push_back({0, 0});
  for (const Constituent& constituent : atmosphere.constituents) {
    tolerances.push_back(precision * top * mean_density(constituent.profile, 0, top));
    cubics_.push_back(density(constituent.profile, 0));
  }
  cubics_.resize(4 * cubics_.size(), 0.0);
  for (std::size_t i = 1; i < edges.size(); ++i) add_layers(atmosphere, edges[i - 1], edges[i], tolerances, 0);
}

void Layers::add_layers(const Atmosphere& atmosphere, double bottom, double top, std::span<const double> tolerances,
                        int depth) {
  const double low = (planet_radius_ + bottom) * (planet_radius_ + bottom);
  const double high = (planet_radius_ + top) * (planet_radius_ + top);
  const auto altitude = [&](double x) {  // of x in -1..1, without the cancellation of sqrt(radius^2) - planet_radius
    const double share = 0.5 * (1 + x), thickness = top - bottom;
    const double rise = share * thickness * (2 * (planet_radius_ + bottom) + thickness);
    return bottom + rise / (planet_radius_ + bottom + std::sqrt(low + rise));
  };
  // Short lines in thin air need a local precision too, down to air that holds nothing.
  constexpr double relative = 2e-5, negligible = 1e-2;
  // Through the four Chebyshev points, whose error is nearly the smallest of all cubics.
  const double outer = std::cos(std::numbers::pi / 8), inner = std::sin(std::numbers::pi / 8);
  const std::size_t count = atmosphere.constituents.size();
  std::vector<double> cubics(4 * count, 0.0);
  bool good = true;
  for (std::size_t c = 0; c < count && good; ++c) {
    const Profile& profile = atmosphere.constituents[c].profile;
    const double first = density(profile, altitude(-outer)), second = density(profile, altitude(-inner)),
                 third = density(profile, altitude(inner)), fourth = density(profile, altitude(outer));
    // Chebyshev's coefficients: cos(k pi / 8) of odd k are +-outer and +-inner.
    const double middle = 0.25 * (first + second + third + fourth),
                 slope = 0.5 * (outer * (fourth - first) + inner * (third - second)),
                 bend = 0.5 * std::numbers::sqrt2 / 2 * (first - second - third + fourth),
                 twist = 0.5 * (inner * (fourth - first) - outer * (third - second));
    const double p[] = {middle - bend, slope - 3 * twist, 2 * bend, 4 * twist};
    for (const double x : {-0.999999, -0.97, -0.5, -0.2, 0.2, 0.5, 0.97, 0.999999}) {
      const double value = p[0] + x * (p[1] + x * (p[2] + x * p[3]));
      const double error = std::abs(value - density(profile, altitude(x))), weight = error * (top - bottom);
      const bool matters = weight > tolerances[c] || (error > relative * middle && weight > negligible * tolerances[c]);
      good = good && !matters;
    }
    for (std::size_t k = 0; k < 4; ++k) cubics[k * count + c] = p[k];
  }
  constexpr int deepest = 16;  // a density without bounded slope: stop at 2 m of 120 km
  if (!good && depth < deepest) {
    add_layers(atmosphere, bottom, 0.5 * (bottom + top), tolerances, depth + 1);
    add_layers(atmosphere, 0.5 * (bottom + top), top, tolerances, depth + 1);
    return;
  }
  if (!good) {
    std::fill(cubics.begin(), cubics.end(), 0.0);
    for (std::size_t c = 0; c < count; ++c) cubics[c] = mean_density(atmosphere.constituents[c].profile, bottom, top);
  }
  tops_.push_back(high);
  scales_.push_back({0.5 * (low + high), 2 / (high - low)});
  cubics_.insert(cubics_.end(), cubics.begin(), cubics.end());
}

int Layers::layer_at(double radius_squared) const {
  return int(std::upper_bound(tops_.begin(), tops_.end(), radius_squared) - tops_.begin());
}

void Layers::densities(int layer, double radius_squared, std::span<double> densities) const {
  const double x = (radius_squared - scales_[layer].middle) * scales_[layer].scale;
  const std::size_t count = std::size_t(constituents_);
  const double* const p = &cubics_[std::size_t(layer) * 4 * count];
  for (std::size_t k = 0; k < count; ++k)
    densities[k] = std::max(p[k] + x * (p[count + k] + x * (p[2 * count + k] + x * p[3 * count + k])), 0.0);
}

void Layers::add_columns(int layer, double impact_squared, double from, double to, std::span<double> columns) const {
  // About the middle m of the part, half as long as h, x = a + b y + c y^2 with y in -1..1; the means of y^2, y^4 and y^6
  // are 1/3, 1/5 and 1/7. Nothing cancels but in a.
  const double m = 0.5 * (from + to), h = 0.5 * (to - from), scale = scales_[layer].scale;
  const double a = (m * m - (scales_[layer].middle - impact_squared)) * scale, b = 2 * m * h * scale, c = h * h * scale;
  const double bb = b * b, x = a + c / 3, x2 = a * (a + 2 * c / 3) + bb / 3 + c * c / 5,
               x3 = a * (a * (a + c) + bb + 0.6 * c * c) + c * (0.6 * bb + c * c / 7);
  const std::size_t count = std::size_t(constituents_);
  const double* const p = &cubics_[std::size_t(layer) * 4 * count];
  double* __restrict const sums = columns.data();
  for (std::size_t k = 0; k < count; ++k)
    sums[k] += 2 * h * (p[k] + x * p[count + k] + x2 * p[2 * count + k] + x3 * p[3 * count + k]);
}

/// Visits (layer, from, to) of a line inside the air from a point in a layer on.
template <class Visit>
void Layers::follow(int layer, double impact_squared, double from, double to, Visit visit) const {
  for (; from < 0 && layer > 0 && tops_[layer - 1] > impact_squared; --layer) {
    const double next = std::min(-std::sqrt(tops_[layer - 1] - impact_squared), to);
    if (next > from) visit(layer, from, next), from = next;
    if (from >= to) return;
  }
  for (; from < to && layer < int(tops_.size()); ++layer) {
    const double next = std::min(std::sqrt(std::max(tops_[layer] - impact_squared, 0.0)), to);
    if (next > from) visit(layer, from, next), from = next;
  }
}

void Layers::trace(const Vector& place, const Vector& direction, double ground_radius, double distance,
                   Line& line) const {
  const double radius_squared = dot(place, place);
  line.start = dot(place, direction);
  line.impact_squared = std::max(radius_squared - line.start * line.start, 0.0);
  line.meets_ground = false;
  line.borders.clear();
  line.layers.clear();
  line.columns.assign(constituents_, 0.0);

  double from = line.start, to = line.start + distance;
  int layer = layer_at(radius_squared);
  if (layer == int(tops_.size())) {  // in space
    if (line.impact_squared >= tops_.back() || from >= 0) return;
    from = -std::sqrt(tops_.back() - line.impact_squared);
    if (from >= to) return;
    --layer;
  }
  const double ground_squared = ground_radius * ground_radius;
  if (line.start < 0 && line.impact_squared < ground_squared) {
    const double ground = std::max(from, -std::sqrt(ground_squared - line.impact_squared));
    if (ground <= to) {
      to = ground;
      line.meets_ground = true;
    }
  }
  line.borders.push_back(from);
  follow(layer, line.impact_squared, from, to, [&](int visited, double begin, double end) {
    const std::size_t row = line.columns.size();
    line.columns.resize(row + constituents_);
    std::copy_n(line.columns.begin() + row - constituents_, constituents_, line.columns.begin() + row);
    add_columns(visited, line.impact_squared, begin, end, std::span(line.columns).subspan(row));
    line.borders.push_back(end);
    line.layers.push_back(visited);
  });
}

bool Layers::add_columns_to_space(const Vector& place, const Vector& direction, double ground_radius,
                                  std::span<double> columns) const {
  const double radius_squared = dot(place, place), from = dot(place, direction);
  const double impact_squared = std::max(radius_squared - from * from, 0.0);
  if (from < 0 && impact_squared < ground_radius * ground_radius) return false;
  // Rounding may put a place at the top above it.
  const int layer_here = std::min(layer_at(radius_squared), int(tops_.size()) - 1);
  follow(layer_here, impact_squared, from, std::numeric_limits<double>::infinity(),
         [&](int layer, double begin, double end) { add_columns(layer, impact_squared, begin, end, columns); });
  return true;
}

}  // namespace airlight::reference
