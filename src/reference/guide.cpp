#include "reference/guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "reference/phase.h"

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

std::optional<SkyAround> Guide::around(const Vector& position, const Vector& sun) const {
  if (chances_.empty()) return std::nullopt;
  const double r = length(position), cosine = dot(position, sun) / r;
  const double a = (altitudes - 1) * std::sqrt(std::clamp((r - planet_radius_) / thickness_, 0.0, 1.0));
  const double s = 0.5 * (suns - 1) * (1 + std::copysign(std::sqrt(std::min(std::abs(cosine), 1.0)), cosine));
  const int i = int(a + 0.5), j = int(s + 0.5);
  return SkyAround(position, sun, horizon(i), chances_[std::size_t(i) * suns + j]);
}

double Guide::radius(int altitude) const {
  const double a = double(altitude) / (altitudes - 1);
  return planet_radius_ + thickness_ * a * a * (altitude == altitudes - 1 ? 1 - 1e-9 : 1);
}

double Guide::horizon(int altitude) const {
  const double r = radius(altitude);
  return -std::sqrt(std::max((r - planet_radius_) * (r + planet_radius_), 0.0)) / r;
}

void Guide::estimate(const Layers& layers, const Optics& optics) {
  const std::size_t count = optics.constituents, heroes = optics.heroes;
  const auto depth_of = [&](std::span<const double> coefficients, std::span<const double> along) {
    double sum = 0;
    for (std::size_t c = 0; c < count; ++c) sum += coefficients[c * heroes] * along[c];
    return sum;
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
  constexpr int azimuths = SkyBins::azimuths;
  struct Ray {
    int altitude, zenith;
    double cosine, weight, ground;  // weight: of zenith quadrature; ground: share of its light
    std::size_t begin, end;
    double ground_t;
  };
  std::vector<Ray> rays;
  std::vector<Piece> pieces;
  std::vector<double> shares;  // of each piece's scattering, by constituent
  Line line;
  for (int i = 0; i < altitudes; ++i)
    for (int k = 0; k < SkyBins::zeniths; ++k) {
      const auto [cosine, weight] = SkyBins::node(k, horizon(i));
      Ray ray{i, k, cosine, weight, 0, pieces.size(), 0, 0};
      if (ray.weight <= 0) continue;
      layers.trace({0, 0, radius(i)}, {std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine}, planet_radius_,
                   std::numeric_limits<double>::infinity(), line);
      double before = 1;
      // Pieces are joined until they matter.
      double scattered = 0, moment = 0;
      std::vector<double> inside(count), by_constituent(count, 0.0);
      for (std::size_t n = 0; n + 1 < line.borders.size(); ++n) {
        for (std::size_t c = 0; c < count; ++c)
          inside[c] = line.columns[(n + 1) * count + c] - line.columns[n * count + c];
        const double depth = depth_of(optics.hero_extinction, inside);
        if (depth > 0) {
          const double here = -before * std::expm1(-depth) * depth_of(optics.hero_scattering, inside) / depth;
          scattered += here;
          for (std::size_t c = 0; c < count; ++c)
            by_constituent[c] += before * optics.hero_scattering[c * heroes] * inside[c];
          moment += here * 0.5 * (line.borders[n] + line.borders[n + 1]);
          before *= std::exp(-depth);
        }
        if (scattered > 0 && (scattered > 0.02 || n + 2 == line.borders.size())) {
          const double t = moment / scattered;
          pieces.push_back({line.impact_squared + t * t, t - line.start, scattered});
          double whole = 0;
          for (const double part : by_constituent) whole += part;
          for (double& part : by_constituent) shares.push_back(part / whole), part = 0;
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
  for (int i = 0; i < altitudes * suns; ++i) air_[i] = {direct[i] / (4 * pi), 0};
  const double reflected = optics.hero_albedo[0] / pi;
  for (int j = 0; j < suns; ++j) ground_[j] = {reflected * std::max(sun_cosine(j), 0.0) * direct[j], 0};

  constexpr int orders = 5;
  std::vector<double> phases(count);
  for (int order = 0; order < orders; ++order) {
    const bool last = order == orders - 1;
    if (last) chances_.resize(altitudes * suns);
    std::vector<double> mean(altitudes * suns, 0.0), onto_ground(suns, 0.0);
    for (const Ray& ray : rays) {
      const double r = radius(ray.altitude), sine = std::sqrt((1 - ray.cosine) * (1 + ray.cosine));
      for (int j = 0; j < suns; ++j)
        // Half the azimuths suffice for means; all are wanted to find directions.
        for (int k = last ? 0 : order % 2; k < azimuths; k += last ? 1 : 2) {
          const double cosine = sun_cosine(j), azimuth = SkyBins::azimuth(k);
          const double height = r * cosine,
                       slope = ray.cosine * cosine + sine * std::sqrt((1 - cosine) * (1 + cosine)) * std::cos(azimuth);
          for (std::size_t c = 0; c < count; ++c) phases[c] = 4 * pi * phase(optics.phases[c], 1 - slope);
          double radiance = 0;
          for (std::size_t n = ray.begin; n < ray.end; ++n) {
            const Light light =
                air(pieces[n].radius_squared, (height + pieces[n].t * slope) / std::sqrt(pieces[n].radius_squared));
            double towards_sun = 0;
            for (std::size_t c = 0; c < count; ++c) towards_sun += shares[n * count + c] * phases[c];
            radiance += pieces[n].scattered * (light.scattered + (light.all - light.scattered) * towards_sun);
          }
          if (ray.ground > 0) radiance += ray.ground * ground((height + ray.ground_t * slope) / planet_radius_).all;
          const double share = ray.weight * (last ? 1.0 : 2.0) / azimuths * radiance;
          mean[ray.altitude * suns + j] += share;
          if (ray.altitude == 0 && ray.cosine > 0) onto_ground[j] += 4 * pi * share * ray.cosine;
          if (last) chances_[ray.altitude * suns + j][ray.zenith * azimuths + k] = share;
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
  for (SkyChances& chances : chances_) {
    std::partial_sum(chances.begin(), chances.end(), chances.begin());
    const double whole = chances.back();
    for (double& chance : chances) chance = whole > 0 ? chance / whole : 1;
  }
}

}  // namespace airlight::reference
