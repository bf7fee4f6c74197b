// Where a scene's sun stands: by angles, or by place and time.
#pragma once
#include <optional>

#include "airlight/atmosphere.h"
#include "scene/sun_position.h"

namespace airlight {

/// Angles are those at the scene's origin.
struct SceneSun {
  double azimuth = 0, elevation = 0;  ///< [rad], where there is no time
  std::optional<Time> time;
  std::optional<Place> place;  ///< none: the scene's origin
  bool refraction = false;     ///< lift the sun of place and time by standard air's refraction
};

/// Azimuth and elevation (refraction included) and distance; the distance is 1 where the sun was given by angles.
inline SunPosition sun_of(const SceneSun& sun, const Place& origin) {
  if (!sun.time) return {sun.azimuth, sun.elevation, 1};
  SunPosition position = sun_position(sun.place.value_or(origin), *sun.time);
  if (sun.refraction) position.elevation += refraction(position.elevation);
  return position;
}

/// The Sun from a distance [astronomical units]: irradiance falls with its square, the disc's radius with it.
inline Sun sun_at(Sun sun, double distance) {
  sun.irradiance = sun.irradiance.scaled(1 / (distance * distance));
  sun.angular_radius /= distance;  // the disc's radiance stays the same
  return sun;
}

}  // namespace airlight
