#include "reference/guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

/// A line's pieces as the estimate needs them.
struct Piece {
  double radius_squared, t, scattered;  // scattered: share of what comes along the line that was scattered here
};

double interpolate(double low, double high, double share) { return low + share * (high - low); }

}  // namespace

Guide::Guide(const Layers& layers, const Optics& optics, bool uniform)
    : planet_radius_(layers.planet_radius()),
      thickness_(layers.top_radius() - layers.planet_radius()),
      air_(altitudes * suns, Light{1, 1}),
      ground_(suns, Light{1, 1}) {
  if (!uniform && optics.constituents > 0) estimate(layers, optics);
}

// Grid: altitude = thickness a^2, sun's cosine = s |s|, a and s evenly spaced: fine near the ground and the terminator.
Guide::Light Guide::air(double radius_squared, double sun_cosine) const {
  const double radius = std::sqrt(radius_squared);
  const double a = (altitudes - 1) * std::sqrt(std::clamp((radius - planet_radius_) / thickness_, 0.0, 1.0));
  const double s = 0.5 * (suns - 1) * (1 + std::copysign(std::sqrt(std::min(std::abs(sun_cosine), 1.0)), sun_cosine));
  const int i = std::min(int(a), altitudes - 2), j = std::min(int(s), suns - 2);
  const Light* const low = &air_[std::size_t(i) * suns + j];
  const Light* const high = low + suns;
  const double u = s - j, v = a - i;
  return {interpolate(interpolate(low[0].all, low[1].all, u), interpolate(high[0].all, high[1].all, u), v),
          interpolate(interpolate(low[0].scattered, low[1].scattered, u),
                      interpolate(high[0].scattered, high[1].scattered, u), v)};
}

Guide::Light Guide::ground(double sun_cosine) const {
  const double s = 0.5 * (suns - 1) * (1 + std::copysign(std::sqrt(std::min(std::abs(sun_cosine), 1.0)), sun_cosine));
  const int j = std::min(int(s), suns - 2);
  return {interpolate(ground_[j].all, ground_[j + 1].all, s - j),
          interpolate(ground_[j].scattered, ground_[j + 1].scattered, s - j)};
}

void Guide::estimate(const Layers& layers, const Optics& optics) {
  const std::size_t count = optics.constituents, heroes = optics.heroes;
  const auto depth_of = [&](std::span<const double> coefficients, std::span<const double> along) {
    double sum = 0;
    for (std::size_t c = 0; c < count; ++c) sum += coefficients[c * heroes] * along[c];
    return sum;
  };
  const auto radius = [&](int i) {
    const double a = double(i) / (altitudes - 1);
    return planet_radius_ + thickness_ * a * a * (i == altitudes - 1 ? 1 - 1e-9 : 1);
  };
  const auto sun_cosine = [](int j) {
    const double s = 2.0 * j / (suns - 1) - 1;
    return s * std::abs(s);
  };
  // Direct sunlight: three heights of the disc.
  std::vector<double> direct(altitudes * suns), columns(count);
  for (int i = 0; i < altitudes; ++i)
    for (int j = 0; j < suns; ++j)
      for (const double offset : {-0.004, 0.0, 0.004}) {
        const double elevation = std::asin(sun_cosine(j)) + offset;
        std::fill(columns.begin(), columns.end(), 0.0);
        if (layers.add_columns_to_space({0, 0, radius(i)}, {std::cos(elevation), 0, std::sin(elevation)},
                                        planet_radius_, columns))
          direct[i * suns + j] += std::exp(-depth_of(optics.hero_extinction, columns)) / 3;
      }
  // Lines from each altitude; every sun and azimuth uses them.
  constexpr int zeniths = 6, azimuths = 4;
  struct Ray {
    int altitude;
    double cosine, weight, ground;  // weight: of zenith quadrature; ground: share of its light
    std::size_t begin, end;
    double ground_t;
  };
  std::vector<Ray> rays;
  std::vector<Piece> pieces;
  const GaussRule rule(zeniths);
  Line line;
  for (int i = 0; i < altitudes; ++i) {
    const double horizon =
        -std::sqrt(std::max((radius(i) - planet_radius_) * (radius(i) + planet_radius_), 0.0)) / radius(i);
    for (int half = 0; half < 2; ++half)
      for (int k = 0; k < zeniths; ++k) {
        const double low = half ? horizon : -1, high = half ? 1 : horizon;
        const double cosine = low + (high - low) * rule.nodes[k];
        Ray ray{i, cosine, 0.5 * (high - low) * rule.weights[k], 0, pieces.size(), 0, 0};
        if (ray.weight <= 0) continue;
        layers.trace({0, 0, radius(i)}, {std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine}, planet_radius_,
                     std::numeric_limits<double>::infinity(), line);
        double before = 1;
        // Pieces are joined until they matter.
        double scattered = 0, moment = 0;
        for (std::size_t n = 0; n + 1 < line.borders.size(); ++n) {
          std::vector<double> inside(count);
          for (std::size_t c = 0; c < count; ++c)
            inside[c] = line.columns[(n + 1) * count + c] - line.columns[n * count + c];
          const double depth = depth_of(optics.hero_extinction, inside);
          if (depth > 0) {
            const double here = -before * std::expm1(-depth) * depth_of(optics.hero_scattering, inside) / depth;
            scattered += here;
            moment += here * 0.5 * (line.borders[n] + line.borders[n + 1]);
            before *= std::exp(-depth);
          }
          if (scattered > 0 && (scattered > 0.02 || n + 2 == line.borders.size())) {
            const double t = moment / scattered;
            pieces.push_back({line.impact_squared + t * t, t - line.start, scattered});
            scattered = moment = 0;
          }
        }
        ray.end = pieces.size();
        if (line.meets_ground) {
          ray.ground = before;
          ray.ground_t = line.borders.back() - line.start;
        }
        rays.push_back(ray);
      }
  }
  for (int i = 0; i < altitudes * suns; ++i) air_[i] = {direct[i] / (4 * pi), 0};
  const double reflected = optics.hero_albedo[0] / pi;
  for (int j = 0; j < suns; ++j) ground_[j] = {reflected * std::max(sun_cosine(j), 0.0) * direct[j], 0};

  constexpr int orders = 5;
  for (int order = 0; order < orders; ++order) {
    std::vector<double> mean(altitudes * suns, 0.0), onto_ground(suns, 0.0);
    for (const Ray& ray : rays) {
      const double r = radius(ray.altitude), sine = std::sqrt((1 - ray.cosine) * (1 + ray.cosine));
      for (int j = 0; j < suns; ++j)
        for (int k = 0; k < azimuths; ++k) {
          const double cosine = sun_cosine(j), azimuth = pi * (k + 0.5) / azimuths;
          const double height = r * cosine,
                       slope = ray.cosine * cosine + sine * std::sqrt((1 - cosine) * (1 + cosine)) * std::cos(azimuth);
          double radiance = 0;
          for (std::size_t n = ray.begin; n < ray.end; ++n)
            radiance +=
                pieces[n].scattered *
                air(pieces[n].radius_squared, (height + pieces[n].t * slope) / std::sqrt(pieces[n].radius_squared)).all;
          if (ray.ground > 0) radiance += ray.ground * ground((height + ray.ground_t * slope) / planet_radius_).all;
          mean[ray.altitude * suns + j] += ray.weight / azimuths * radiance;
          if (ray.altitude == 0 && ray.cosine > 0)
            onto_ground[j] += 4 * pi * ray.weight / azimuths * ray.cosine * radiance;
        }
    }
    // Where even the last order brings nothing, a trace keeps walks comparable.
    constexpr double trace = 1e-15;
    for (int i = 0; i < altitudes * suns; ++i) air_[i] = {direct[i] / (4 * pi) + mean[i] + trace, mean[i] + trace};
    for (int j = 0; j < suns; ++j) {
      const double scattered = reflected * onto_ground[j];
      ground_[j] = {reflected * std::max(sun_cosine(j), 0.0) * direct[j] + scattered, scattered};
    }
  }
}

}  // namespace airlight::reference
