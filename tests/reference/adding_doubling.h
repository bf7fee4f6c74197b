// Short ways to ask the plane-parallel solver.
#pragma once
#include <cmath>
#include <vector>

#include "reference/adding_doubling.h"

namespace airlight::reference {

/// Unit vector of a zenith angle's cosine and an azimuth [rad] from north, clockwise.
inline Direction at(double mu, double azimuth = 0) {
  const double sine = std::sqrt((1 - mu) * (1 + mu));
  return {sine * std::sin(azimuth), sine * std::cos(azimuth), mu};
}

inline Layer layer(double optical_depth, double single_scattering_albedo, Phase phase) {
  return {{{optical_depth * single_scattering_albedo, std::move(phase)}},
          optical_depth * (1 - single_scattering_albedo)};
}

/// Radiances up from the ground, or down from space, at these cosines of the zenith or nadir angle.
inline std::vector<double> radiances(const AddingDoubling& solver, Level level, std::vector<double> cosines,
                                     double sun_cosine, double azimuth = 0) {
  std::vector<Direction> views;
  for (const double mu : cosines) views.push_back(at(level == Level::ground ? mu : -mu, azimuth));
  return solver.radiance(level, views, at(sun_cosine));
}

}  // namespace airlight::reference
