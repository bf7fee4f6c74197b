#include "scene/topocentric.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace airlight {

// Errors: UT1 is taken as UTC (they differ by less than 0.9 s: 0.004 degrees of the Earth's turn). Before 1960 there was no UTC: the
// time is taken as Universal Time, 32 s behind Terrestrial Time, which is wrong by up to 36 s, 0.0004 degrees of the
// Sun's way. The same holds for leap seconds yet to be decreed.
EphemerisTime ephemeris_time(const Time& time) {
  EphemerisTime at{};
  double tai1 = 0, tai2 = 0;
  eraUtctai(time.day, time.fraction, &tai1, &tai2);
  eraTaitt(tai1, tai2, &at.tt1, &at.tt2);
  eraUtcut1(time.day, time.fraction, 0.0, &at.ut1, &at.ut2);
  return at;
}

SunPosition topocentric(const Place& place, const EphemerisTime& time, const std::array<double, 3>& geocentric) {
  // To the true equator and equinox of date, then turned with the Earth.
  double of_date[3][3], celestial[3] = {geocentric[0], geocentric[1], geocentric[2]}, terrestrial[3];
  eraPnm06a(time.tt1, time.tt2, of_date);
  eraRz(eraGst06(time.ut1, time.ut2, time.tt1, time.tt2, of_date), of_date);
  eraRxp(of_date, celestial, terrestrial);

  // Parallax: from the observer instead of the Earth's centre, up to 8.8 seconds of arc for the Sun, a degree for the Moon.
  double observer[3], seen[3];
  eraGd2gc(ERFA_WGS84, place.longitude, place.latitude, 0.0, observer);
  for (int i = 0; i < 3; ++i) seen[i] = terrestrial[i] - observer[i] / ERFA_DAU;

  const double cp = std::cos(place.latitude), sp = std::sin(place.latitude);
  const double cl = std::cos(place.longitude), sl = std::sin(place.longitude);
  const auto along = [&](double x, double y, double z) { return x * seen[0] + y * seen[1] + z * seen[2]; };
  const double east = along(-sl, cl, 0), north = along(-sp * cl, -sp * sl, cp), up = along(cp * cl, cp * sl, sp);
  return {.azimuth = eraAnp(std::atan2(east, north)),
          .elevation = std::atan2(up, std::hypot(east, north)),
          .distance = eraPm(seen)};
}

}  // namespace airlight
