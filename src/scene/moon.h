// Where the Moon stands, and how much of the Sun's light it sends.
#pragma once
#include "airlight/atmosphere.h"
#include "scene/sun_position.h"

namespace airlight {

struct Moon {
  double azimuth = 0;             ///< from north, clockwise [rad]
  double elevation = 0;           ///< of its centre, parallax included, no refraction [rad]
  double distance = 384'400'000;  ///< from the observer [m]
  double sun_distance = 1;        ///< of the Moon [astronomical units]
  double phase = 0;               ///< angle at the Moon between Sun and Earth [rad]: 0 full, pi new
};

/// Seen from a place on Earth. Within 0.01 degrees (Meeus' series in ERFA: 0.003; light time: 0.0002; the Earth's turn: 0.004).
Moon moon_at(const Place& place, const Time& time);

/// The Moon as a light: an even disc of the irradiance that a moon of this distance and phase gives.
///
/// Its reflected irradiance is solar irradiance x geometric albedo x (radius / distance)^2 x phase law. Geometric albedo 0.12 in the
/// visual (NASA's Moon fact sheet); the Moon is redder than the Sun, B - V = 0.92 against 0.65 (Allen, Astrophysical Quantities),
/// which here is an albedo that grows linearly with wavelength. Phase law: 0.026 a + 4e-9 a^4 magnitudes at a degrees, Krisciunas &
/// Schaefer 1991 (doi:10.1086/132921), equation 9. The surge of brightness within 7 degrees of full, a third, is left out, as are
/// eclipses.
/// @param sun  at one astronomical unit
Sun moonlight(const Sun& sun, const Moon& moon);

}  // namespace airlight
