// The sun's disc as seen past a planet's horizon.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "airlight/atmosphere.h"

namespace airlight::reference {

/// The disc at a set of wavelengths. Its radiance is proportional to mu^a, mu = cos of the angle at the sun's surface.
///
/// Coordinates: x, y = components of an element's direction on the plane normal to the sun's centre, x towards the
/// zenith, in units of the disc's radius. There mu^a = (1 - x^2 - y^2)^(a/2), and dx dy is the element's solid angle
/// projected on the beam: weights add to the irradiance normal to the beam. All that matters to the light is the
/// element's elevation, so the integral over y is done in closed form, (1 - x^2)^((1+a)/2), and y^2 is replaced by its
/// mean (1 - x^2) / (3 + a), a at 550 nm, in the elevation, to which it contributes less than 1.1e-5 rad for our sun.
class SunDisc {
 public:
  /// @param point      take all light from the centre
  /// @param tolerance  of an average's quadrature, relative to the average or its floor
  /// @param fineness   parts to begin with between two breaks
  SunDisc(const Sun& sun, std::span<const double> wavelengths, bool point, double tolerance, int fineness);

  double radius() const { return radius_; }  ///< angular [rad]; 0 for a point sun

  /// Elements of equal x.
  struct Element {
    double sin_elevation, cos_elevation;
    double projection;  ///< cos of the angle to the disc's centre
  };
  /// Writes what arrives of an element's light, one value in [0, 1] for each wavelength.
  using Transmission = std::function<void(const Element&, std::span<double>)>;

  /// The mean of what arrives, weighted with the elements' light; elements below the horizon send none.
  /// @param elevation  of the sun's centre [rad]
  /// @param horizon    depression of the horizon [rad]
  /// @param kinks      further depressions [rad] where transmission depends on elevation with a kink
  /// @param floors     for each wavelength, an average below which precision is wasted
  std::vector<double> average(double elevation, double horizon, std::span<const double> kinks,
                              std::span<const double> floors, const Transmission& transmission) const;

 private:
  std::vector<double> average_whole(double elevation, std::span<const double> floors,
                                    const Transmission& transmission) const;
  Element element(double sun_elevation, double x) const;
  double height_of(double sun_elevation, double elevation) const;
  void weigh(double sin_theta, std::span<double> values) const;

  double radius_, tolerance_;
  int fineness_;
  std::vector<double> exponents_, norms_;
  double reference_exponent_;
};

}  // namespace airlight::reference
