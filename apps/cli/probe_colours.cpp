#include "probe_colours.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "airlight/error.h"
#include "airlight/model_info.h"
#include "commands.h"
#include "optics/colour.h"

namespace airlight::cli {
namespace {

struct Row {
  const char* name;
  Quantity quantity;
  const char* unit;  ///< "1" stands for the system's own unit of light too
};
constexpr Row rows[] = {{"radiance", Quantity::radiance, "relative"},
                        {"path_radiance", Quantity::path_radiance, "relative"},
                        {"transmittance", Quantity::transmittance, "1"},
                        {"sun_irradiance", Quantity::sun_irradiance, "relative"},
                        {"sky_irradiance", Quantity::sky_irradiance, "relative"}};

using Colour = std::array<double, 3>;

/// In degrees, from the ray's unit vectors.
double zenith(const Direction& d) { return std::acos(std::clamp(d[2], -1.0, 1.0)) * 180 / std::numbers::pi; }

}  // namespace

std::string probe_colours(const ColourQuestion& question, bool json) {
  const Sky sky(question.atmosphere, question.model, question.engine, question.parameters);
  const ColourModel& colours = *model_info(question.model).colours;
  std::array<std::optional<Colour>, std::size(rows)> answers;
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    Colour answer;
    try {
      sky.evaluate(rows[i].quantity, {&question.ray, 1}, colours.wavelengths, answer);
      answers[i] = answer;
    } catch (const InputError&) {
      if (i == 0) throw;  // nothing on the view itself
    }
  }
  const std::string engine = describe(*question.engine);
  if (json) {
    nlohmann::ordered_json out{{"version", version()},
                               {"model", question.model},
                               {"engine", engine},
                               {"altitude", question.ray.altitude},
                               {"view", question.ray.view},
                               {"distance", nullptr},
                               {"sun_azimuth", question.sun.azimuth},
                               {"sun_elevation", question.sun.elevation},
                               {"wavelengths", colours.wavelengths}};
    if (std::isfinite(question.ray.distance)) out["distance"] = question.ray.distance;
    nlohmann::ordered_json units{{"altitude", "m"}, {"distance", "m"}, {"wavelengths", "nm"}};
    for (std::size_t i = 0; i < std::size(rows); ++i) {
      if (!answers[i]) continue;
      out[rows[i].name] = *answers[i];
      units[rows[i].name] = rows[i].unit;
    }
    out["luminance"] = colours.luminance * luminance(*answers[0]);
    units["luminance"] = "cd m-2";
    out["units"] = units;
    return out.dump(2) + '\n';
  }
  std::string text = fmt::format("model       {} on {}\nobserver    {:g} m above the ground\n", question.model, engine,
                                 question.ray.altitude);
  text += fmt::format("view        zenith {:g} degrees, {}\n", zenith(question.ray.view),
                      std::isfinite(question.ray.distance) ? fmt::format("up to {:g} m", question.ray.distance)
                                                           : "to space or the ground");
  text += fmt::format("sun         azimuth {:g}, elevation {:g} degrees\n\n{:<16}", question.sun.azimuth,
                      question.sun.elevation, "");
  for (const char* name : {"red", "green", "blue"}) text += fmt::format("{:>14}", name);
  if (!colours.wavelengths.empty()) {
    text += fmt::format("\n{:<16}", "nm");
    for (const double w : colours.wavelengths) text += fmt::format("{:>14g}", w);
  }
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    if (!answers[i]) continue;
    text += fmt::format("\n{:<16}", rows[i].name);
    for (const double v : *answers[i]) text += fmt::format("{:>14.6g}", v);
    text += fmt::format("  {}", rows[i].unit);
  }
  return text + fmt::format("\n{:<16}{:>14.6g}  cd m-2, as pictures show it\n", "luminance",
                            colours.luminance * luminance(*answers[0]));
}

}  // namespace airlight::cli
