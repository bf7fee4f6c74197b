// All orders of scattering in plane-parallel air, by adding and doubling. docs/references.md has the equations.
#pragma once
#include <span>
#include <vector>

#include "airlight/camera.h"
#include "reference/adding_doubling_slab.h"
#include "reference/plane_parallel.h"

namespace airlight::reference {

struct AddingDoublingSettings {
  int streams = 0;          ///< Gauss nodes in each hemisphere; 0: as many as the phase functions ask for, 32 to 64
  double thinnest = 1e-8;   ///< optical depth that doubling begins with, at most; errors go with its square
  double tolerance = 1e-9;  ///< the Fourier series ends where two terms in a row are below this share of the first
};

/// Where the observer stands: on the ground, or above all air.
enum class Level { ground, space };

/// Irradiances on horizontal planes, for a sun of irradiance 1 normal to its beam.
struct PlaneParallelFluxes {
  double direct;   ///< sunlight that reaches the ground unscattered
  double diffuse;  ///< skylight that reaches the ground
  double upward;   ///< light that leaves the top
};

/// Scalar, unpolarised, no refraction; the sun is a point. What phase functions hold beyond 2 * streams moments is taken
/// as unscattered (delta-M, Wiscombe 1977), and single scattering is exact (TMS, Nakajima & Tanaka 1988).
class AddingDoubling {
 public:
  /// @throws InputError naming key, value and legal range
  explicit AddingDoubling(PlaneParallelAir air, AddingDoublingSettings settings = {});

  /// Radiance for a sun of irradiance 1 normal to its beam [1/sr], the sun's disc excluded, the ground included. The views
  /// share one solution.
  /// @param views  unit vectors, observer -> scene, z up
  /// @param sun    unit vector towards the sun, above the horizon. @throws InputError
  std::vector<double> radiance(Level level, std::span<const Direction> views, const Direction& sun) const;

  /// @param sun_cosine  of the zenith angle, in (0, 1]. @throws InputError
  PlaneParallelFluxes fluxes(double sun_cosine) const;

  int streams() const { return settings_.streams; }
  /// Largest share of a layer's scattered light that is taken as unscattered. What remains of it in the sky's light
  /// scattered more than once is an error of about this size; above 1e-6 nothing but more streams would mend it.
  double truncated() const;

 private:
  /// A layer after delta-M.
  struct Optics {
    double optical_depth, single_scattering_albedo;
    std::vector<double> moments;
    double truncated;
  };
  struct Solution;

  Streams streams_for(std::span<const double> views, double sun_cosine) const;
  Slab whole_air(int term, const Streams& streams) const;
  Solution solve(int term, const Streams& streams) const;
  template <typename Phases>
  double scattered_once(Level level, double mu, double sun_cosine, const Phases& phases) const;
  double exact_phase(std::size_t layer, double one_minus_cos) const;

  PlaneParallelAir air_;
  AddingDoublingSettings settings_;
  std::vector<Optics> layers_;
};

}  // namespace airlight::reference
