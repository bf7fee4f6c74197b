#include "scene/moon.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

#include "scene/topocentric.h"

namespace airlight {
namespace {

constexpr double radius = 1'737'400;  // [m], mean

/// 0.12 at V (550 nm), and 0.27 magnitudes less at B (440 nm): a straight line through both.
Spectrum geometric_albedo() {
  constexpr double visual = 0.12;
  const double blue = visual * std::pow(10, -0.4 * (0.92 - 0.65)), slope = (visual - blue) / (550 - 440);
  TableSpectrum line{{300, 1000}, {}, Sampling::point, ""};
  for (const double wavelength : line.wavelengths) line.values.push_back(visual + slope * (wavelength - 550));
  return Spectrum(line);
}

}  // namespace

Moon moon_at(const Place& place, const Time& time) {
  const EphemerisTime at = ephemeris_time(time);
  double moon[2][3], earth_of_sun[2][3], earth[2][3];
  eraMoon98(at.tt1, at.tt2, moon);
  eraEpv00(at.tt1, at.tt2, earth_of_sun, earth);
  // The Moon moves with the Earth, and so needs no aberration but that of its own 1.3 light seconds.
  const SunPosition seen = topocentric(place, at, {moon[0][0], moon[0][1], moon[0][2]});
  double to_sun[3], to_earth[3];
  for (int i = 0; i < 3; ++i) {
    to_earth[i] = -moon[0][i];
    to_sun[i] = -earth_of_sun[0][i] - moon[0][i];
  }
  return {.azimuth = seen.azimuth,
          .elevation = seen.elevation,
          .distance = seen.distance * ERFA_DAU,
          .sun_distance = eraPm(to_sun),
          .phase = eraSepp(to_sun, to_earth)};
}

Sun moonlight(const Sun& sun, const Moon& moon) {
  const double degrees = moon.phase * ERFA_DR2D, of_distance = radius / moon.distance;
  const double magnitudes = 0.026 * degrees + 4e-9 * std::pow(degrees, 4);
  const double part =
      of_distance * of_distance / (moon.sun_distance * moon.sun_distance) * std::pow(10, -0.4 * magnitudes);
  Sun light;
  light.irradiance = Spectrum(ProductSpectrum{{sun.irradiance.scaled(part), geometric_albedo()}, {}});
  light.angular_radius = std::asin(of_distance);
  return light;
}

}  // namespace airlight
