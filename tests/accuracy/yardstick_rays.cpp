// Writes the yardstick's rays, or with the argument `irradiance` its questions for skylight on level ground, one JSON object a line,
// in the form that `airlight probe --batch` reads. Rays are only ever added at the end: those before keep their numbers and values.
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "airlight/atmosphere.h"

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A sequence that fills 0..1 evenly, however long it becomes; `step` from the golden ratio and its kin.
class Spread {
 public:
  explicit Spread(double step) : step_(step) {}
  double between(double low, double high) {
    at_ += step_;
    at_ -= std::floor(at_);
    return low + (high - low) * at_;
  }

 private:
  double step_, at_ = 0.5;
};

double rounded(double value, double steps = 100) { return std::round(value * steps) / steps; }

using Json = nlohmann::ordered_json;
constexpr double wavelengths[] = {390, 440, 480, 520, 560, 610, 670, 740};
constexpr const char* atmospheres[] = {"earth", "earth-hazy", "mars-clear"};
constexpr double suns[] = {60, 30, 10, 2, -2, -6, -12};  // elevations [degrees]

void write_irradiances() {
  int id = 0;
  for (const char* atmosphere : atmospheres)
    for (const double sun : suns)
      for (const double altitude : {0.0, 10e3}) {
        const Json line{{"id", "sky" + std::to_string(id++)},
                        {"atmosphere", atmosphere},
                        {"quantity", "sky_irradiance"},
                        {"altitude", altitude},
                        {"view_zenith", 0},
                        {"view_azimuth", 0},
                        {"sun_zenith", 90 - sun},
                        {"sun_azimuth", 0},
                        {"wavelengths", wavelengths}};
        std::printf("%s\n", line.dump().c_str());
      }
}

double ground_radius(const char* atmosphere) { return airlight::built_in_atmosphere(atmosphere).planet.ground_radius; }

/// How far the horizon lies below level, or any altitude's limb as seen from a higher one [degrees].
double dip(double radius, double altitude, double lowest = 0) {
  return std::acos((radius + lowest) / (radius + altitude)) / degree;
}

void write_ray(int id, const char* atmosphere, double altitude, double sun, double view_zenith, double view_azimuth,
               double segment = 0) {
  Json line{{"id", std::to_string(id)},
            {"atmosphere", atmosphere},
            {"quantity", segment > 0 ? "path_radiance" : "radiance"},
            {"altitude", altitude},
            {"view_zenith", view_zenith},
            {"view_azimuth", view_azimuth},
            {"sun_zenith", 90 - sun},
            {"sun_azimuth", 0}};
  if (segment > 0) line["distance"] = segment;
  line["wavelengths"] = wavelengths;
  std::printf("%s\n", line.dump().c_str());
}

/// From the ground to space, in all directions. @returns  how many
int write_views_everywhere() {
  const double lengths[] = {100, 1e3, 1e4, 1e5, 300, 3e3, 3e4};  // of segments [m]
  enum View { up, horizon, down, limb, segment };
  const std::pair<double, std::vector<View>> observers[] = {{0, {up, up, horizon, segment}},
                                                            {2, {up, horizon, down, segment}},
                                                            {10e3, {up, horizon, down, segment}},
                                                            {35e3, {horizon, down, limb, segment}},
                                                            {400e3, {down, limb, limb}}};
  Spread elevations(0.6180339887498949), azimuths(0.7548776662466927), places(0.5698402909980532);
  int id = 0, segments = 0;
  const auto write = [&](const char* atmosphere, double altitude, double sun, View view) {
    const double radius = ground_radius(atmosphere), horizon_dip = dip(radius, altitude);
    const auto elevation = [&]() -> double {
      switch (view) {
        case up:
          return elevations.between(2, 90);
        case horizon:
          return elevations.between(0, 1.5) - horizon_dip;
        case down:
          return -elevations.between(horizon_dip + 1, 90);
        case limb:  // lowest point 2 to 60 km high, or as high as the observer
          return -dip(radius, altitude, places.between(2e3, std::min(altitude, 60e3)));
        default:
          return elevations.between(altitude == 0 ? 0 : -60, 60);
      }
    };
    const double view_zenith = rounded(90 - elevation()), view_azimuth = rounded(azimuths.between(0, 180));
    write_ray(id++, atmosphere, altitude, sun, view_zenith, view_azimuth,
              view == segment ? lengths[segments++ % std::size(lengths)] : 0);
  };
  for (const char* atmosphere : atmospheres)
    for (const double sun : suns)
      for (const auto& [altitude, views] : observers)
        for (const View view : views) write(atmosphere, altitude, sun, view);
  write("earth", 0, 60, up);  // the 400th
  return id;
}

/// Where light crosses the most air: from low above the ground to it just below the horizon, and past it just above.
void write_low_views(int id) {
  const double lengths[] = {1e4, 3e4, 1e5};  // of segments [m]
  Spread depths(0.6180339887498949), azimuths(0.7548776662466927), lowest(0.5698402909980532);
  int segments = 0;
  for (const char* atmosphere : {"earth", "earth-hazy"})
    for (const double sun : {60, 10, 2, -2, -6, -12}) {
      const double radius = ground_radius(atmosphere);
      const auto write = [&](double altitude, double elevation, double segment) {
        const double view_zenith = rounded(90 - elevation, 1e4), view_azimuth = rounded(azimuths.between(0, 180));
        write_ray(id++, atmosphere, altitude, sun, view_zenith, view_azimuth, segment);
      };
      // As many in each octave of 0.02 to 1 degree below the horizon.
      const auto below = [&](double altitude) {
        return -dip(radius, altitude) - 0.02 * std::pow(50, depths.between(0, 1));
      };
      for (const double altitude : {30.0, 300.0, 3000.0}) {
        write(altitude, below(altitude), 0);
        write(altitude, -dip(radius, altitude, lowest.between(0.02, 1) * altitude), 0);
      }
      write(300, below(300), lengths[segments++ % std::size(lengths)]);
    }
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::string_view(arguments[1]) == "irradiance")
    write_irradiances();
  else
    write_low_views(write_views_everywhere());
}
