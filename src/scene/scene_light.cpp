#include "scene/scene_light.h"

#include "scene/moon.h"

namespace airlight {
namespace {

Moon moon_of(const SceneLight& light, const Place& origin) {
  const SceneSun& where = light.place;
  if (!where.time) return {.azimuth = where.azimuth, .elevation = where.elevation, .phase = light.phase};
  Moon moon = moon_at(where.place.value_or(origin), *where.time);
  if (where.refraction) moon.elevation += refraction(moon.elevation);
  return moon;
}

}  // namespace

PlacedLight place_light(const SceneLight& light, const Sun& sun, const Place& origin) {
  PlacedLight placed{};
  if (light.moon) {
    const Moon moon = moon_of(light, origin);
    placed = {moon.azimuth, moon.elevation, moonlight(sun, moon)};
  } else {
    const SunPosition at = sun_of(light.place, origin);
    placed = {at.azimuth, at.elevation, sun_at(sun, at.distance)};
  }
  placed.source.irradiance = light.irradiance.value_or(placed.source.irradiance.scaled(light.ratio));
  placed.source.angular_radius = light.angular_radius.value_or(placed.source.angular_radius);
  return placed;
}

}  // namespace airlight
