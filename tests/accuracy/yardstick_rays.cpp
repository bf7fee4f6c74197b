// Writes the yardstick's 400 rays, or with the argument `irradiance` its questions for skylight on level ground, one JSON object a line,
// in the form that `airlight probe --batch` reads.
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

double rounded(double value) { return std::round(value * 100) / 100; }

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

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::string_view(arguments[1]) == "irradiance") {
    write_irradiances();
    return 0;
  }
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
    const double radius = airlight::built_in_atmosphere(atmosphere).planet.ground_radius;
    const double dip = std::acos(radius / (radius + altitude)) / degree;
    const auto elevation = [&]() -> double {
      switch (view) {
        case up:
          return elevations.between(2, 90);
        case horizon:
          return elevations.between(0, 1.5) - dip;
        case down:
          return -elevations.between(dip + 1, 90);
        case limb:  // lowest point 2 to 60 km high, or as high as the observer
          return -std::acos((radius + places.between(2e3, std::min(altitude, 60e3))) / (radius + altitude)) / degree;
        default:
          return elevations.between(altitude == 0 ? 0 : -60, 60);
      }
    };
    Json line{{"id", std::to_string(id++)},
              {"atmosphere", atmosphere},
              {"quantity", view == segment ? "path_radiance" : "radiance"},
              {"altitude", altitude},
              {"view_zenith", rounded(90 - elevation())},
              {"view_azimuth", rounded(azimuths.between(0, 180))},
              {"sun_zenith", 90 - sun},
              {"sun_azimuth", 0}};
    if (view == segment) line["distance"] = lengths[segments++ % std::size(lengths)];
    line["wavelengths"] = wavelengths;
    std::printf("%s\n", line.dump().c_str());
  };
  for (const char* atmosphere : atmospheres)
    for (const double sun : suns)
      for (const auto& [altitude, views] : observers)
        for (const View view : views) write(atmosphere, altitude, sun, view);
  write("earth", 0, 60, up);  // the 400th
}
