// What random walks know of an atmosphere at a set of wavelengths.
#pragma once
#include <span>
#include <vector>

#include "airlight/atmosphere.h"
#include "reference/cloud.h"
#include "reference/phase_sampler.h"
#include "reference/random.h"
#include "reference/vector.h"

namespace airlight::reference {

/// Rows are constituents, columns wavelengths. Sunlight's irradiance is 1 here: answers are scaled at the end.
struct Optics {
  /// @param cloud  none: air alone
  Optics(const Atmosphere& atmosphere, std::span<const double> wavelengths, bool point_sun,
         const Cloud* cloud = nullptr);

  std::size_t constituents, wavelengths;
  /// Those, and after them the cloud: what a collision with it scatters, of a density of 1. Only tables of scattering
  /// have its row.
  std::size_t scatterers;
  std::vector<double> extinction, scattering;  ///< [1/m] where the relative density is 1
  std::vector<double> albedo;                  ///< of the ground
  std::vector<Phase> phases;
  std::vector<PhaseSampler> samplers;

  /// Walks are drawn for a mixture of three kinds of light, so that none finds itself among walks that hardly know it:
  /// the wavelengths of least and largest vertical optical depth, and the mean of all, which scatters wherever one does.
  static constexpr std::size_t most_heroes = 3;
  std::size_t heroes;
  std::vector<double> hero_extinction, hero_scattering, hero_albedo;
  void hero_values(std::span<const double> by_wavelength, std::span<double> by_hero) const;

  double optical_depth(std::span<const double> columns, std::size_t at_wavelength) const {
    double sum = 0;
    for (std::size_t c = 0; c < constituents; ++c) sum += extinction[c * wavelengths + at_wavelength] * columns[c];
    return sum;
  }

  /// A random element of the sun's disc.
  struct SunElement {
    Vector direction;
    double projection;  ///< cos of the angle to the disc's centre
  };
  /// @param light  for each wavelength, the element's share of the irradiance over the density it was drawn with
  SunElement sun_element(const Vector& sun, Random& random, std::span<double> light) const;

 private:
  std::size_t clearest_, thickest_;
  double sun_radius_, drawn_exponent_;
  std::vector<double> limb_darkening_;
};

}  // namespace airlight::reference
