// Where the sun stands, seen from a place on Earth at a time.
#pragma once
#include <string>

#include "airlight/camera.h"

namespace airlight {

struct Place {
  double latitude = 0, longitude = 0;  ///< [rad], north and east positive, geodetic (WGS 84)
};
/// "46.6,7.9": latitude and longitude in degrees. @throws InputError naming value and range.
Place parse_place(const std::string& text);

/// ISO 8601 time, "2026-06-21T18:40Z" or with seconds, fractions and an offset ("+02:00"), as Julian date in UTC, in two
/// parts. Years 1900 to 2100, for which the solar ephemeris holds; leap seconds are known; before 1960 it is Universal Time.
struct Time {
  double day = 0, fraction = 0;
};
/// @throws InputError with the form expected.
Time parse_time(const std::string& text);
std::string format_time(const Time& time);

struct SunPosition {
  double azimuth = 0;    ///< from north, clockwise [rad]
  double elevation = 0;  ///< apparent geometric: light time, aberration and parallax, no refraction [rad]
  double distance = 1;   ///< [astronomical units]; irradiance goes with its inverse square
};
/// Within 0.005 degrees (most of it the Earth's uneven turning: UT1 is taken as UTC).
SunPosition sun_position(const Place& place, const Time& time);

/// Refraction [rad] to be added to a geometric elevation [rad], at sea level: a sun seen on the horizon is lifted by 0.57
/// degrees (and one whose geometric elevation is 0 by 0.48). Never swaps two heights; 0 below -5 degrees.
double refraction(double elevation);

}  // namespace airlight
