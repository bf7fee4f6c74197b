#include "reference/single_scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/adaptive.h"
#include "reference/path.h"
#include "reference/phase.h"
#include "reference/sun_disc.h"

namespace airlight::reference {
namespace {

class Solver {
 public:
  Solver(const Atmosphere& atmosphere, const SingleScatteringSettings& settings, const Air& air, const Path& path,
         std::span<const double> wavelengths)
      : settings_(settings),
        air_(air),
        path_(path),
        disc_(atmosphere.sun, wavelengths, settings.point_sun, settings.tolerance, settings.fineness),
        centre_(atmosphere.sun, wavelengths, true, 1, 1),
        count_(wavelengths.size()) {
    for (const Constituent& constituent : atmosphere.constituents) {
      const double p = phase(constituent.phase, path.one_minus_cos);
      for (const double wavelength : wavelengths) {
        const double scattering = constituent.scattering.at(wavelength);
        extinction_.push_back(scattering + constituent.absorption.at(wavelength));
        source_.push_back(scattering * p);
      }
    }
  }

  /// Share of the sun's irradiance that arrives at a point: normal to the beam, or on a horizontal plane.
  /// @param floors  for each wavelength, a share below which precision is wasted
  std::vector<double> illumination(const SunDisc& disc, const Illuminated& point, std::span<const double> floors,
                                   bool horizontal = false) const {
    std::vector<double> jumps;
    if (point.sun_elevation < disc.radius())
      for (const double jump : air_.jumps())
        if (jump < point.radius) jumps.push_back(std::atan2(half_chord(point.radius, jump), jump));
    std::vector<double> columns(air_.constituents());
    const auto transmission = [&](const SunDisc::Element& element, std::span<double> light) {
      std::fill(columns.begin(), columns.end(), 0.0);
      air_.add_columns(point.radius * element.cos_elevation, point.radius * element.sin_elevation,
                       std::numeric_limits<double>::infinity(), columns);
      // The disc's weights hold the projection on the beam; a horizontal plane has another one.
      const double plane = horizontal ? std::max(element.sin_elevation, 0.0) / element.projection : 1.0;
      for (std::size_t w = 0; w < light.size(); ++w) light[w] = plane * std::exp(-optical_depth(columns, w));
    };
    return disc.average(point.sun_elevation, point.horizon, jumps, floors, transmission);
  }
  std::vector<double> illumination(const Illuminated& point, bool horizontal = false) const {
    return illumination(disc_, point, std::vector<double>(count_, 0.0), horizontal);
  }

  double optical_depth(std::span<const double> columns, std::size_t wavelength) const {
    double sum = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) sum += extinction_[c * count_ + wavelength] * columns[c];
    return sum;
  }

  /// Of the whole path.
  std::vector<double> transmittance() const {
    std::vector<double> columns(air_.constituents(), 0.0), transmittance(count_);
    air_.add_columns(path_.impact, path_.begin, path_.end, columns);
    for (std::size_t w = 0; w < count_; ++w) transmittance[w] = std::exp(-optical_depth(columns, w));
    return transmittance;
  }

  /// Scattered light along the path for a sun of irradiance 1.
  std::vector<double> path_radiance() const {
    // A point sun's light, roughly and cheaply, tells what matters: most of the work would else go into the disc's last
    // glow in places that add nothing to the ray.
    std::vector<double> mean = path_radiance(centre_, 0.1, std::vector<double>(count_, 0.0));
    for (double& radiance : mean) radiance /= std::max(path_.end - path_.begin, 1e-3);
    return path_radiance(disc_, settings_.tolerance, mean);
  }

 private:
  /// @param mean  expected result over the path's length; a source of less needs less precision
  std::vector<double> path_radiance(const SunDisc& disc, double tolerance, std::span<const double> mean) const {
    std::vector<double> columns(air_.constituents()), densities(air_.constituents()), floors(count_);
    const auto source = [&](double t, std::span<double> radiance) {
      std::fill(columns.begin(), columns.end(), 0.0);
      air_.add_columns(path_.impact, path_.begin, t, columns);
      const Illuminated point = path_.at(t);
      air_.densities(point.radius, densities);
      for (std::size_t w = 0; w < count_; ++w) {
        radiance[w] = 0;
        for (std::size_t c = 0; c < densities.size(); ++c) radiance[w] += source_[c * count_ + w] * densities[c];
        radiance[w] *= std::exp(-optical_depth(columns, w));
        floors[w] = radiance[w] > mean[w] ? mean[w] / radiance[w] : 1;
      }
      const std::vector<double> light = illumination(disc, point, floors);
      for (std::size_t w = 0; w < count_; ++w) radiance[w] *= light[w];
    };
    return integrate(path_.breaks(air_, disc.radius()), std::vector<double>(count_, 0.0), tolerance, settings_.fineness,
                     source);
  }

  const SingleScatteringSettings& settings_;
  const Air& air_;
  const Path& path_;
  SunDisc disc_, centre_;
  std::size_t count_;
  std::vector<double> extinction_, source_;  // constituent by wavelength [1/m], [1/(m sr)]
};

}  // namespace

SingleScattering::SingleScattering(const Atmosphere& atmosphere, SingleScatteringSettings settings)
    : atmosphere_(atmosphere), settings_(settings), air_(atmosphere, settings.fineness) {}

RayLight SingleScattering::along(const Ray& ray, std::span<const double> wavelengths) const {
  const Path path(ray, air_);
  const Solver solver(atmosphere_, settings_, air_, path, wavelengths);
  RayLight light{solver.transmittance(), solver.path_radiance(), std::vector<double>(wavelengths.size(), 0.0)};
  for (std::size_t w = 0; w < wavelengths.size(); ++w)
    light.path_radiance[w] *= atmosphere_.sun.irradiance.at(wavelengths[w]);
  if (path.meets_ground && std::isinf(ray.distance)) {
    const std::vector<double> arriving = solver.illumination(path.at(path.end), true);
    for (std::size_t w = 0; w < wavelengths.size(); ++w)
      light.ground_radiance[w] = atmosphere_.planet.albedo.at(wavelengths[w]) / std::numbers::pi * arriving[w] *
                                 atmosphere_.sun.irradiance.at(wavelengths[w]) * light.transmittance[w];
  }
  return light;
}

std::vector<double> SingleScattering::transmittance(const Ray& ray, std::span<const double> wavelengths) const {
  const Path path(ray, air_);
  return Solver(atmosphere_, settings_, air_, path, wavelengths).transmittance();
}

std::vector<double> SingleScattering::sun_irradiance(const Ray& ray, std::span<const double> wavelengths) const {
  const Path path(ray, air_);
  const Solver solver(atmosphere_, settings_, air_, path, wavelengths);
  std::vector<double> irradiance = solver.illumination(path.observer());
  for (std::size_t w = 0; w < wavelengths.size(); ++w) irradiance[w] *= atmosphere_.sun.irradiance.at(wavelengths[w]);
  return irradiance;
}

}  // namespace airlight::reference
