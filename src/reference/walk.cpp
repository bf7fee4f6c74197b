#include "reference/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/phase.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

}  // namespace

WalkRules::WalkRules(const Atmosphere& atmosphere, std::span<const double> wavelengths,
                     const MonteCarloSettings& settings)
    : layers(atmosphere),
      optics(atmosphere, wavelengths, settings.point_sun),
      guide(layers, optics, !settings.guided || settings.uniform_light),
      max_order(settings.max_order > 0 ? settings.max_order : std::numeric_limits<int>::max()),
      candidates(settings.guided && !settings.uniform_light ? 2 : 1),
      kept_orders(settings.kept_orders),
      uniform_light(settings.uniform_light) {}

Walker::Walker(const WalkRules& rules)
    : rules_(rules),
      weights_(rules.optics.wavelengths),
      importance_(rules.optics.heroes),
      hero_weights_(rules.optics.heroes),
      columns_(rules.optics.constituents),
      sunlight_(rules.optics.wavelengths),
      shares_(rules.optics.constituents),
      factor_(rules.optics.wavelengths),
      hero_factor_(rules.optics.heroes),
      taken_factor_(rules.optics.wavelengths) {}

Flight Walker::first_flight(const WalkStart& start) const {
  Flight flight;
  flight.aim(rules_.layers, rules_.optics, rules_.guide, start.place, start.sun, start.ground_radius, start.distance,
             start.first_order > 1, start.count_ground);
  return flight;
}

void Walker::walk(const WalkStart& start, const Flight& first, double where, double weight, Random& random,
                  std::span<double> light) {
  std::fill(weights_.begin(), weights_.end(), weight);
  for (std::size_t g = 0; g < importance_.size(); ++g)
    importance_[g] = first.light()[g] > 0 ? 1 / (first.light()[g] * weight * double(importance_.size())) : 0;
  if (rules_.uniform_light && std::isinf(start.distance)) add_light_of_space(first, 1, light);
  if (!move(start, start.place, first, where, random)) return;
  for (int order = 1;; ++order) {
    if (order >= start.first_order && !rules_.uniform_light) add_sunlight(start, order, random, light);
    if (order == rules_.max_order || !turn(start, random)) return;
    if (rules_.uniform_light) add_light_of_space(flight_, order, light);
    if (!move(start, {position_, direction_}, flight_, random(), random)) return;
  }
}

std::span<double> Walker::row(int order, std::span<double> light) const {
  return light.subspan(std::size_t(std::min(order, rules_.kept_orders) - 1) * weights_.size(), weights_.size());
}

/// Goes along a flight to the next place. @returns false where no light can come from there.
bool Walker::move(const WalkStart& start, const Place& from, const Flight& flight, double where, Random& random) {
  rules_.optics.hero_values(weights_, hero_weights_);
  for (std::size_t g = 0; g < hero_weights_.size(); ++g) hero_weights_[g] *= importance_[g];
  if (!flight.draw(rules_.layers, rules_.optics, hero_weights_, random(), where, event_)) return false;
  for (std::size_t w = 0; w < weights_.size(); ++w)
    weights_[w] *= std::exp(-rules_.optics.optical_depth(event_.columns, w)) / event_.density;
  direction_ = from.direction;
  position_ = along(from.position, event_.t - flight.line().start, from.direction);
  if (event_.ground) {
    const double scale = start.ground_radius / length(position_);
    for (double& x : position_) x *= scale;
  }
  return true;
}

void Walker::add_sunlight(const WalkStart& start, int order, Random& random, std::span<double> light) {
  const Optics& optics = rules_.optics;
  const auto element = optics.sun_element(start.sun, random, sunlight_);
  const double incidence = event_.ground ? dot(unit(position_), element.direction) / element.projection : 1;
  if (incidence <= 0) return;
  std::fill(columns_.begin(), columns_.end(), 0.0);
  if (!rules_.layers.add_columns_to_space(position_, element.direction, start.ground_radius, columns_)) return;

  const std::span<double> result = row(order, light);
  if (!event_.ground) {
    // The scattering angle is taken to the disc's centre, as in single scattering by quadrature.
    const double angle = one_minus_cos(direction_, start.sun);
    for (std::size_t c = 0; c < shares_.size(); ++c) shares_[c] = event_.densities[c] * phase(optics.phases[c], angle);
  }
  for (std::size_t w = 0; w < result.size(); ++w) {
    double source = 0;
    if (event_.ground) {
      source = optics.albedo[w] / pi * incidence;
    } else {
      for (std::size_t c = 0; c < shares_.size(); ++c)
        source += optics.scattering[c * optics.wavelengths + w] * shares_[c];
    }
    result[w] += weights_[w] * source * sunlight_[w] * std::exp(-optics.optical_depth(columns_, w));
  }
}

void Walker::add_light_of_space(const Flight& flight, int order, std::span<double> light) {
  const Line& line = flight.line();
  if (line.meets_ground) return;
  const auto whole = std::span(line.columns).last(columns_.size());
  const std::span<double> result = row(order, light);
  for (std::size_t w = 0; w < result.size(); ++w)
    result[w] += weights_[w] * std::exp(-rules_.optics.optical_depth(whole, w));
}

/// Draws a direction, and writes into factor_ what it does to the weights.
Vector Walker::draw_direction(const WalkStart& start, Random& random) {
  const Optics& optics = rules_.optics;
  if (event_.ground) {
    std::copy(optics.albedo.begin(), optics.albedo.end(), factor_.begin());
    const double square = random();  // of the cosine: Lambert's law
    return around(unit(position_), std::sqrt(1 - square), std::sqrt(square), 2 * pi * random());
  }
  // Each constituent in proportion to what it scatters of the light that matters.
  double whole = 0;
  for (std::size_t c = 0; c < shares_.size(); ++c) {
    shares_[c] = 0;
    for (std::size_t g = 0; g < optics.heroes; ++g)
      shares_[c] += hero_weights_[g] * optics.hero_scattering[c * optics.heroes + g] * event_.densities[c];
    whole += shares_[c];
  }
  double left = random() * whole;
  std::size_t chosen = 0;
  while (chosen + 1 < shares_.size() && (left -= shares_[chosen]) >= 0) ++chosen;
  // Light that is scattered sharply forward is found around the direction of looking, and around the sun.
  const bool sun_is_up = dot(position_, start.sun) > -0.02 * length(position_) && !rules_.uniform_light;
  const double around_sun = sun_is_up ? 0.3 : 0;
  const Vector& axis = random() < around_sun ? start.sun : direction_;
  const double from_axis = optics.samplers[chosen].one_minus_cos(random());
  const Vector direction = around(axis, std::sqrt(from_axis * (2 - from_axis)), 1 - from_axis, 2 * pi * random());
  const double angle = one_minus_cos(direction, direction_), from_sun = one_minus_cos(direction, start.sun);
  double drawn = 0;
  std::fill(factor_.begin(), factor_.end(), 0.0);
  for (std::size_t c = 0; c < shares_.size(); ++c) {
    if (shares_[c] > 0)
      drawn += shares_[c] / whole *
               ((1 - around_sun) * optics.samplers[c].density(angle) +
                (around_sun > 0 ? around_sun * optics.samplers[c].density(from_sun) : 0));
    const double scattered = event_.densities[c] * phase(optics.phases[c], angle);
    for (std::size_t w = 0; w < factor_.size(); ++w)
      factor_[w] += optics.scattering[c * optics.wavelengths + w] * scattered;
  }
  for (double& factor : factor_) factor = drawn > 0 ? factor / drawn : 0;
  return direction;
}

/// Takes a new direction and aims the next flight. Of several candidates one is taken in proportion to the light that
/// it promises (resampled importance sampling: Talbot, Cline & Egbert 2005), and a walk that promises little ends by
/// Russian roulette. @returns false when it ended.
bool Walker::turn(const WalkStart& start, Random& random) {
  const Optics& optics = rules_.optics;
  rules_.optics.hero_values(weights_, hero_weights_);
  for (std::size_t g = 0; g < hero_weights_.size(); ++g) hero_weights_[g] *= importance_[g];
  double sum = 0, taken = 0;
  Vector direction{};
  for (int i = 0; i < rules_.candidates; ++i) {
    const Vector towards = draw_direction(start, random);
    candidate_.aim(rules_.layers, optics, rules_.guide, {position_, towards}, start.sun, start.ground_radius,
                   std::numeric_limits<double>::infinity(), false, true);
    optics.hero_values(factor_, hero_factor_);
    double promise = 0;
    for (std::size_t g = 0; g < optics.heroes; ++g)
      promise += hero_weights_[g] * hero_factor_[g] * candidate_.light()[g];
    sum += promise;
    if (i > 0 && !(random() * sum < promise)) continue;
    taken = promise;
    direction = towards;
    std::swap(flight_, candidate_);
    std::swap(taken_factor_, factor_);
  }
  if (!(taken > 0) && !rules_.uniform_light) return false;
  double scale = taken > 0 ? sum / (rules_.candidates * taken) : 1;
  constexpr double enough = 0.2, least_chance = 0.05;
  const double promised = sum / rules_.candidates;
  if (promised < enough) {
    const double chance = std::max(promised / enough, least_chance);
    if (random() >= chance) return false;
    scale /= chance;
  }
  for (std::size_t w = 0; w < weights_.size(); ++w) weights_[w] *= scale * taken_factor_[w];
  direction_ = direction;
  return true;
}

}  // namespace airlight::reference
