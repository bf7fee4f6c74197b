// Small atmospheres and directions whose answers are known in closed form.
#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "reference/single_scattering.h"

namespace airlight::reference {

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double wavelength = 550;  // any: these spectra are constant
inline constexpr SingleScatteringSettings by_point_sun{.point_sun = true};

inline Direction towards(double elevation_deg, double azimuth_deg = 0) {
  const double e = elevation_deg * degree, a = azimuth_deg * degree;
  return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

inline Atmosphere vacuum(double radius = 6.371e6, double top = 100e3) {
  Atmosphere atmosphere;
  atmosphere.planet = {.ground_radius = radius, .top_altitude = top, .albedo = 0.3};
  atmosphere.sun.irradiance = 2.0;
  return atmosphere;
}
inline Atmosphere with(Atmosphere atmosphere, Profile profile, double scattering, double absorption,
                       Phase phase = IsotropicPhase{}) {
  atmosphere.constituents.push_back({"air", std::move(profile), scattering, absorption, std::move(phase)});
  return atmosphere;
}
inline LayersProfile layer(double bottom, double top) { return {{{bottom, top, 1.0}}}; }

inline double transmittance(const Atmosphere& atmosphere, const Ray& ray) {
  return SingleScattering(atmosphere).along(ray, {&wavelength, 1}).transmittance[0];
}
inline double optical_depth(const Atmosphere& atmosphere, const Ray& ray) {
  return -std::log(transmittance(atmosphere, ray));
}
inline double path_radiance(const Atmosphere& atmosphere, const Ray& ray, SingleScatteringSettings settings = {}) {
  return SingleScattering(atmosphere, settings).along(ray, {&wavelength, 1}).path_radiance[0];
}
inline double sun_irradiance(const Atmosphere& atmosphere, const Ray& ray, SingleScatteringSettings settings = {}) {
  return SingleScattering(atmosphere, settings).sun_irradiance(ray, {&wavelength, 1})[0];
}

/// The same question asked by an observer at `distance` along the ray, in that observer's own frame.
inline Ray moved(const Ray& ray, double distance, double planet_radius) {
  const auto dot = [](const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const Direction& a, const Direction& b) {
    return Direction{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto unit = [](Direction d) {
    const double length = std::hypot(d[0], d[1], d[2]);
    return Direction{d[0] / length, d[1] / length, d[2] / length};
  };
  const Direction place{distance * ray.view[0], distance * ray.view[1],
                        planet_radius + ray.altitude + distance * ray.view[2]};
  const Direction up = unit(place), east = unit(cross(Direction{0.3, 1, 0.1}, up)), north = cross(up, east);
  const auto local = [&](const Direction& d) { return Direction{dot(d, east), dot(d, north), dot(d, up)}; };
  return {std::hypot(place[0], place[1], place[2]) - planet_radius, local(ray.view), local(ray.sun),
          ray.distance - distance};
}

}  // namespace airlight::reference
