#include "scenefile/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/number_text.h"
#include "optics/validate.h"
#include "scenefile/atmosphere_file.h"
#include "scenefile/model_toml.h"
#include "scenefile/scene_toml.h"
#include "scenefile/spectrum_toml.h"
#include "scenefile/text_file.h"
#include "scenefile/toml_text.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr Limits altitudes{-20'000, 1e9, "m"}, distances{-1e7, 1e7, "m"}, turns{-360, 360, "degrees"},
    elevations{-90, 90, "degrees"}, fractions{0, 1}, sizes{1, 65'536, "pixels"};

// ---- values in their ranges ----

[[noreturn]] void out_of_range(const TableReader& reader, std::string_view key, double value, const Limits& limits) {
  const std::string unit = *limits.unit ? " " + std::string(limits.unit) : "";
  reader.fail(key, " = " + number_text(value) + ": expected " + number_text(limits.low) + " .. " +
                       number_text(limits.high) + unit);
}

double number(TableReader& reader, std::string_view key, const Limits& limits, std::optional<double> fallback = {}) {
  const double value = fallback ? reader.number(key, *fallback) : reader.number(key);
  if (!(value >= limits.low && value <= limits.high)) out_of_range(reader, key, value, limits);
  return value;
}

int whole(TableReader& reader, std::string_view key, const Limits& limits, int fallback) {
  const double value = number(reader, key, limits, fallback);
  if (value != std::floor(value)) reader.fail(key, " = " + number_text(value) + ": expected a whole number");
  return int(value);
}

template <std::size_t N>
std::array<double, N> numbers(TableReader& reader, std::string_view key, const std::array<Limits, N>& limits) {
  const auto values = reader.numbers(key);
  if (values.size() != N) {
    reader.fail(key, ": expected " + std::to_string(N) + " numbers, got " + std::to_string(values.size()));
  }
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = values[i];
    if (!(values[i] >= limits[i].low && values[i] <= limits[i].high)) {
      out_of_range(reader, std::string(key) + "[" + std::to_string(i) + "]", values[i], limits[i]);
    }
  }
  return result;
}

template <std::size_t N>
std::size_t choice(TableReader& reader, std::string_view key, const std::array<std::string_view, N>& names,
                   std::size_t fallback) {
  if (!reader.has(key)) return fallback;
  const std::string name = reader.text(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) reader.fail(key, " = " + toml_text(name) + ": unknown" + did_you_mean(name, names));
  return std::size_t(found - names.begin());
}

/// What others refuse is refused here with file, line and key.
template <typename Work>
auto at_key(TableReader& reader, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    reader.fail(key, std::string(": ") + error.what());
  }
}

Place place(TableReader& reader, std::string_view key) {
  const std::string text = reader.text(key);
  return at_key(reader, key, [&] { return parse_place(text); });
}

/// Two keys of which one at most may be there.
void one_of(const TableReader& reader, bool first, bool second, std::string_view key, const std::string& other) {
  if (first && second) reader.fail(key, ": expected either this or " + other + ", not both");
}

// ---- the parts ----

Atmosphere read_air(TableReader& root) {
  const auto load = [&](TableReader& reader, std::string_view key) {
    const std::string name = reader.text(key);
    return at_key(reader, key, [&] { return load_atmosphere(name.ends_with(".toml") ? reader.beside(name) : name); });
  };
  const toml::node* node = root.find("air");
  if (!node) return built_in_atmosphere("earth");
  if (node->is_string()) return load(root, "air");
  TableReader reader = root.table("air");
  Atmosphere air = load(reader, "base");
  const auto apply = [&](const char* key, std::optional<double> AirOverrides::*member) {
    if (!reader.has(key)) return;
    AirOverrides overrides;
    overrides.*member = reader.number(key);
    air = at_key(reader, key, [&] { return with_overrides(air, overrides); });
  };
  apply("angstrom", &AirOverrides::angstrom);
  apply("aerosol_optical_depth", &AirOverrides::aerosol_optical_depth);
  apply("ozone", &AirOverrides::ozone);
  reader.finish();
  return air;
}

Spot read_spot(TableReader& reader, const char* place_key, const char* position_key) {
  one_of(reader, reader.has(place_key), reader.has(position_key), position_key, place_key);
  if (reader.has(place_key)) return place(reader, place_key);
  return numbers<2>(reader, position_key, {distances, distances});
}

SceneCamera read_camera(TableReader reader) {
  SceneCamera scene;
  Camera& camera = scene.camera;
  struct Kind {
    Projection projection;
    int width, height;
    double elevation, field_of_view;
    Limits fields;
  };
  constexpr std::array<std::string_view, 4> names{"perspective", "equirectangular", "fisheye", "cube"};
  constexpr Kind kinds[] = {{Projection::perspective, 1280, 720, 0, 60, {0.1, 170, "degrees"}},
                            {Projection::equirectangular, 2048, 1024, 0, 360, {360, 360, "degrees"}},
                            {Projection::fisheye, 1024, 1024, 90, 180, {1, 360, "degrees"}},
                            {Projection::cube, 512, 512, 0, 90, {90, 90, "degrees"}}};
  const Kind& kind = kinds[choice(reader, "type", names, 0)];
  camera.projection = kind.projection;
  camera.width = whole(reader, "width", sizes, kind.width);
  camera.height =
      whole(reader, "height", sizes, std::max(1, int(std::lround(double(camera.width) * kind.height / kind.width))));
  if (kind.projection == Projection::cube && camera.height != camera.width) {
    reader.fail("height", " = " + std::to_string(camera.height) + ": expected " + std::to_string(camera.width) +
                              ", the width: faces are square");
  }
  camera.field_of_view = degree * number(reader, "field_of_view", kind.fields, kind.field_of_view);

  if (reader.has("place") || reader.has("position")) scene.spot = read_spot(reader, "place", "position");
  one_of(reader, reader.has("altitude"), reader.has("height_above_ground"), "altitude", "height_above_ground");
  if (reader.has("altitude")) scene.altitude = number(reader, "altitude", altitudes);
  scene.height_above_ground = number(reader, "height_above_ground", {0.1, 1e9, "m"}, 2);
  scene.key = reader.location("altitude");

  const bool looks_at = reader.has("look_at") || reader.has("look_at_position");
  one_of(reader, looks_at, reader.has("azimuth") || reader.has("elevation"),
         reader.has("azimuth") ? "azimuth" : "elevation", "look_at");
  if (looks_at) scene.target = read_spot(reader, "look_at", "look_at_position");
  if (reader.has("look_at_altitude")) {
    if (!looks_at) reader.fail("look_at_altitude", ": expected look_at or look_at_position, too");
    scene.target_altitude = number(reader, "look_at_altitude", altitudes);
  }
  camera.azimuth = degree * number(reader, "azimuth", turns, 0);
  camera.elevation = degree * number(reader, "elevation", elevations, kind.elevation);
  camera.roll = degree * number(reader, "roll", turns, 0);
  reader.finish();
  return scene;
}

/// @param angles_needed  where there is no time
SceneSun read_where(TableReader& reader, bool angles_needed) {
  SceneSun sun;
  const bool timed = reader.has("time");
  one_of(reader, timed, reader.has("elevation"), "elevation", "time");
  one_of(reader, timed, reader.has("azimuth"), "azimuth", "time");
  if (timed) {
    const std::string text = reader.text("time");
    sun.time = at_key(reader, "time", [&] { return parse_time(text); });
    if (reader.has("place")) sun.place = place(reader, "place");
    sun.refraction = reader.flag("refraction", false);
  } else {
    if (angles_needed || reader.has("elevation")) sun.elevation = degree * number(reader, "elevation", elevations);
    sun.azimuth = degree * number(reader, "azimuth", turns, 0);
    for (const char* key : {"place", "refraction"}) {
      if (reader.has(key)) reader.fail(key, ": expected only where time is given");
    }
  }
  return sun;
}

SceneSun read_sun(TableReader reader) {
  const SceneSun sun = read_where(reader, true);
  reader.finish();
  return sun;
}

/// @param sun  a moon that says not where it stands is that of the sun's place and time
SceneLight read_light(TableReader& reader, const SceneSun& sun) {
  SceneLight light;
  constexpr std::array<std::string_view, 2> bodies{"sun", "moon"};
  light.moon = choice(reader, "body", bodies, 0) == 1;
  const bool with_the_sun = light.moon && sun.time && !reader.has("time") && !reader.has("elevation");
  light.place = read_where(reader, !with_the_sun);
  if (with_the_sun) {
    if (reader.has("azimuth")) reader.fail("azimuth", ": expected elevation, too");
    light.place = sun;
  }
  if (reader.has("phase")) {
    if (!light.moon || light.place.time) reader.fail("phase", ": expected only of a moon that stands by angles");
    light.phase = degree * number(reader, "phase", {0, 180, "degrees"});
  }
  one_of(reader, reader.has("ratio"), reader.has("irradiance"), "irradiance", "ratio");
  light.ratio = number(reader, "ratio", {0, 1e6}, 1);
  if (reader.has("irradiance")) light.irradiance = read_spectrum(reader, "irradiance", {0, 1e6, "W m^-2 nm^-1"});
  if (reader.has("angular_radius"))
    light.angular_radius = degree * number(reader, "angular_radius", {0.001, 85, "degrees"});
  reader.finish();
  return light;
}

ElevationFile read_terrain(TableReader& reader) {
  ElevationFile file;
  file.file = reader.beside(reader.text("file"));
  file.band = whole(reader, "band", {1, 1000}, 1);
  file.height_scale = number(reader, "height_scale", {1e-6, 1e6}, 1);
  file.height_offset = number(reader, "height_offset", {-1e5, 1e5, "m"}, 0);
  if (reader.has("cell_size")) file.cell_size = number(reader, "cell_size", {1e-3, 1e5, "m"});
  file.blend = number(reader, "blend", {0.1, 1e5, "m"}, file.blend);
  reader.finish();
  return file;
}

ReliefSettings read_relief(TableReader reader) {
  ReliefSettings relief;
  relief.seed = std::uint32_t(whole(reader, "seed", {0, 2e9}, 1));
  relief.height = number(reader, "height", {0, 20'000, "m"}, relief.height);
  relief.wavelength = number(reader, "wavelength", {100, 1e6, "m"}, relief.wavelength);
  relief.ruggedness = number(reader, "ruggedness", fractions, relief.ruggedness);
  reader.finish();
  return relief;
}

void read_land(TableReader reader, Scene& scene) {
  LandSettings& land = scene.land;
  land.extent = number(reader, "extent", {100, 1e6, "m"}, land.extent);
  if (reader.has("plain_altitude")) land.plain_altitude = number(reader, "plain_altitude", {-20'000, 20'000, "m"});
  scene.detail = number(reader, "detail", {0.1, 100, "pixels"}, scene.detail);
  reader.finish();
}

SurfaceSettings read_surface(TableReader reader) {
  SurfaceSettings s;
  if (reader.has("image")) {
    s.image = reader.beside(reader.text("image"));
    s.image_linear = reader.flag("image_linear", false);
    s.image_scale = number(reader, "image_scale", {0, 100}, 1);
  } else {
    for (const char* key : {"image_linear", "image_scale"}) {
      if (reader.has(key)) reader.fail(key, ": expected only where image is given");
    }
  }
  s.snow_line = number(reader, "snow_line", {-1e9, 1e9, "m"}, s.snow_line);
  s.grass_line = number(reader, "grass_line", {-1e9, 1e9, "m"}, s.grass_line);
  s.water_level = number(reader, "water_level", {-1e9, 1e9, "m"}, s.water_level);
  s.steepest_grass = degree * number(reader, "steepest_grass", {0, 90, "degrees"}, s.steepest_grass / degree);
  s.steepest_snow = degree * number(reader, "steepest_snow", {0, 90, "degrees"}, s.steepest_snow / degree);
  s.variety = number(reader, "variety", fractions, s.variety);
  const std::array<Limits, 3> rgb{fractions, fractions, fractions};
  if (reader.has("rock")) s.rock = numbers<3>(reader, "rock", rgb);
  if (reader.has("snow")) s.snow = numbers<3>(reader, "snow", rgb);
  if (reader.has("water")) s.water = numbers<3>(reader, "water", rgb);
  if (reader.has("grass")) s.grass = numbers<3>(reader, "grass", rgb);
  reader.finish();
  return s;
}

ScenePicture read_picture(TableReader reader) {
  ScenePicture p;
  p.samples = whole(reader, "samples", {1, 256}, p.samples);
  p.soft_shadows = reader.flag("soft_shadows", p.soft_shadows);
  if (reader.has("air_shadows")) p.air_shadows = reader.flag("air_shadows", false);
  if (reader.has("model")) p.model = reader.text("model");
  if (const toml::node* exposure = reader.find("exposure");
      exposure && !(exposure->is_string() && reader.text("exposure") == "auto")) {
    if (exposure->is_string())
      reader.fail("exposure",
                  " = " + toml_text(reader.text("exposure")) + ": expected \"auto\" or a number, -100 .. 100 EV");
    p.exposure_ev = number(reader, "exposure", {-100, 100, "EV"});
  }
  constexpr std::array<std::string_view, 6> tones{"filmic", "reinhard", "clip", "codeflow", "sqrt", "exponential"};
  if (reader.has("tone")) p.tone = tones[choice(reader, "tone", tones, 0)];
  reader.finish();
  return p;
}

}  // namespace

SceneLight parse_light(const std::string& keys, const std::string& name, const SceneSun& sun) {
  toml::table document;
  try {
    document = parse_toml("light = { " + keys + " }", name);
  } catch (const InputError&) {
    throw InputError(name + " = " + keys.substr(0, 80) +
                     ": expected keys with values, as 'body = \"moon\"' or 'elevation = 3, azimuth = 200'");
  }
  TableReader root(document, name), reader = root.table("light");
  root.finish();
  return read_light(reader, sun);
}

Scene parse_scene(std::string_view text, const std::string& file) { return read_scene(parse_toml(text, file), file); }

Scene read_scene(const toml::table& document, const std::string& file) {
  TableReader root(document, file);
  Scene scene;
  scene.name = std::filesystem::path(file).stem().string();
  scene.air = read_air(root);
  scene.land.planet_radius = scene.air.planet.ground_radius;
  if (root.has("place")) scene.land.origin = place(root, "place");
  scene.sun = read_sun(root.table("sun"));
  if (root.has("light")) {
    for (TableReader& reader : root.tables("light")) scene.lights.push_back(read_light(reader, scene.sun));
  }
  if (root.has("terrain")) {
    for (TableReader& reader : root.tables("terrain")) scene.land.files.push_back(read_terrain(reader));
  }
  if (root.has("relief")) scene.land.relief = read_relief(root.table("relief"));
  if (root.has("land")) read_land(root.table("land"), scene);
  scene.has_land = !scene.land.files.empty() || scene.land.relief;
  if (root.has("surface")) scene.surface = read_surface(root.table("surface"));
  if (root.has("picture")) scene.picture = read_picture(root.table("picture"));
  scene.camera = read_camera(root.table("camera"));
  scene.parameters = read_model_tables(root);
  root.has("animate");
  root.finish();
  if (scene.land.relief && scene.land.extent > 1000 * scene.land.relief->wavelength) {
    root.fail("relief.wavelength", " = " + number_text(scene.land.relief->wavelength) +
                                       ": expected at least a thousandth of land.extent, " +
                                       number_text(scene.land.extent / 1000) + " m");
  }
  return scene;
}

Scene load_scene(const std::string& path) {
  const auto text = read_text_file(path);
  if (!text) throw InputError(path + ": no such file");
  return parse_scene(*text, path);
}

bool is_scene_file(const std::string& name) {
  const auto text = name.ends_with(".toml") ? read_text_file(name) : std::nullopt;
  return text && parse_toml(*text, name).contains("camera");
}

}  // namespace airlight
