// `airlight tables`: a model's tables as files, for engines with kernels of their own (docs/tables.md).
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "airlight/sky.h"
#include "commands.h"
#include "image/output_file.h"
#include "number_option.h"
#include "options.h"
#include "scenefile/atmosphere_file.h"
#include "sky/model_tables.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

struct TablesOptions {
  std::string air = "earth", folder;
  AirOverrides overrides;
  MachineOptions machine;
  double altitude = 2, sun_elevation = 0, sun_azimuth = 0;
};

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
  options.machine.check_model();
  const Atmosphere air = with_overrides(load_atmosphere(options.air), options.overrides);
  check_number(options.altitude, "--altitude (inside the air)", {0, air.planet.top_altitude, "m"});
  const std::shared_ptr<Engine> engine = options.machine.make();
  const std::array<double, 4> wavelengths = Sky(air, options.machine.model, engine).realtime_wavelengths();
  const ModelTables made = model_tables(air, options.machine.model, *engine, wavelengths, options.altitude,
                                        direction(options.sun_azimuth * degree, options.sun_elevation * degree));

  std::error_code error;
  fs::create_directories(options.folder, error);  // one that cannot be made, the first file complains of
  nlohmann::ordered_json index{{"program", version()},
                               {"atmosphere", air.name},
                               {"model", options.machine.model},
                               {"wavelengths_nm", wavelengths}};
  for (const auto& [name, fields] : made.structs) {
    for (const auto& [field, values] : fields) {
      if (values.size() == 1)
        index[name][field] = values[0];
      else
        index[name][field] = values;
    }
  }
  const Metadata metadata{{"Software", version()}, {"atmosphere", air.name}, {"model", options.machine.model}};
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
  fmt::print(stderr, "{}: {} tables of {} for {}\n", path, made.tables.size(), options.machine.model, air.name);
  return ok;
}

}  // namespace

void add_tables(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<TablesOptions>();
  CLI::App& tables = *app.add_subcommand("tables", "A model's tables as EXR and JSON, for other engines");
  tables.add_option("air", options->air, "atmosphere: a built-in name or a file.toml")->required()->type_name("AIR");
  tables.add_option("-o,--output", options->folder, "folder for the files; made where there is none")
      ->required()
      ->type_name("FOLDER");
  add_number(tables, "--altitude", options->altitude, {0, highest_altitude, "m"},
             "observer of the tables that are for one observer, inside the air");
  add_number(tables, "--sun-elevation", options->sun_elevation, {-90, 90, "degrees"}, "sun of these tables")
      ->required();
  add_number(tables, "--sun-azimuth", options->sun_azimuth, {-360, 360, "degrees"}, "from north, clockwise");
  add_air_overrides(tables, options->overrides);
  options->machine.model = "skyview";
  options->machine.add_to(tables);
  tables.callback([options, &chosen] { chosen = [options] { return run_tables(*options); }; });
}

}  // namespace airlight::cli
