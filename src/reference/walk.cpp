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
      rough(atmosphere, 1e4),
      optics(atmosphere, wavelengths, settings.point_sun, settings.cloud.get()),
      guide(rough, optics, !settings.guided || settings.uniform_light),
      surface(settings.surface),
      cloud(settings.cloud),
      max_order(settings.max_order > 0 ? settings.max_order : std::numeric_limits<int>::max()),
      candidates(settings.guided && !settings.uniform_light ? 4 : 1),
      kept_orders(settings.kept_orders),
      uniform_light(settings.uniform_light) {
  if (cloud) validate(*cloud);
}

Walker::Walker(const WalkRules& rules)
    : rules_(rules),
      albedo_(rules.optics.wavelengths),
      weights_(rules.optics.wavelengths),
      importance_(rules.optics.heroes),
      hero_weights_(rules.optics.heroes),
      columns_(rules.optics.constituents),
      sunlight_(rules.optics.wavelengths),
      shares_(rules.optics.scatterers),
      factor_(rules.optics.wavelengths),
      hero_factor_(rules.optics.heroes),
      taken_factor_(rules.optics.wavelengths) {}

Flight Walker::first_flight(const WalkStart& start) const {
  Flight flight;
  aim(flight, rules_.layers, start, start.place, start.distance, start.first_order > 1, start.count_ground);
  flight.give_each_a_share(1.0 / 16);
  return flight;
}

void Walker::aim(Flight& flight, const Layers& layers, const WalkStart& start, const Place& from, double distance,
                 bool scattered_only, bool count_ground) const {
  flight.aim(layers, rules_.optics, rules_.guide, rules_.surface.get(), from, start.sun, start.ground_radius, distance,
             scattered_only, count_ground);
}

/// Mean radiance at a place in the air, as the guide thinks.
double Walker::light_at(const WalkStart& start, const Vector& position) const {
  const double radius_squared = dot(position, position);
  return rules_.guide.air(radius_squared, dot(position, start.sun) / std::sqrt(radius_squared)).all;
}

/// The light that a cloud on the line may send, as the guide thinks; as if nothing were seen through it.
double Walker::cloud_light(const WalkStart& start, const Flight& flight, const Place& from) const {
  if (!rules_.cloud) return 0;
  const auto [begin, end] = rules_.cloud->box.inside(from);
  if (!(begin < std::min(end, flight.reach()))) return 0;
  return light_at(start, along(from.position, begin, from.direction));
}

void Walker::set_out(const WalkStart& start, const Flight& first, double weight) {
  std::fill(weights_.begin(), weights_.end(), weight);
  const double from_cloud = cloud_light(start, first, start.place);
  for (std::size_t g = 0; g < importance_.size(); ++g) {
    const double promised = first.light()[g] + from_cloud;
    importance_[g] = promised > 0 ? 1 / (promised * weight * double(importance_.size())) : 0;
  }
}

void Walker::glance(const WalkStart& start, const Flight& first, int places, Random& random, std::span<double> light) {
  const double turn = random();
  for (int i = 0; i < places; ++i) {
    set_out(start, first, 1.0 / places);
    // Heroes change from place to place by the golden section, so that each has places of all kinds.
    const double hero = turn + i * std::numbers::phi;
    if (move(start, start.place, first, hero - std::floor(hero), (i + random()) / places, random))
      add_sunlight(start, 1, random, light);
  }
}

void Walker::walk(const WalkStart& start, const Flight& first, double where, double weight, Random& random,
                  std::span<double> light) {
  set_out(start, first, weight);
  if (rules_.uniform_light && std::isinf(start.distance)) add_light_of_space(start.place, first, 1, random, light);
  if (!move(start, start.place, first, random(), where, random)) return;
  for (int order = 1;; ++order) {
    if (order >= start.first_order && !rules_.uniform_light) add_sunlight(start, order, random, light);
    if (order == rules_.max_order || !turn(start, order, random)) return;
    if (rules_.uniform_light) add_light_of_space({position_, direction_}, flight_, order, random, light);
    if (!move(start, {position_, direction_}, flight_, random(), random(), random)) return;
  }
}

std::span<double> Walker::row(int order, std::span<double> light) const {
  return light.subspan(std::size_t(std::min(order, rules_.kept_orders) - 1) * weights_.size(), weights_.size());
}

/// Goes along a flight to the next place. @returns false where no light can come from there.
bool Walker::move(const WalkStart& start, const Place& from, const Flight& flight, double hero, double where,
                  Random& random) {
  rules_.optics.hero_values(weights_, hero_weights_);
  for (std::size_t g = 0; g < hero_weights_.size(); ++g) hero_weights_[g] *= importance_[g];
  if (rules_.cloud ? !draw_with_cloud(start, from, flight, hero, where, random)
                   : !flight.draw(rules_.layers, rules_.optics, hero_weights_, hero, where, event_))
    return false;
  for (std::size_t w = 0; w < weights_.size(); ++w)
    weights_[w] *= std::exp(-rules_.optics.optical_depth(event_.columns, w)) / event_.density;
  direction_ = from.direction;
  position_ = along(from.position, event_.t - flight.line().start, from.direction);
  if (!event_.ground) return true;
  if (flight.solid()) {
    position_ = flight.solid()->position;
    normal_ = flight.solid()->normal;
    rules_.surface->albedo(position_, albedo_);
  } else {
    const double scale = start.ground_radius / length(position_);
    for (double& x : position_) x *= scale;
    normal_ = unit(position_);
    albedo_ = rules_.optics.albedo;
  }
  return true;
}

/// The next place among air and cloud. With t where the cloud is met, at random, the light along the line is the mean of
/// what air scatters before t and of what the cloud scatters at t, seen through air. One of the two is chosen.
bool Walker::draw_with_cloud(const WalkStart& start, const Place& from, const Flight& flight, double hero, double where,
                             Random& random) {
  const Optics& optics = rules_.optics;
  const double met = draw_collision(*rules_.cloud, from, flight.reach(), random);
  const Flight* air = &flight;
  double chance = 1;  // of air
  if (std::isfinite(met)) {
    before_cloud_.aim(rules_.layers, optics, rules_.guide, nullptr, from, start.sun, start.ground_radius, met, false,
                      false);
    air = &before_cloud_;
    const auto columns = std::span(air->line().columns).last(optics.constituents);
    const double light = light_at(start, along(from.position, met, from.direction));
    double from_air = 0, from_cloud = 0;
    for (std::size_t g = 0; g < optics.heroes; ++g) {
      double depth = 0;
      for (std::size_t c = 0; c < optics.constituents; ++c)
        depth += optics.hero_extinction[c * optics.heroes + g] * columns[c];
      from_air += hero_weights_[g] * air->light()[g];
      from_cloud += hero_weights_[g] * std::exp(-depth) * light;
    }
    if (!(from_air + from_cloud > 0)) return false;
    chance = from_air / (from_air + from_cloud);
    if (random() >= chance) {
      event_ = {false, air->line().start + met, 1 - chance, {columns.begin(), columns.end()}, {}};
      event_.densities.assign(optics.scatterers, 0.0);
      event_.densities.back() = 1;
      return true;
    }
  }
  if (!air->draw(rules_.layers, optics, hero_weights_, hero, where, event_)) return false;
  event_.density *= chance;
  event_.densities.resize(optics.scatterers, 0.0);
  return true;
}

void Walker::add_sunlight(const WalkStart& start, int order, Random& random, std::span<double> light) {
  const Optics& optics = rules_.optics;
  const auto element = optics.sun_element(start.sun, random, sunlight_);
  const double incidence = event_.ground ? dot(normal_, element.direction) / element.projection : 1;
  if (incidence <= 0) return;
  const Place towards_sun{position_, element.direction};
  if (rules_.surface && rules_.surface->hides(towards_sun)) return;
  std::fill(columns_.begin(), columns_.end(), 0.0);
  if (!rules_.layers.add_columns_to_space(position_, element.direction, start.ground_radius, columns_)) return;

  if (rules_.cloud) {
    const double transmittance =
        draw_transmittance(*rules_.cloud, towards_sun, std::numeric_limits<double>::infinity(), random);
    for (double& share : sunlight_) share *= transmittance;
  }
  const std::span<double> result = row(order, light);
  if (!event_.ground) {
    // The scattering angle is taken to the disc's centre, as in single scattering by quadrature.
    const double angle = one_minus_cos(direction_, start.sun);
    for (std::size_t c = 0; c < shares_.size(); ++c) shares_[c] = event_.densities[c] * phase(optics.phases[c], angle);
  }
  for (std::size_t w = 0; w < result.size(); ++w) {
    double source = 0;
    if (event_.ground) {
      source = albedo_[w] / pi * incidence;
    } else {
      for (std::size_t c = 0; c < shares_.size(); ++c)
        source += optics.scattering[c * optics.wavelengths + w] * shares_[c];
    }
    result[w] += weights_[w] * source * sunlight_[w] * std::exp(-optics.optical_depth(columns_, w));
  }
}

void Walker::add_light_of_space(const Place& from, const Flight& flight, int order, Random& random,
                                std::span<double> light) {
  const Line& line = flight.line();
  if (line.meets_ground) return;
  const double through_cloud =
      rules_.cloud ? draw_transmittance(*rules_.cloud, from, std::numeric_limits<double>::infinity(), random) : 1;
  const auto whole = std::span(line.columns).last(columns_.size());
  const std::span<double> result = row(order, light);
  for (std::size_t w = 0; w < result.size(); ++w)
    result[w] += weights_[w] * through_cloud * std::exp(-rules_.optics.optical_depth(whole, w));
}

/// Draws a direction, and writes into factor_ what it does to the weights.
/// @param sky  where light comes from, as the guide thinks; none: it does not know
Vector Walker::draw_direction(const WalkStart& start, const std::optional<SkyAround>& sky, Random& random) {
  const Optics& optics = rules_.optics;
  const double by_sky = sky ? 0.25 : 0;
  if (event_.ground) {
    // Lambert's law, or where the sky is bright.
    const double square = random();  // of the cosine
    const Vector direction = random() < by_sky
                                 ? sky->draw(random)
                                 : around(normal_, std::sqrt(1 - square), std::sqrt(square), 2 * pi * random());
    const double lambert = std::max(dot(direction, normal_), 0.0) / pi;
    const double drawn = (1 - by_sky) * lambert + (sky ? by_sky * sky->density(direction) : 0);
    for (std::size_t w = 0; w < factor_.size(); ++w) factor_[w] = drawn > 0 ? albedo_[w] * lambert / drawn : 0;
    return direction;
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
  const bool sun_is_up = sky && dot(position_, start.sun) > -0.25 * length(position_);
  const double around_sun = sun_is_up ? 0.3 * (1 - by_sky) : 0;
  const double technique = random();
  Vector direction;
  if (technique < by_sky) {
    direction = sky->draw(random);
  } else {
    const double from_axis = optics.samplers[chosen].one_minus_cos(random());
    direction = around(technique < by_sky + around_sun ? start.sun : direction_, std::sqrt(from_axis * (2 - from_axis)),
                       1 - from_axis, 2 * pi * random());
  }
  const double angle = one_minus_cos(direction, direction_), from_sun = one_minus_cos(direction, start.sun);
  double drawn = sky ? by_sky * sky->density(direction) : 0;
  std::fill(factor_.begin(), factor_.end(), 0.0);
  for (std::size_t c = 0; c < shares_.size(); ++c) {
    if (shares_[c] > 0)
      drawn += shares_[c] / whole *
               ((1 - by_sky - around_sun) * optics.samplers[c].density(angle) +
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
bool Walker::turn(const WalkStart& start, int order, Random& random) {
  // A long walk through a cloud goes where droplets send it: weights that change a little at each place would drift
  // far apart.
  constexpr int last_guided = 6;
  const bool guided = !rules_.cloud || order <= last_guided;
  const int candidates = guided ? rules_.candidates : 1;
  const Optics& optics = rules_.optics;
  rules_.optics.hero_values(weights_, hero_weights_);
  for (std::size_t g = 0; g < hero_weights_.size(); ++g) hero_weights_[g] *= importance_[g];
  const std::optional<SkyAround> sky = guided ? rules_.guide.around(position_, start.sun) : std::nullopt;
  constexpr double endless = std::numeric_limits<double>::infinity();
  double sum = 0, taken = 0;
  Vector direction{};
  for (int i = 0; i < candidates; ++i) {
    const Vector towards = draw_direction(start, sky, random);
    aim(candidate_, rules_.rough, start, {position_, towards}, endless, false, true);
    const double from_cloud = cloud_light(start, candidate_, {position_, towards});
    optics.hero_values(factor_, hero_factor_);
    double promise = 0;
    for (std::size_t g = 0; g < optics.heroes; ++g)
      promise += hero_weights_[g] * hero_factor_[g] * (candidate_.light()[g] + from_cloud);
    sum += promise;
    if (i > 0 && !(random() * sum < promise)) continue;
    taken = promise;
    direction = towards;
    std::swap(taken_factor_, factor_);
  }
  if (!(taken > 0) && !rules_.uniform_light) return false;
  double scale = taken > 0 ? sum / (candidates * taken) : 1;
  constexpr double enough = 0.2, least_chance = 0.05;
  const double promised = sum / candidates;
  if (promised < enough) {
    const double chance = std::max(promised / enough, least_chance);
    if (random() >= chance) return false;
    scale /= chance;
  }
  for (std::size_t w = 0; w < weights_.size(); ++w) weights_[w] *= scale * taken_factor_[w];
  direction_ = direction;
  aim(flight_, rules_.layers, start, {position_, direction_}, endless, false, true);
  return true;
}

}  // namespace airlight::reference
