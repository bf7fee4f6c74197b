// Converged spherical single scattering by quadrature: the truth that models are judged by. docs/references.md says
// what it solves, how it was checked, and what it leaves out.
#pragma once
#include <span>
#include <vector>

#include "airlight/sky.h"
#include "reference/air.h"

namespace airlight::reference {

struct SingleScatteringSettings {
  bool point_sun = false;   ///< all sunlight from the sun's centre, else from the disc
  double tolerance = 3e-7;  ///< a part of a ray, or of the disc, is halved until its 7- and 15-point sums differ by
                            ///< less than this share of the whole; the 15-point sums, which count, are better
  int fineness = 1;         ///< multiplies every fixed number of nodes and parts, for refinement studies
};

/// Answers for one ray; each vector has one value for each wavelength.
struct RayLight {
  std::vector<double> transmittance;  ///< [1] to the ray's end
  std::vector<double> path_radiance;  ///< [W m^-2 sr^-1 nm^-1] sunlight scattered once by the air into the ray
  std::vector<double>
      ground_radiance;  ///< [W m^-2 sr^-1 nm^-1] direct sunlight reflected by the ground, seen through the air
};

/// The ray's end is the nearest of `distance`, the ground, and the top of the air; ground_radiance is zero where
/// `distance` is finite. Relative error of each value: below 1e-6.
///
/// Conventions. The ground is a Lambertian sphere at altitude 0; for an observer below 0 it lies 1 m under the eye, and
/// the air of altitude 0 continues. Above the top is vacuum. Light travels straight; the planet blocks the sun. The
/// scattering angle is taken to the sun's centre, the illumination (transmittance, visibility, limb darkening) over its
/// disc.
class SingleScattering {
 public:
  explicit SingleScattering(const Atmosphere& atmosphere, SingleScatteringSettings settings = {});

  /// @param wavelengths  [nm]
  /// @throws InputError  where a number of the ray is not finite (an infinite distance is), a direction is zero, the
  /// distance
  ///                     negative, or the observer within 1 m of the planet's centre
  RayLight along(const Ray& ray, std::span<const double> wavelengths) const;

  /// The transmittance alone [1], which costs next to nothing. @throws as along()
  std::vector<double> transmittance(const Ray& ray, std::span<const double> wavelengths) const;

  /// Direct sunlight at the ray's observer on a plane normal to the beam [W m^-2 nm^-1].
  std::vector<double> sun_irradiance(const Ray& ray, std::span<const double> wavelengths) const;

 private:
  Atmosphere atmosphere_;
  SingleScatteringSettings settings_;
  Air air_;
};

}  // namespace airlight::reference
