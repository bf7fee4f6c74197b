// Hoffman & Preetham's virtual dome: a ray of the sky as a path through air of ground density that holds as much.
#pragma once

namespace airlight {

/// Exponential air around a sphere.
struct DomeAir {
  double height = 8000;     ///< [m] scale height
  double radius = 6.360e6;  ///< [m] of the planet
  double top = 100e3;       ///< [m] of the air
};

/// Length [m] through air of ground density that holds as much as a ray from the ground to the top, by integration.
/// @param zenith  [rad]
double dome_path(const DomeAir& air, double zenith);

/// The smooth surface height / (cos(zenith) + a (b - zenith in degrees)^-c).
struct DomeFit {
  double height;  ///< [m]
  double a, b, c;

  double at(double zenith) const;  ///< [m]; zenith [rad], at most pi / 2
};
/// The published numbers for Earth's molecules and aerosols (8 km and 1.2 km), error at most 0.14 and 0.31 %; for other air the surface whose
/// largest error over 0 .. 90 degrees is least.
DomeFit fit_dome(const DomeAir& air);

}  // namespace airlight
