// From the Earth's centre to a place on it: where something near the Earth stands in that place's sky.
#pragma once
#include <array>

#include "scene/sun_position.h"

namespace airlight {

/// A time on the clocks that ephemerides go by, as Julian dates in two parts.
struct EphemerisTime {
  double tt1, tt2;  ///< Terrestrial Time
  double ut1, ut2;  ///< Universal Time, by which the Earth turns: taken as UTC
};
EphemerisTime ephemeris_time(const Time& time);

/// @param geocentric  apparent place from the Earth's centre, in the celestial frame (GCRS) [au]
/// @returns           azimuth, elevation without refraction, distance from the observer [au]
SunPosition topocentric(const Place& place, const EphemerisTime& time, const std::array<double, 3>& geocentric);

}  // namespace airlight
