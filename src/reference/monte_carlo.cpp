#include "reference/monte_carlo.h"

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/batches.h"
#include "reference/path.h"
#include "reference/single_scattering.h"
#include "reference/walk.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

/// Every ray has a stream of its own: errors of different rays are independent.
std::uint64_t stream_of(const Ray& ray, std::uint64_t question) {
  std::uint64_t hash = question;
  for (const double value :
       {ray.altitude, ray.distance, ray.view[0], ray.view[1], ray.view[2], ray.sun[0], ray.sun[1], ray.sun[2]})
    hash = scramble(hash ^ std::bit_cast<std::uint64_t>(value));
  return hash;
}

void scale(Estimate& estimate, std::span<const double> factors) {
  for (std::size_t w = 0; w < factors.size(); ++w) {
    estimate.mean[w] *= factors[w];
    estimate.standard_error[w] *= factors[w];
  }
}

}  // namespace

MonteCarlo::MonteCarlo(const Atmosphere& atmosphere, std::span<const double> wavelengths, MonteCarloSettings settings)
    : atmosphere_(atmosphere),
      wavelengths_(wavelengths.begin(), wavelengths.end()),
      settings_(settings),
      first_order_(settings.first_order_places > 0                                                               ? 2
                   : settings.random_first_order || settings.uniform_light || settings.surface || settings.cloud ? 1
                                                                                                                 : 2),
      rules_(std::make_unique<const WalkRules>(atmosphere, wavelengths, settings)) {
  for (const double wavelength : wavelengths)
    sunlight_.push_back(settings.uniform_light ? 1 : atmosphere.sun.irradiance.at(wavelength));
}

MonteCarlo::~MonteCarlo() = default;

WalkStart MonteCarlo::start(const Ray& ray) const {
  const double radius = rules_->layers.planet_radius();
  check(ray, radius);
  return {{{0, 0, radius + ray.altitude}, unit(ray.view)},
          unit(ray.sun),
          radius + (ray.altitude < 0 ? ray.altitude - 1 : 0),
          ray.distance,
          std::isinf(ray.distance),
          first_order_};
}

RandomLight MonteCarlo::radiance(const Ray& ray, const Budget& budget) const { return along(ray, budget, true); }

RandomLight MonteCarlo::path_radiance(const Ray& ray, const Budget& budget) const { return along(ray, budget, false); }

RandomLight MonteCarlo::along(const Ray& ray, const Budget& budget, bool with_ground) const {
  WalkStart begin = start(ray);
  begin.count_ground = begin.count_ground && with_ground;
  const std::size_t width = wavelengths_.size(), row = settings_.kept_orders * width;

  // The first order, where it is not left to chance; for a sun of irradiance 1 like the walks.
  std::vector<double> first_order(width, 0.0);
  if (begin.first_order > 1 && settings_.first_order_places == 0) {
    // Far below what walks resolve.
    const SingleScattering single(atmosphere_, {.point_sun = settings_.point_sun, .tolerance = 1e-5});
    const RayLight light = single.along(ray, wavelengths_);
    for (std::size_t w = 0; w < width; ++w)
      if (sunlight_[w] > 0)
        first_order[w] = (light.path_radiance[w] + (with_ground ? light.ground_radiance[w] : 0)) / sunlight_[w];
  }
  const Flight first = Walker(*rules_).first_flight(begin);
  WalkStart glance = begin;
  glance.first_order = 1;
  const Flight glancing = settings_.first_order_places > 0 ? Walker(*rules_).first_flight(glance) : Flight();
  const std::uint64_t stream = stream_of(ray, with_ground ? 1 : 2);
  RandomLight light =
      run_batches(budget, settings_.batch_walks, settings_.kept_orders, first_order,
                  [&](long from, long to, std::span<double> rows) {
                    Walker walker(*rules_);
                    for (long batch = from; batch < to; ++batch) {
                      Random random(settings_.seed, scramble(stream + std::uint64_t(batch)));
                      walker.glance(glance, glancing, settings_.first_order_places, random,
                                    rows.subspan((batch - from) * row, row));
                      for (int i = 0; i < settings_.batch_walks; ++i)
                        walker.walk(begin, first, (i + random()) / settings_.batch_walks, 1.0 / settings_.batch_walks,
                                    random, rows.subspan((batch - from) * row, row));
                    }
                  });
  for (std::size_t w = 0; w < width; ++w) {
    light.orders[0].mean[w] += first_order[w];
    light.total.mean[w] += first_order[w];
  }
  for (Estimate& order : light.orders) scale(order, sunlight_);
  scale(light.total, sunlight_);
  return light;
}

RandomLight MonteCarlo::sky_irradiance(const Ray& ray, const Budget& budget) const {
  WalkStart begin = start(ray);
  begin.distance = std::numeric_limits<double>::infinity();
  begin.count_ground = true;
  begin.first_order = 1;
  const std::size_t row = settings_.kept_orders * wavelengths_.size();
  const std::vector<double> nothing(wavelengths_.size(), 0.0);
  const std::uint64_t stream = stream_of(ray, 3);
  RandomLight light = run_batches(
      budget, settings_.batch_walks, settings_.kept_orders, nothing, [&](long from, long to, std::span<double> rows) {
        Walker walker(*rules_);
        for (long batch = from; batch < to; ++batch) {
          Random random(settings_.seed, scramble(stream + std::uint64_t(batch)));
          for (int i = 0; i < settings_.batch_walks; ++i) {
            // Directions by Lambert's law, so that radiance * pi is irradiance; azimuths of a batch are spread.
            const double square = random(), azimuth = 2 * pi * (i + random()) / settings_.batch_walks;
            WalkStart walk = begin;
            walk.place.direction = around({0, 0, 1}, std::sqrt(1 - square), std::sqrt(square), azimuth);
            walker.walk(walk, walker.first_flight(walk), random(), pi / settings_.batch_walks, random,
                        rows.subspan((batch - from) * row, row));
          }
        }
      });
  for (Estimate& order : light.orders) scale(order, sunlight_);
  scale(light.total, sunlight_);
  return light;
}

}  // namespace airlight::reference
