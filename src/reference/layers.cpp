#include "reference/layers.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "every_processor.h"

namespace airlight::reference {
namespace {

/// Means of x, x^2 and x^3 over a part of a line, x being -1..1 over radius^2 in its layer: x = a + b y + c y^2 about the
/// part's middle, with y in -1..1; the means of y^2, y^4 and y^6 are 1/3, 1/5 and 1/7. Nothing cancels but in a.
struct Means {
  double x, x2, x3;
};
AIRLIGHT_INLINE Means means(double from, double to, double impact_squared, double middle, double scale) {
  const double m = 0.5 * (from + to), h = 0.5 * (to - from);
  const double a = (m * m - (middle - impact_squared)) * scale, b = 2 * m * h * scale, c = h * h * scale, bb = b * b;
  return {a + c * (1 / 3.0), a * (a + c * (2 / 3.0)) + bb * (1 / 3.0) + c * c * (1 / 5.0),
          a * (a * (a + c) + bb + 0.6 * c * c) + c * (0.6 * bb + c * c * (1 / 7.0))};
}

/// A line that rises through neighbouring layers: the parts between t and t, some at a time, so that loops become vector
/// instructions.
struct Rise {
  static constexpr int most = 64;
  std::array<double, most + 1> t;
  std::array<double, most> length, x, x2, x3;
  std::array<double, most> columns;  ///< of one constituent [m]
};

/// @param end  in rise.t the first is given; the others are where the line leaves the layers, none beyond this
AIRLIGHT_EVERY_PROCESSOR
void rise_through(const double* __restrict tops, const double* __restrict middles, const double* __restrict scales,
                  int count, double impact_squared, double end, Rise& rise) {
  const double begin = rise.t[0];
  for (int i = 0; i < count; ++i) {
    const double above = tops[i] - impact_squared, t = std::sqrt(above > 0 ? above : 0);
    rise.t[i + 1] = t < begin ? begin : t > end ? end : t;
  }
  for (int i = 0; i < count; ++i) {
    const Means mean = means(rise.t[i], rise.t[i + 1], impact_squared, middles[i], scales[i]);
    rise.length[i] = rise.t[i + 1] - rise.t[i];
    rise.x[i] = mean.x, rise.x2[i] = mean.x2, rise.x3[i] = mean.x3;
  }
}

AIRLIGHT_EVERY_PROCESSOR
void gather(const double* __restrict p0, const double* __restrict p1, const double* __restrict p2,
            const double* __restrict p3, int count, Rise& rise) {
  for (int i = 0; i < count; ++i)
    rise.columns[i] = rise.length[i] * (p0[i] + rise.x[i] * p1[i] + rise.x2[i] * p2[i] + rise.x3[i] * p3[i]);
}

}  // namespace

Layers::Layers(const Atmosphere& atmosphere, double coarseness)
    : constituents_(int(atmosphere.constituents.size())),
      planet_radius_(atmosphere.planet.ground_radius),
      together_(coarseness > 1 ? 1 : 4) {
  const double top = atmosphere.planet.top_altitude;
  const double relative = 2e-5 * coarseness;
  std::vector<double> edges{0, top}, tolerances;
  for (const Constituent& constituent : atmosphere.constituents)
    for (const double kink : kinks(constituent.profile, top))
      if (coarseness <= 1) edges.push_back(kink);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  tops_.push_back(planet_radius_ * planet_radius_);
  middles_.push_back(0);
  scales_.push_back(0);
  cubics_.resize(4 * atmosphere.constituents.size(), {0.0});
  for (std::size_t c = 0; c < atmosphere.constituents.size(); ++c) {
    const Profile& profile = atmosphere.constituents[c].profile;
    tolerances.push_back(coarseness * precision * top * mean_density(profile, 0, top));
    cubics_[4 * c][0] = density(profile, 0);
  }
  for (std::size_t i = 1; i < edges.size(); ++i)
    add_layers(atmosphere, edges[i - 1], edges[i], tolerances, relative, 0);
}

void Layers::add_layers(const Atmosphere& atmosphere, double bottom, double top, std::span<const double> tolerances,
                        double relative, int depth) {
  const double low = (planet_radius_ + bottom) * (planet_radius_ + bottom);
  const double high = (planet_radius_ + top) * (planet_radius_ + top);
  const auto altitude = [&](double x) {  // of x in -1..1, without the cancellation of sqrt(radius^2) - planet_radius
    const double share = 0.5 * (1 + x), thickness = top - bottom;
    const double rise = share * thickness * (2 * (planet_radius_ + bottom) + thickness);
    return bottom + rise / (planet_radius_ + bottom + std::sqrt(low + rise));
  };
  // Short lines in thin air need a local precision too, down to air that holds nothing.
  constexpr double negligible = 1e-2;
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
    std::copy_n(p, 4, &cubics[4 * c]);
  }
  constexpr int deepest = 16;  // a density without bounded slope: stop at 2 m of 120 km
  if (!good && depth < deepest) {
    add_layers(atmosphere, bottom, 0.5 * (bottom + top), tolerances, relative, depth + 1);
    add_layers(atmosphere, 0.5 * (bottom + top), top, tolerances, relative, depth + 1);
    return;
  }
  if (!good) {
    std::fill(cubics.begin(), cubics.end(), 0.0);
    for (std::size_t c = 0; c < count; ++c)
      cubics[4 * c] = mean_density(atmosphere.constituents[c].profile, bottom, top);
  }
  tops_.push_back(high);
  middles_.push_back(0.5 * (low + high));
  scales_.push_back(2 / (high - low));
  for (std::size_t k = 0; k < cubics.size(); ++k) cubics_[k].push_back(cubics[k]);
}

int Layers::layer_at(double radius_squared) const {
  return int(std::upper_bound(tops_.begin(), tops_.end(), radius_squared) - tops_.begin());
}

void Layers::densities(int layer, double radius_squared, std::span<double> densities) const {
  const double x = (radius_squared - middles_[layer]) * scales_[layer];
  for (int k = 0; k < constituents_; ++k)
    densities[k] = std::max(
        cubic(k, 0)[layer] + x * (cubic(k, 1)[layer] + x * (cubic(k, 2)[layer] + x * cubic(k, 3)[layer])), 0.0);
}

void Layers::add_columns(int layer, double impact_squared, double from, double to, std::span<double> columns) const {
  const Means mean = means(from, to, impact_squared, middles_[layer], scales_[layer]);
  for (int k = 0; k < constituents_; ++k)
    columns[k] += (to - from) * (cubic(k, 0)[layer] + mean.x * cubic(k, 1)[layer] + mean.x2 * cubic(k, 2)[layer] +
                                 mean.x3 * cubic(k, 3)[layer]);
}

/// Visits the parts of a line that rises from t to t through layers, of each constituent after the other: visit(done, count,
/// constituent, rise), done parts having gone before these.
template <class Visit>
void Layers::climb(int first, int last, double impact_squared, double from, double to, Visit visit) const {
  Rise rise;
  rise.t[0] = from;
  for (int layer = first; layer <= last; layer += Rise::most) {
    const int count = std::min(last + 1 - layer, Rise::most);
    rise_through(&tops_[layer], &middles_[layer], &scales_[layer], count, impact_squared, to, rise);
    for (int k = 0; k < constituents_; ++k) {
      gather(cubic(k, 0) + layer, cubic(k, 1) + layer, cubic(k, 2) + layer, cubic(k, 3) + layer, count, rise);
      visit(layer - first, count, k, rise);
    }
    rise.t[0] = rise.t[count];
  }
}

/// The part of a line inside the air; a line that goes down before it rises is two climbs, the first of them backwards.
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
  const int top = int(tops_.size()) - 1;
  if (layer > top) {  // in space
    if (line.impact_squared >= tops_.back() || from >= 0) return;
    from = -std::sqrt(tops_.back() - line.impact_squared);
    if (from >= to) return;
    layer = top;
  }
  const double ground_squared = ground_radius * ground_radius;
  if (line.start < 0 && line.impact_squared < ground_squared) {
    const double ground = std::max(from, -std::sqrt(ground_squared - line.impact_squared));
    if (ground <= to) {
      to = ground;
      line.meets_ground = true;
    }
  }
  const auto layer_of = [&](double t) { return std::min(layer_at(line.impact_squared + t * t), top); };
  const auto make_room = [&](int parts) {
    const std::size_t before = line.layers.size();
    line.layers.resize(before + parts);
    line.borders.resize(before + parts + 1);
    line.columns.resize((before + parts + 1) * constituents_);
    return before;
  };
  line.borders.push_back(from);
  if (from < 0) {
    const double end = std::min(to, 0.0);
    const int lowest = std::min(layer_of(end), layer), parts = layer + 1 - lowest;
    make_room(parts);
    climb(lowest, layer, line.impact_squared, -end, -from, [&](int done, int count, int k, const Rise& rise) {
      for (int i = 0; i < count; ++i) {
        const int nth = parts - (done + i);  // border at the part's far end
        line.layers[nth - 1] = lowest + done + i;
        line.borders[nth] = -rise.t[i];
        line.columns[nth * constituents_ + k] = rise.columns[i];
      }
    });
    from = end;
    layer = lowest;
  }
  to = std::min(to, std::sqrt(std::max(tops_.back() - line.impact_squared, 0.0)));
  if (from < to) {
    const int highest = std::max(layer_of(to), layer);
    const std::size_t before = make_room(highest + 1 - layer);
    climb(layer, highest, line.impact_squared, from, to, [&](int done, int count, int k, const Rise& rise) {
      for (int i = 0; i < count; ++i) {
        const std::size_t nth = before + done + i + 1;
        line.layers[nth - 1] = layer + done + i;
        line.borders[nth] = rise.t[i + 1];
        line.columns[nth * constituents_ + k] = rise.columns[i];
      }
    });
  }
  for (std::size_t i = constituents_; i < line.columns.size(); ++i) line.columns[i] += line.columns[i - constituents_];
}

bool Layers::add_columns_to_space(const Vector& place, const Vector& direction, double ground_radius,
                                  std::span<double> columns) const {
  const double radius_squared = dot(place, place), from = dot(place, direction);
  const double impact_squared = std::max(radius_squared - from * from, 0.0);
  if (from < 0 && impact_squared < ground_radius * ground_radius) return false;
  // Rounding may put a place at the top above it.
  const int top = int(tops_.size()) - 1, here = std::min(layer_at(radius_squared), top);
  const auto add = [&](int, int count, int k, const Rise& rise) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += rise.columns[i];
    columns[k] += sum;
  };
  const int lowest = from < 0 ? std::min(layer_at(impact_squared), here) : here;
  if (from < 0) climb(lowest, here, impact_squared, 0, -from, add);
  climb(lowest, top, impact_squared, std::max(from, 0.0), std::sqrt(std::max(tops_.back() - impact_squared, 0.0)), add);
  return true;
}

}  // namespace airlight::reference
