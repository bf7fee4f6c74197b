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

/// ISO 8601 time, "2026-06-21T18:40Z" or with seconds, fractions and an offset ("+02:00"), as Julian date in UTC, in two parts.
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
SunPosition sun_position(const Place& place, const Time& time);

/// Refraction of the standard atmosphere [rad] to be added to an elevation [rad] (0.57 degrees at the geometric horizon).
double refraction(double elevation);

}  // namespace airlight
