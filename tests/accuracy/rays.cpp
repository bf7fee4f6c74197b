#include "rays.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

namespace airlight::accuracy {
namespace {

constexpr double degree = std::numbers::pi / 180;

Direction towards(double elevation, double azimuth) {
  return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
}

/// Draws from the generator's own numbers: the standard library's distributions differ between libraries.
class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * double(random_()) * 0x1p-32; }
  double logarithmic(double low, double high) { return low * std::pow(high / low, between(0, 1)); }

 private:
  std::mt19937 random_{seed};
};

/// Elevation [rad] of a view of each kind for an observer at this altitude; 0 up, 1 along the horizon, 2 down, 3 past
/// the limb.
double view_elevation(Draw& draw, int kind, double radius, double altitude) {
  const double dip = std::acos(radius / (radius + altitude));
  switch (kind) {
    case 0:
      return draw.between(2 * degree, 90 * degree);
    case 1:
      return draw.between(-1 * degree, 1 * degree) - dip;
    case 2:
      return draw.between(-90 * degree, -dip - 1 * degree);
    default:
      // Lowest point 0 to 80 km high; an observer below that looks from his horizon to his horizontal.
      return -std::acos((radius + draw.between(0, std::min(altitude, 80e3))) / (radius + altitude));
  }
}

}  // namespace

std::vector<RayGroup> draw_rays() {
  Draw draw;
  std::vector<RayGroup> groups;
  for (const char* name : {"earth", "earth-hazy", "mars-clear"}) {
    const double radius = built_in_atmosphere(name).planet.ground_radius;
    for (const double sun : {90.0, 60.0, 30.0, 10.0, 3.0, 0.5, -1.0, -3.0, -5.0, -8.0}) {
      RayGroup group{name, sun, {}};
      for (int i = 0; i < 10; ++i) {
        Ray ray;
        ray.altitude = i == 0       ? 0
                       : i % 2 == 0 ? draw.logarithmic(1, 400e3)
                                    : draw.between(0, 400e3) * draw.between(0, 1);
        ray.view = towards(view_elevation(draw, i % 4, radius, ray.altitude), draw.between(0, 360 * degree));
        ray.sun = towards(sun * degree, draw.between(0, 360 * degree));
        if (i >= 5) ray.distance = draw.logarithmic(100, 100e3);
        group.rays.push_back(ray);
      }
      groups.push_back(group);
    }
  }
  return groups;
}

std::string describe(const RayGroup& group, const Ray& ray) {
  const auto azimuth = [](const Direction& d) { return std::atan2(d[0], d[1]) / degree; };
  const auto zenith = [](const Direction& d) { return std::atan2(std::hypot(d[0], d[1]), d[2]) / degree; };
  nlohmann::ordered_json line{{"atmosphere", group.atmosphere},
                              {"altitude", ray.altitude},
                              {"view_zenith", zenith(ray.view)},
                              {"view_azimuth", azimuth(ray.view)},
                              {"sun_zenith", zenith(ray.sun)},
                              {"sun_azimuth", azimuth(ray.sun)},
                              {"distance", nullptr}};
  if (std::isfinite(ray.distance)) line["distance"] = ray.distance;
  return line.dump();
}

}  // namespace airlight::accuracy
