#include "reference/flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/phase.h"

namespace airlight::reference {
namespace {

/// 1 - exp(-depth), to 1e-14, faster than expm1 is.
double met_share(double depth) {
  if (depth > 0.03) return 1 - std::exp(-depth);
  return depth * (1 - depth / 2 * (1 - depth / 3 * (1 - depth / 4 * (1 - depth / 5))));
}

double sum(std::span<const double> hero_coefficients, std::size_t heroes, std::size_t hero,
           std::span<const double> of) {
  double total = 0;
  for (std::size_t c = 0; c < of.size(); ++c) total += hero_coefficients[c * heroes + hero] * of[c];
  return total;
}

}  // namespace

void Flight::aim(const Layers& layers, const Optics& optics, const Guide& guide, const Surface* surface,
                 const Place& from, const Vector& sun, double ground_radius, double distance, bool scattered_only,
                 bool count_ground) {
  distance_ = distance;
  solid_.reset();
  if (surface) solid_ = surface->hit(from, distance);
  layers.trace(from.position, from.direction, ground_radius, solid_ ? solid_->distance : distance, line_);
  if (line_.meets_ground || line_.borders.empty()) solid_.reset();
  if (solid_) line_.meets_ground = true;
  const std::size_t heroes = optics.heroes, count = optics.constituents;
  group(layers.together());
  const std::size_t pieces = ends_.size() - 1;
  stride_ = pieces + 2;
  light_.assign(heroes, 0.0);
  for (auto* const table : {&analog_, &depths_, &guide_, &sums_}) table->assign(heroes * stride_, 0.0);

  // Sunlight comes from one direction: the flight tells the angle by which all its places scatter it.
  phases_.resize(count);
  for (std::size_t c = 0; c < count; ++c)
    phases_[c] = 4 * std::numbers::pi * phase(optics.phases[c], one_minus_cos(from.direction, sun));
  const double sun_height = dot(from.position, sun), sun_slope = dot(from.direction, sun);
  const auto sun_cosine = [&](double t, double radius_squared) {
    return (sun_height + (t - line_.start) * sun_slope) / std::sqrt(radius_squared);
  };
  std::array<double, Optics::most_heroes> transmittance;
  transmittance.fill(1.0);
  double all_guided = 0, all_analog = 0;
  const auto add = [&](std::size_t place, double probability, double light) {
    analog_[place] = probability;
    guide_[place] = light;
    all_analog += probability;
    all_guided += probability * light;
  };
  for (std::size_t k = 0; k < pieces; ++k) {
    const double t = 0.5 * (line_.borders[ends_[k]] + line_.borders[ends_[k + 1]]),
                 radius_squared = line_.impact_squared + t * t;
    const Guide::Light light = guide.air(radius_squared, sun_cosine(t, radius_squared));
    const double* const column = line_.columns.data() + ends_[k] * count;
    const double* const next = line_.columns.data() + ends_[k + 1] * count;
    for (std::size_t g = 0; g < heroes; ++g) {
      double extinction = 0, scattering = 0, towards_sun = 0;
      for (std::size_t c = 0; c < count; ++c) {
        const double inside = next[c] - column[c], part = optics.hero_scattering[c * heroes + g] * inside;
        extinction += optics.hero_extinction[c * heroes + g] * inside;
        scattering += part;
        towards_sun += part * phases_[c];
      }
      if (extinction <= 0) continue;
      depths_[g * stride_ + k] = extinction;
      const double met = transmittance[g] * met_share(extinction);
      transmittance[g] -= met;
      if (scattering > 0)
        add(g * stride_ + k, met * scattering / extinction,
            light.scattered + (scattered_only ? 0 : (light.all - light.scattered) * towards_sun / scattering));
    }
  }
  if (line_.meets_ground && count_ground && (solid_ || optics.hero_albedo[0] > 0)) {
    const double t = line_.borders.back(), radius_squared = line_.impact_squared + t * t;
    const double cosine = sun_cosine(t, radius_squared);
    const Guide::Light light = solid_ ? guide.air(radius_squared, cosine) : guide.ground(cosine);
    for (std::size_t g = 0; g < heroes; ++g)
      add(g * stride_ + pieces, transmittance[g], scattered_only ? light.scattered : light.all);
  }
  if (all_analog <= 0) return;
  // A tenth of all walks goes where air scatters, whatever the guide says: no weight is more than ten times too large.
  const double unguided = all_guided > 0 ? 0.1 * all_guided / all_analog : 1;
  for (double& light : guide_) light += unguided;
  add_up();
}

void Flight::add_up() {
  for (std::size_t g = 0; g < light_.size(); ++g) {
    double sum = 0;
    for (std::size_t i = g * stride_; i + 1 < (g + 1) * stride_; ++i) {
      sum += analog_[i] * guide_[i];
      sums_[i + 1] = sum;
    }
    light_[g] = sum;
  }
}

void Flight::give_each_a_share(double least) {
  for (std::size_t g = 0; g < light_.size(); ++g) {
    const std::size_t ground = (g + 1) * stride_ - 2;
    const double from_ground = analog_[ground] * guide_[ground], from_air = light_[g] - from_ground;
    if (from_ground <= 0 || from_air <= 0) continue;
    if (from_ground < least * from_air) guide_[ground] *= least * from_air / from_ground;
    if (from_air < least * from_ground)
      for (std::size_t i = g * stride_; i < ground; ++i) guide_[i] *= least * from_ground / from_air;
  }
  add_up();
}

/// Joins the line's short stretches.
void Flight::group(std::size_t together) {
  ends_.assign(1, 0);
  for (std::size_t i = together; i < line_.layers.size(); i += together) ends_.push_back(i);
  if (!line_.layers.empty()) ends_.push_back(line_.layers.size());
}

/// Where a hero's optical depth from the piece's begin has a value: Newton's method, kept between bounds.
void Flight::find(const Layers& layers, const Optics& optics, std::size_t hero, std::size_t piece, double depth,
                  Event& event) const {
  const std::size_t count = optics.constituents;
  const auto columns_at = [&](std::size_t border) { return std::span(line_.columns).subspan(border * count, count); };
  const auto depth_at = [&](std::size_t border) {
    return sum(optics.hero_extinction, optics.heroes, hero, columns_at(border));
  };
  const double target = depth_at(ends_[piece]) + depth;
  std::size_t i = ends_[piece];
  while (i + 1 < ends_[piece + 1] && depth_at(i + 1) < target) ++i;
  const double begin = line_.borders[i], thickness = line_.borders[i + 1] - begin;
  const double before = depth_at(i), whole = depth_at(i + 1) - before;
  double low = begin, high = begin + thickness;
  event.columns.resize(count);
  event.densities.resize(count);
  event.t = begin + thickness * (whole > 0 ? std::clamp((target - before) / whole, 0.0, 1.0) : 0.5);
  constexpr int most = 60;
  for (int step = 0; step < most; ++step) {
    std::copy_n(columns_at(i).begin(), count, event.columns.begin());
    layers.add_columns(line_.layers[i], line_.impact_squared, begin, event.t, event.columns);
    layers.densities(line_.layers[i], line_.impact_squared + event.t * event.t, event.densities);
    const double missing = target - sum(optics.hero_extinction, optics.heroes, hero, event.columns);
    const double extinction = sum(optics.hero_extinction, optics.heroes, hero, event.densities);
    (missing > 0 ? low : high) = event.t;
    double next = event.t + missing / extinction;
    if (std::abs(next - event.t) <= 1e-9 * thickness) break;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    event.t = next;
  }
}

bool Flight::draw(const Layers& layers, const Optics& optics, std::span<const double> weights, double first,
                  double second, Event& event) const {
  double whole = 0;
  for (std::size_t g = 0; g < light_.size(); ++g) whole += weights[g] * light_[g];
  if (!(whole > 0)) return false;
  std::size_t hero = 0;
  for (double left = first * whole; hero + 1 < light_.size(); ++hero)
    if ((left -= weights[hero] * light_[hero]) < 0) break;
  if (light_[hero] <= 0) return false;
  const auto row = sums_.begin() + hero * stride_;
  const double target = second * light_[hero];
  const std::size_t pieces = stride_ - 2, count = optics.constituents;
  const std::size_t k = std::min<std::size_t>(std::upper_bound(row, row + stride_, target) - row - 1, pieces);
  event.ground = k == pieces;
  event.density = 0;
  if (event.ground) {
    event.t = line_.borders.back();
    event.columns.assign(line_.columns.end() - count, line_.columns.end());
    for (std::size_t g = 0; g < light_.size(); ++g)
      event.density += weights[g] * analog_[g * stride_ + k] * guide_[g * stride_ + k] / whole;
    return event.density > 0;
  }
  const double share = std::clamp((target - row[k]) / (row[k + 1] - row[k]), 0.0, 1.0);
  find(layers, optics, hero, k, -std::log1p(-share * met_share(depths_[hero * stride_ + k])), event);
  for (std::size_t g = 0; g < light_.size(); ++g) {
    const double depth = depths_[g * stride_ + k];
    if (!(depth > 0)) continue;
    const double before =
        sum(optics.hero_extinction, light_.size(), g, std::span(line_.columns).subspan(ends_[k] * count, count));
    const double inside = sum(optics.hero_extinction, light_.size(), g, event.columns) - before;
    event.density += weights[g] * guide_[g * stride_ + k] / whole * analog_[g * stride_ + k] * std::exp(-inside) /
                     met_share(depth) * sum(optics.hero_extinction, light_.size(), g, event.densities);
  }
  return event.density > 0;
}

}  // namespace airlight::reference
