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

constexpr int column_nodes = 10;
constexpr double disc_share = 0.1;  // the disc's tolerance over the ray's: else its noise would refine the ray

class Solver {
 public:
  Solver(const Atmosphere& atmosphere, const SingleScatteringSettings& settings, const Air& air, const Path& path,
         std::span<const double> wavelengths)
      : settings_(settings),
        air_(air),
        path_(path),
        disc_(atmosphere.sun, wavelengths, settings.point_sun, disc_share * settings.tolerance, settings.fineness),
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
  std::vector<double> illumination(const Illuminated& point, bool horizontal = false) const {
    std::vector<double> kinks;
    if (point.sun_elevation < disc_.radius())
      for (const double kink : air_.kinks())
        if (kink < point.radius) kinks.push_back(std::atan2(half_chord(point.radius, kink), kink));
    std::vector<double> columns(air_.constituents());
    return disc_.average(
        point.sun_elevation, point.horizon, kinks, [&](const SunDisc::Element& element, std::span<double> light) {
          std::fill(columns.begin(), columns.end(), 0.0);
          air_.add_columns(point.radius * element.cos_elevation, point.radius * element.sin_elevation,
                           std::numeric_limits<double>::infinity(), columns);
          // The disc's weights hold the projection on the beam; a horizontal plane has another one.
          const double plane = horizontal ? std::max(element.sin_elevation, 0.0) / element.projection : 1.0;
          for (std::size_t w = 0; w < light.size(); ++w) light[w] = plane * std::exp(-optical_depth(columns, w));
        });
  }

  double optical_depth(std::span<const double> columns, std::size_t wavelength) const {
    double sum = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) sum += extinction_[c * count_ + wavelength] * columns[c];
    return sum;
  }

  /// Columns of the whole path.
  std::vector<double> columns() const {
    std::vector<double> columns(air_.constituents(), 0.0);
    air_.add_columns(path_.impact, path_.begin, path_.end, columns);
    return columns;
  }

  /// Scattered light along the path for a sun of irradiance 1.
  std::vector<double> path_radiance() const {
    std::vector<double> columns(air_.constituents()), densities(air_.constituents());
    return integrate(path_.breaks(air_, disc_.radius()), count_, settings_.tolerance, settings_.fineness,
                     [&](double t, std::span<double> radiance) {
                       std::fill(columns.begin(), columns.end(), 0.0);
                       air_.add_columns(path_.impact, path_.begin, t, columns);
                       const Illuminated point = path_.at(t);
                       air_.densities(point.radius, densities);
                       const std::vector<double> light = illumination(point);
                       for (std::size_t w = 0; w < count_; ++w) {
                         double source = 0;
                         for (std::size_t c = 0; c < densities.size(); ++c)
                           source += source_[c * count_ + w] * densities[c];
                         radiance[w] = source * light[w] * std::exp(-optical_depth(columns, w));
                       }
                     });
  }

 private:
  const SingleScatteringSettings& settings_;
  const Air& air_;
  const Path& path_;
  SunDisc disc_;
  std::size_t count_;
  std::vector<double> extinction_, source_;  // constituent by wavelength [1/m], [1/(m sr)]
};

}  // namespace

SingleScattering::SingleScattering(const Atmosphere& atmosphere, SingleScatteringSettings settings)
    : atmosphere_(atmosphere), settings_(settings), air_(atmosphere, column_nodes * settings.fineness) {}

RayLight SingleScattering::along(const Ray& ray, std::span<const double> wavelengths) const {
  const Path path(ray, air_);
  const Solver solver(atmosphere_, settings_, air_, path, wavelengths);
  const std::vector<double> columns = solver.columns();
  RayLight light{std::vector<double>(wavelengths.size()), solver.path_radiance(),
                 std::vector<double>(wavelengths.size(), 0.0)};
  for (std::size_t w = 0; w < wavelengths.size(); ++w) {
    light.transmittance[w] = std::exp(-solver.optical_depth(columns, w));
    light.path_radiance[w] *= atmosphere_.sun.irradiance.at(wavelengths[w]);
  }
  if (path.meets_ground && std::isinf(ray.distance)) {
    const std::vector<double> arriving = solver.illumination(path.at(path.end), true);
    for (std::size_t w = 0; w < wavelengths.size(); ++w)
      light.ground_radiance[w] = atmosphere_.planet.albedo.at(wavelengths[w]) / std::numbers::pi * arriving[w] *
                                 atmosphere_.sun.irradiance.at(wavelengths[w]) * light.transmittance[w];
  }
  return light;
}

std::vector<double> SingleScattering::sun_irradiance(const Ray& ray, std::span<const double> wavelengths) const {
  const Path path(ray, air_);
  const Solver solver(atmosphere_, settings_, air_, path, wavelengths);
  std::vector<double> irradiance = solver.illumination(path.observer());
  for (std::size_t w = 0; w < wavelengths.size(); ++w) irradiance[w] *= atmosphere_.sun.irradiance.at(wavelengths[w]);
  return irradiance;
}

}  // namespace airlight::reference
