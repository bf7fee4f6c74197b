// The sky with all orders of scattering, by random walks: the truth that models are judged by. docs/references.md says
// what it solves, how it was checked, and what it leaves out.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "airlight/sky.h"
#include "reference/cloud.h"
#include "reference/surface.h"

namespace airlight::reference {

struct WalkRules;
struct WalkStart;

struct MonteCarloSettings {
  std::uint64_t seed = 1;
  int max_order = 0;                ///< of scatterings and reflections together; 0: all
  int kept_orders = 8;              ///< the last row of RandomLight::orders holds all higher ones
  int batch_walks = 32;             ///< strata of the first place; standard errors are those of batches
  bool point_sun = false;           ///< all sunlight from the sun's centre, else from the disc
  bool random_first_order = false;  ///< else the first order is found by quadrature, which is slower and exact
  int first_order_places = 0;  ///< above 0: a batch finds the first order at so many places along the line, apart from
                               ///< its walks; nearly free of chance and far cheaper than quadrature: for pictures
  bool guided = true;          ///< walks prefer to go where a rough estimate sees light; false: they ignore it
  bool uniform_light = false;  ///< radiance 1 comes from everywhere in space, in place of the sun
  // With either of these the first order is random, too.
  std::shared_ptr<const Surface> surface = {};  ///< land above the planet's sphere; none: the sphere alone
  std::shared_ptr<const Cloud> cloud = {};      ///< beside the atmosphere's constituents
};

/// When to stop: at the first that is reached; 0: no limit. At least one shall be given.
struct Budget {
  long walks = 0;                      ///< rounded up to whole batches
  double target_error = 0;             ///< standard error over mean, at the worst wavelength
  double seconds = 0;                  ///< of wall clock
  std::function<void()> between = {};  ///< called every second or so; what it throws ends the work
};

/// One value for each wavelength.
struct Estimate {
  std::vector<double> mean, standard_error;
};
struct RandomLight {
  Estimate total;
  std::vector<Estimate> orders;  ///< 1, 2, ... as many as kept; the last holds all higher ones
  long walks = 0;
};

/// Spectral radiance in a spherical planet's air: any constituents, Lambertian ground, sun disc with limb darkening, all
/// orders; scalar, without refraction. Conventions are those of SingleScattering.
///
/// The same numbers for a seed at any number of threads. Each ray has random numbers of its own.
class MonteCarlo {
 public:
  /// @param wavelengths  [nm] all answers are for these; walks are shared by them
  MonteCarlo(const Atmosphere& atmosphere, std::span<const double> wavelengths, MonteCarloSettings settings = {});
  ~MonteCarlo();

  /// Light that arrives along the ray [W m^-2 sr^-1 nm^-1], direct sunlight excluded; the ground's where the distance is
  /// infinite. @throws InputError naming what is wrong with the ray or the budget.
  RandomLight radiance(const Ray& ray, const Budget& budget) const;
  /// The air's part of it.
  RandomLight path_radiance(const Ray& ray, const Budget& budget) const;
  /// Skylight on a horizontal plane facing up at the ray's observer [W m^-2 nm^-1].
  RandomLight sky_irradiance(const Ray& ray, const Budget& budget) const;

 private:
  RandomLight along(const Ray& ray, const Budget& budget, bool with_ground) const;
  WalkStart start(const Ray& ray) const;

  Atmosphere atmosphere_;
  std::vector<double> wavelengths_, sunlight_;
  MonteCarloSettings settings_;
  int first_order_;  // that walks look for
  std::unique_ptr<const WalkRules> rules_;
};

}  // namespace airlight::reference
