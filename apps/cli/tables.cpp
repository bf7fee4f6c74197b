// `airlight tables`: a model's tables as files, for engines with kernels of their own (docs/tables.md).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "command_line.h"
#include "commands.h"
#include "image/output_file.h"
#include "model_options.h"
#include "number.h"
#include "optics/light_lift.h"
#include "options.h"
#include "scenefile/atmosphere_file.h"
#include "scenefile/scene_file.h"
#include "sky/model_tables.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

struct TablesOptions {
  std::string subject, folder, model, engine = "simd";
  AirOverrides overrides;
  ModelOptions own;
  std::optional<double> altitude, sun_elevation, sun_azimuth;
};

/// What the tables are of: air, and one observer under one sun.
struct Subject {
  Atmosphere air;
  std::string model = "skyview";
  double altitude = 2;                        // [m]
  double sun_elevation = 0, sun_azimuth = 0;  // in the observer's frame [degrees]
};

Subject of_scene(const std::string& path) {
  const Scene scene = load_scene(path);
  const Land land(scene.land);
  const PlacedCamera camera = place_camera(scene.camera, land);
  const SunPosition sun = sun_of(scene.sun, land.origin());
  const Direction seen = camera.from_scene(direction(sun.azimuth, sun.elevation));
  Subject subject{scene.air, scene.picture.model, camera.camera.altitude, 0, 0};
  SunPlace place;
  place.distance = sun.distance;
  place.apply_distance(subject.air);
  subject.sun_elevation = std::asin(std::clamp(seen[2], -1.0, 1.0)) / degree;
  subject.sun_azimuth = std::atan2(seen[0], seen[1]) / degree;
  return subject;
}

/// The options' words come before a scene's.
Subject subject_of(const TablesOptions& options) {
  Subject subject;
  if (is_scene_file(options.subject)) {
    subject = of_scene(options.subject);
  } else {
    if (!options.sun_elevation)
      throw InputError("where does the sun stand? Give --sun-elevation [degrees, -90 .. 90], or a scene");
    subject.air = load_atmosphere(options.subject);
  }
  subject.air = with_overrides(subject.air, options.overrides);
  if (!options.model.empty()) subject.model = options.model;
  check_model_name(subject.model, "--model", model_names());
  subject.altitude = options.altitude.value_or(subject.altitude);
  subject.sun_elevation = options.sun_elevation.value_or(subject.sun_elevation);
  subject.sun_azimuth = options.sun_azimuth.value_or(subject.sun_azimuth);
  check_number(subject.altitude,
               options.altitude ? "--altitude (inside the air)" : "the camera's altitude (inside the air)",
               {0, subject.air.planet.top_altitude, "m"});
  return subject;
}

/// The four wavelengths as R, G, B, A; the slices of a table of three dimensions one below the other.
void write_exr(const std::string& path, const ModelTables::Texels& table, const Metadata& metadata) {
  const int height = table.shape.height * table.shape.depth;
  PictureFile file(path, table.shape.width, height, {.half = false, .layers = {"A"}}, metadata);
  const LayerRows alpha{table.rgba.data() + 3, 4};
  file.write_rows(0, height, table.rgba, std::span(&alpha, 1));
  file.finish();
}

void write_bytes(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

int run_tables(const TablesOptions& options) {
  const auto [air, model, altitude, sun_elevation, sun_azimuth] = subject_of(options);
  const std::shared_ptr<Engine> engine = engine_named(options.engine);
  const std::array<double, 4> wavelengths = Sky(air, model, engine).realtime_wavelengths();
  const ModelTables made = model_tables(air, model, options.own.parameters(), *engine, wavelengths, altitude,
                                        direction(sun_azimuth * degree, sun_elevation * degree));
  const LightLift colour = light_lift(air, wavelengths);

  std::error_code error;
  fs::create_directories(options.folder, error);  // one that cannot be made, the first file complains of
  nlohmann::ordered_json index{
      {"program", version()},          {"atmosphere", air.name},    {"model", model},
      {"wavelengths_nm", wavelengths}, {"to_srgb", colour.to_srgb}, {"from_srgb", colour.to_spectrum}};
  for (const auto& [name, fields] : made.structs) {
    for (const auto& [field, values] : fields) {
      if (values.size() == 1)
        index[name][field] = values[0];
      else
        index[name][field] = values;
    }
  }
  const Metadata metadata{{"Software", version()}, {"atmosphere", air.name}, {"model", model}};
  for (const auto& [name, table] : made.tables) {
    const std::string exr = name + ".exr", raw = name + ".f32";
    write_exr((fs::path(options.folder) / exr).string(), table, metadata);
    const auto bytes = std::as_bytes(std::span(table.rgba));
    write_bytes((fs::path(options.folder) / raw).string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    index["tables"][name] = {{"width", table.shape.width},
                             {"height", table.shape.height},
                             {"depth", table.shape.depth},
                             {"exr", exr},
                             {"raw", raw}};
  }
  // Last: where it is, the tables are whole.
  const std::string path = (fs::path(options.folder) / "tables.json").string();
  write_bytes(path, index.dump(1) + "\n");
  fmt::print(stderr, "{}: {} tables of {} for {}\n", path, made.tables.size(), model, air.name);
  return ok;
}

}  // namespace

void add_tables(CommandLine& line) {
  const auto options = std::make_shared<TablesOptions>();
  const Verb tables = line.verb("tables", "A model's tables as EXR and JSON, for other engines");
  tables
      .option("subject", options->subject,
              "atmosphere: a built-in name or a file.toml; or a scene, for its air, its sun and its camera's altitude")
      .required()
      .type_name("AIR|SCENE");
  tables.option("-o,--output", options->folder, "folder for the files; made where there is none")
      .required()
      .type_name("FOLDER");
  tables.number("--altitude", options->altitude, {0, highest_altitude, "m"},
                "observer of the tables that are for one observer, inside the air (default 2, or the scene's camera)");
  tables.number("--sun-elevation", options->sun_elevation, {-90, 90, "degrees"},
                "sun of these tables (default the scene's)");
  tables.number("--sun-azimuth", options->sun_azimuth, {-360, 360, "degrees"},
                "from north, clockwise (default 0, or the scene's)");
  add_air_overrides(tables, options->overrides);
  tables.option("--model", options->model, "model of the sky (default skyview, or the scene's)").type_name("NAME");
  options->own.add_to(tables);
  add_engine(tables, options->engine);
  tables.runs([options] { return run_tables(*options); });
}

}  // namespace airlight::cli
