// Option groups that several commands share: which air, where the sun stands, which model and engine.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/camera.h"
#include "airlight/engine.h"
#include "command_line.h"
#include "image/picture_file.h"

namespace airlight::cli {

/// --aerosol-optical-depth, --angstrom, --ozone
void add_air_overrides(const Verb& verb, AirOverrides& overrides);

/// --planet and the overrides.
struct AirOptions {
  std::string planet = "earth";
  AirOverrides overrides;

  void add_to(const Verb& verb);
  /// @throws InputError
  Atmosphere load() const;
};

/// Where the sun stands, in the observer's frame, and how it was said.
struct SunPlace {
  double azimuth = 0, elevation = 0;  ///< [degrees]; refraction's lift included where asked for
  double distance = 1;                ///< [astronomical units]; 1 unless place and time say otherwise
  std::string place, time;            ///< empty: angles were given
  bool refraction = false;

  Direction direction() const;
  /// The sun of this distance: irradiance falls with its square, the disc's radius with it.
  void apply_distance(Atmosphere& atmosphere) const;
  /// Adds lines for a picture's metadata or a table.
  void describe(Metadata& lines) const;
};

/// --place and --time, with --refraction; or --sun-elevation and --sun-azimuth.
struct SunOptions {
  std::string place, time;
  bool refraction = false;
  std::optional<double> elevation, azimuth;

  void add_to(const Verb& verb);
  /// @param otherwise  elevation [degrees] where the command line does not say where the sun stands
  /// @throws InputError, also where neither does
  SunPlace resolve(std::optional<double> otherwise = {}) const;
};

/// The models of the sky.
std::vector<std::string_view> model_names();

/// --model and --engine
struct MachineOptions {
  std::string model = "skyview", engine = "simd";

  /// @param models  the names that --help lists
  void add_to(const Verb& verb, const std::vector<std::string_view>& models = model_names());
  /// @throws InputError for unknown names, with "did you mean".
  void check_model() const;
  std::shared_ptr<Engine> make() const;
};
/// --engine alone
void add_engine(const Verb& verb, std::string& engine);
/// @throws InputError for unknown names, with "did you mean"; WorkError where the engine cannot run.
/// Tables are kept on disk; making them shows a bar on a terminal and heeds Ctrl-C.
std::shared_ptr<Engine> engine_named(const std::string& engine);
/// What shows the bar and throws Interrupted: for Engine::watch().
std::function<void(double done)> watch_tables();

/// @throws InputError "--model = skyveiw: unknown; did you mean skyview?"
void check_model_name(std::string_view model, std::string_view option, const std::vector<std::string_view>& known);

/// "simd (avx512, 2 threads)"
std::string describe(const Engine& engine);

}  // namespace airlight::cli
