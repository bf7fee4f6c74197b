#include "options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "did_you_mean.h"
#include "interrupt.h"
#include "progress.h"
#include "scene/scene_sun.h"
#include "scenefile/atmosphere_file.h"

namespace airlight::cli {
namespace {

const char* const air_group = "Air";
const char* const sun_group = "Sun";
const char* const machine_group = "Model and engine";

constexpr std::string_view engines[] = {"double", "simd", "gl"};

template <typename Names>
void check_name(std::string_view name, std::string_view option, const Names& names) {
  if (std::find(std::begin(names), std::end(names), name) == std::end(names))
    throw InputError(fmt::format("{} = {}: unknown{}", option, name, did_you_mean(name, names)));
}

template <typename Names>
std::string join(const Names& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

std::vector<std::string_view> model_names() {
  std::vector<std::string_view> names;
  for (const ModelInfo& model : models()) names.push_back(model.name);
  return names;
}

void add_air_overrides(const Verb& verb, AirOverrides& overrides) {
  verb.number("--aerosol-optical-depth", overrides.aerosol_optical_depth, {0, 100, ""},
              "vertical optical depth of the aerosol at 550 nm")
      .group(air_group);
  verb.number("--angstrom", overrides.angstrom, {-2, 5, ""}, "Ångström exponent of the aerosol").group(air_group);
  verb.number("--ozone", overrides.ozone, {0, 10'000, "Dobson units"}, "ozone column").group(air_group);
}

void AirOptions::add_to(const Verb& verb) {
  verb.option("--planet", planet,
              fmt::format("atmosphere: {} or a file.toml (default {})", join(built_in_atmospheres()), planet))
      .group(air_group)
      .type_name("NAME");
  add_air_overrides(verb, overrides);
}

Atmosphere AirOptions::load() const { return with_overrides(load_atmosphere(planet), overrides); }

void SunOptions::add_to(const Verb& verb) {
  const Option place_option =
      verb.option("--place", place,
                  "latitude and longitude on Earth, north and east positive [degrees, -90 .. 90, -180 .. 180]")
          .group(sun_group)
          .type_name("LAT,LON");
  const Option time_option =
      verb.option("--time", time, "ISO 8601 time: 2026-06-21T18:40Z, or with an offset as in +02:00")
          .group(sun_group)
          .type_name("TIME");
  place_option.needs(time_option);
  time_option.needs(place_option);
  verb.flag("--refraction", refraction,
            "lift the sun by the standard refraction of the air, 0.57 degrees at the horizon (default off)")
      .group(sun_group)
      .needs(place_option);
  verb.number("--sun-elevation", elevation, {-90, 90, "degrees"},
              "sun above the horizon, in place of --place and --time")
      .group(sun_group)
      .excludes(place_option);
  verb.number("--sun-azimuth", azimuth, {-360, 360, "degrees"}, "sun's azimuth from north, clockwise (default 0)")
      .group(sun_group)
      .excludes(place_option);
}

SunPlace SunOptions::resolve(std::optional<double> otherwise) const {
  if (!place.empty()) {
    const Time when = parse_time(time);
    const SunPosition position = sun_position(parse_place(place), when);
    const double lift = refraction ? airlight::refraction(position.elevation) : 0;
    return {position.azimuth / degree, (position.elevation + lift) / degree,
            position.distance,         place,
            format_time(when),         refraction};
  }
  if (!elevation && !otherwise)
    throw InputError("where does the sun stand? Give --place and --time, or --sun-elevation [degrees, -90 .. 90]");
  return {azimuth.value_or(0), elevation ? *elevation : *otherwise, 1, {}, {}, false};
}

void SunPlace::describe(Metadata& lines) const {
  lines.push_back({"sun azimuth [degrees]", azimuth});
  lines.push_back({"sun elevation [degrees]", elevation});
  lines.push_back({"refraction", refraction ? "lifts the sun as standard air does" : "none"});
  if (place.empty()) return;
  lines.push_back({"place", place});
  lines.push_back({"time", time});
  lines.push_back({"sun distance [au]", distance});
  lines.push_back({"sun irradiance", "scaled by 1 / distance^2"});
}

Direction SunPlace::direction() const { return airlight::direction(azimuth * degree, elevation * degree); }

void SunPlace::apply_distance(Atmosphere& atmosphere) const { atmosphere.sun = sun_at(atmosphere.sun, distance); }

void MachineOptions::add_to(const Verb& verb, const std::vector<std::string_view>& models) {
  verb.option("--model", model, fmt::format("{} (default {})", join(models), model))
      .group(machine_group)
      .type_name("NAME");
  add_engine(verb, engine);
}

/// Where tables that take long to make are kept between runs; empty: nowhere.
static std::string table_folder() {
  if (const char* folder = std::getenv("AIRLIGHT_CACHE")) return folder;
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder) return std::string(folder) + "/airlight";
  if (const char* folder = std::getenv("HOME"); folder && *folder) return std::string(folder) + "/.cache/airlight";
  return {};
}

void add_engine(const Verb& verb, std::string& engine) {
  verb.option("--engine", engine, fmt::format("{} (default {})", join(engines), engine))
      .group(machine_group)
      .type_name("NAME");
}

void check_model_name(std::string_view model, std::string_view option, const std::vector<std::string_view>& known) {
  check_name(model, option, known);
}

void MachineOptions::check_model() const { check_model_name(model, "--model", model_names()); }

std::shared_ptr<Engine> MachineOptions::make() const { return engine_named(engine); }

std::function<void(double)> watch_tables() {
  return [bar = std::shared_ptr<Progress>()](double done) mutable {
    if (done >= 1) return bar.reset();
    check_interrupt();
    if (!bar) bar = std::make_shared<Progress>("tables");
    bar->show(done);
  };
}

std::shared_ptr<Engine> engine_named(const std::string& name) {
  check_name(name, "--engine", engines);
  auto engine = make_engine(name);
  engine->keep_on_disk(table_folder(),
                       [](const std::string& message) { fmt::print(stderr, "airlight: {}\n", message); });
  engine->watch(watch_tables());
  return engine;
}

std::string describe(const Engine& engine) { return fmt::format("{} ({})", engine.name(), engine.device()); }

}  // namespace airlight::cli
