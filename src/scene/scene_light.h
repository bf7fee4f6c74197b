// A light beside the sun: a second sun, or the Moon.
#pragma once
#include <optional>

#include "airlight/atmosphere.h"
#include "scene/scene_sun.h"

namespace airlight {

/// What a scene says of it.
struct SceneLight {
  SceneSun place;     ///< by angles, or by place and time: of the moon, or of the sun at that time
  bool moon = false;  ///< else a sun
  double phase = 0;   ///< of a moon that stands by angles [rad]: 0 full
  std::optional<Spectrum>
      irradiance;  ///< outside the air [W m^-2 nm^-1]; none: the sun's, or the moon's, times `ratio`
  double ratio = 1;
  std::optional<double> angular_radius;  ///< [rad]; none: the sun's, or the moon's
};

/// The same, put into the scene.
struct PlacedLight {
  double azimuth, elevation;  ///< at the scene's origin [rad]
  Sun source;                 ///< its irradiance and disc; a moon's is even
};

/// @param sun     of the scene's air, at one astronomical unit
/// @param origin  of the scene
PlacedLight place_light(const SceneLight& light, const Sun& sun, const Place& origin);

}  // namespace airlight
