// `airlight sky`: a picture of the sky, as panorama, fisheye, cube map or through a lens.
#include "airlight/sky.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "interrupt.h"
#include "lens.h"
#include "lights.h"
#include "model_options.h"
#include "number.h"
#include "options.h"
#include "parameter_pictures.h"
#include "picture_outputs.h"
#include "progress.h"
#include "spectral_colours.h"
#ifdef AIRLIGHT_WITH_REFERENCE
#include "reference_sky.h"
#endif

namespace airlight::cli {
namespace {

struct SkyOptions {
  AirOptions air;
  SunOptions sun;
  MachineOptions machine;
  ModelOptions own;
  std::vector<std::string> outputs, lights;
  std::string projection = "equirectangular", size, exposure, tone, wavelengths = "4";
  double altitude = 2, azimuth = 0, target_error = 0.01;
  std::optional<double> elevation, field_of_view;
  bool full_float = false, no_sun = false, spectral = false;
  std::string sensor;
};

constexpr int cube_faces = 6;
constexpr Interval legal_size{1, 65'536, "pixels"}, legal_face{1, 4096, "pixels"};

Camera make_camera(const SkyOptions& options) {
  const Lens& lens = lens_named("--projection", options.projection);
  const bool cube = lens.projection == Projection::cube;
  const Interval& legal = cube ? legal_face : legal_size;
  Camera camera;
  camera.projection = lens.projection;
  const Size size = options.size.empty() ? Size{lens.width, {}} : parse_size(options.size, "--size", legal);
  camera.width = size.width;
  camera.height = size.height.value_or(std::max(1, int(std::lround(camera.width * lens.height_over_width))));
  if (cube && camera.height != camera.width)
    throw InputError(fmt::format("--size = {}: a cube's faces are square; give one number", options.size));
  const double field_of_view = options.field_of_view.value_or(lens.field_of_view);
  check_field_of_view(lens, field_of_view);
  camera.altitude = options.altitude;
  camera.azimuth = options.azimuth * degree;
  camera.elevation = options.elevation.value_or(lens.elevation) * degree;
  camera.field_of_view = field_of_view * degree;
  return camera;
}

Metadata make_metadata(const SkyOptions& options, const Sky& sky, const Camera& camera, const SunPlace& sun,
                       std::span<const double> wavelengths) {
  const ModelInfo model = model_info(sky.model());
  const auto four = sky.realtime_wavelengths();
  if (wavelengths.empty()) wavelengths = four;
  if (model.colours) wavelengths = model.colours->wavelengths;
  std::string list;
  for (const double wavelength : wavelengths) list += fmt::format("{}{:g}", list.empty() ? "" : " ", wavelength);
  Metadata metadata{{"Software", version()},
                    {"atmosphere", sky.atmosphere().name},
                    {"model", std::string(sky.model())},
                    {"engine", describe(sky.engine())},
                    {"units", "cd m-2, linear sRGB primaries"},
                    {"wavelengths [nm]", list.empty() ? "none" : list}};
  for (const auto& [name, value] : sky.parameters())
    metadata.push_back({fmt::format("{}.{}", sky.model(), name), parameter_text(value)});
  sun.describe(metadata);
  metadata.push_back({"sun disc", options.no_sun ? "left out" : "included"});
  metadata.push_back({"projection", options.projection});
  if (camera.projection == Projection::cube)
    metadata.push_back({"faces, left to right", "east west north south up down"});
  metadata.push_back({"camera altitude [m]", camera.altitude});
  metadata.push_back({"camera azimuth [degrees]", camera.azimuth / degree});
  metadata.push_back({"camera elevation [degrees]", camera.elevation / degree});
  metadata.push_back({"field of view [degrees]", camera.field_of_view / degree});
  const AirOverrides& air = options.air.overrides;
  if (air.aerosol_optical_depth) metadata.push_back({"aerosol optical depth at 550 nm", *air.aerosol_optical_depth});
  if (air.angstrom) metadata.push_back({"Angstrom exponent", *air.angstrom});
  if (air.ozone) metadata.push_back({"ozone [Dobson units]", *air.ozone});
  return metadata;
}

using Strip = std::function<bool(int begin, int end, std::span<const float> values)>;
/// Draws what one camera sees, strip by strip.
using Draw = std::function<bool(const Camera& camera, const Strip& strip)>;

/// The lights that --light names, beside a sun.
/// @param air  with its sun at one astronomical unit
std::vector<LitSky> make_lights(const SkyOptions& options, const Atmosphere& air, const Sky& sky,
                                const std::shared_ptr<Engine>& engine) {
  SceneSun sun;
  if (!options.sun.place.empty()) {
    sun.place = parse_place(options.sun.place);
    sun.time = parse_time(options.sun.time);
    sun.refraction = options.sun.refraction;
  }
  std::vector<SceneLight> lights;
  for (const std::string& keys : options.lights) {
    lights.push_back(parse_light(keys, "--light", sun));
    if (lights.back().place.time && !lights.back().place.place && !sun.place)
      throw InputError("--light: time without place; give place, too, or --place");
  }
  return lit_skies(lights, air, sun.place.value_or(Place{}), sky, engine);
}

/// The sum of two pictures, of which the first comes in strips; their fourth channel is the first one's where it is no light.
/// @param second  whole
Strip plus(const std::vector<float>& second, int width, std::size_t channels, bool spectral, const Strip& strip) {
  return [&second, width, channels, spectral, strip, sum = std::vector<float>()](int begin, int end,
                                                                                 std::span<const float> first) mutable {
    sum.assign(first.begin(), first.end());
    const float* more = second.data() + std::size_t(begin) * std::size_t(width) * channels;
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (spectral || i % channels != 3) sum[i] += more[i];
    return strip(begin, end, sum);
  };
}

/// The six faces side by side; they come one after the other and are woven into rows here.
bool render_cube(const Draw& draw, Camera camera, std::size_t channels, const Strip& strip,
                 const std::function<bool(double)>& go_on) {
  const std::size_t face_row = std::size_t(camera.width) * channels, row = face_row * cube_faces;
  std::vector<float> whole(row * camera.height);
  for (camera.face = 0; camera.face < cube_faces; ++camera.face) {
    const auto weave = [&](int begin, int end, std::span<const float> values) {
      for (int y = begin; y < end; ++y)
        std::copy_n(values.begin() + (y - begin) * face_row, face_row,
                    whole.begin() + y * row + camera.face * face_row);
      return go_on((camera.face + double(end) / camera.height) / cube_faces);
    };
    if (!draw(camera, weave)) return false;
  }
  return strip(0, camera.height, whole);
}

#ifdef AIRLIGHT_WITH_REFERENCE
/// Random walks in place of a model: slow, without the sun's disc, with errors.
int run_reference(const SkyOptions& options, const Camera& camera, const PictureFormat& format) {
  const SunPlace sun = options.sun.resolve();
  ReferenceSky sky;
  sky.atmosphere = options.air.load();
  sun.apply_distance(sky.atmosphere);
  sky.camera = camera;
  sky.sun = sun.direction();
  sky.wavelengths = picture_wavelengths(options.wavelengths);
  sky.target_error = options.target_error;
  sky.outputs = options.outputs;
  sky.format = format;
  sky.metadata = {{"Software", version()},
                  {"atmosphere", sky.atmosphere.name},
                  {"model", "reference"},
                  {"units", "cd m-2, linear sRGB primaries"},
                  {"sun disc", "left out"},
                  {"projection", options.projection},
                  {"camera altitude [m]", camera.altitude},
                  {"camera azimuth [degrees]", camera.azimuth / degree},
                  {"camera elevation [degrees]", camera.elevation / degree},
                  {"field of view [degrees]", camera.field_of_view / degree}};
  if (camera.projection == Projection::cube)
    sky.metadata.push_back({"faces, left to right", "east west north south up down"});
  sun.describe(sky.metadata);
  return render_reference_sky(std::move(sky));
}
#endif

int run_sky(const SkyOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  // Everything that can be wrong with the words is found before any work is done or any file is touched.
  const Camera camera = make_camera(options);
  PictureFormat format = picture_format(options.exposure.empty() ? "auto" : options.exposure,
                                        options.tone.empty() ? "filmic" : options.tone, options.full_float);
#ifdef AIRLIGHT_WITH_REFERENCE
  if (options.machine.model == "reference") {
    if (!options.lights.empty()) throw InputError("--light: model reference knows one light, its sun");
    return run_reference(options, camera, format);
  }
#endif
  const PictureOptions picture{!options.no_sun, picture_wavelengths(options.wavelengths)};
  options.machine.check_model();
  const SunPlace sun = options.sun.resolve(options.own.sun_elevation(options.machine.model));
  const Atmosphere air = options.air.load();
  Atmosphere atmosphere = air;
  sun.apply_distance(atmosphere);
  Parameters own_parameters = options.own.parameters();
  read_pictures(options.machine.model, own_parameters);
  const std::shared_ptr<Engine> engine = options.machine.make();
  const Sky sky(atmosphere, options.machine.model, engine, own_parameters);
  const std::vector<LitSky> lights = make_lights(options, air, sky, engine);
  tell_warnings(sky.warnings());
  if (const auto own = own_display(sky.model(), sky.parameters()))
    format = picture_format(options.exposure.empty() ? own->exposure : options.exposure,
                            options.tone.empty() ? own->tone : options.tone, options.full_float);

  const bool cube = camera.projection == Projection::cube;
  Metadata metadata = make_metadata(options, sky, camera, sun, picture.wavelengths);
  describe(lights, metadata);
  std::optional<SpectralColours> spectral;
  if (options.spectral || !options.sensor.empty()) {
    spectral.emplace(sky, picture.wavelengths, options.sensor, options.spectral);
    spectral->describe(metadata);
    format.layers = spectral->channels();
  }
  PictureOutputs files(options.outputs, camera.width * (cube ? cube_faces : 1), camera.height, format, metadata);

  {
    Progress progress("sky");
    const auto go_on = [&](double fraction) {
      progress.show(fraction);
      return !interrupted();
    };
    const auto write = [&](int begin, int end, std::span<const float> values) {
      if (spectral)
        spectral->write(files, begin, end, values);
      else
        files.write(begin, end, values);
      return go_on(double(end) / camera.height);
    };
    const std::size_t channels = spectral ? spectral->wavelengths().size() : 4;
    const auto draw_one = [&](const Sky& lit, const Direction& light, const Camera& one, const Strip& strip) {
      return spectral ? lit.render_spectral(one, light, picture, strip) : lit.render(one, light, picture, strip);
    };
    const auto draw = [&](const Camera& one, const Strip& strip) {
      if (lights.empty()) return draw_one(sky, sun.direction(), one, strip);
      std::vector<float> others(std::size_t(one.width) * std::size_t(one.height) * channels);
      for (const LitSky& light : lights) {
        const auto add = [&](int begin, int, std::span<const float> values) {
          float* sum = others.data() + std::size_t(begin) * std::size_t(one.width) * channels;
          for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
          return !interrupted();
        };
        if (!draw_one(light.sky, light.direction(), one, add)) return false;
      }
      return draw_one(sky, sun.direction(), one, plus(others, one.width, channels, spectral.has_value(), strip));
    };
    const bool whole = cube ? render_cube(draw, camera, channels, write, go_on) : draw(camera, write);
    if (!whole) throw Interrupted{};
    check_interrupt();
  }
  files.finish();

  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  fmt::print(stderr, "{}: {} x {}, {}, {} on {}, sun at azimuth {:.2f}, elevation {:.2f} degrees{}; {:.2f} s\n",
             files.names(), camera.width * (cube ? cube_faces : 1), camera.height, sky.atmosphere().name, sky.model(),
             describe(sky.engine()), sun.azimuth, sun.elevation, sun.refraction ? " with refraction" : "", seconds);
  files.tell_notes();
  return ok;
}

}  // namespace

void add_sky(CommandLine& line) {
  const auto options = std::make_shared<SkyOptions>();
  const Verb sky = line.verb("sky", "A picture of the sky for a place and time, or for a sun's position");
  const char* const camera = "Camera";
  const char* const picture = "Picture";
  sky.option("-o,--output", options->outputs,
             "picture to write: .exr and .hdr linear in cd/m2, .png tone-mapped; may be repeated")
      .required()
      .one_value_each()
      .type_name("FILE");
  sky.option("--projection", options->projection,
             "equirectangular, fisheye (equidistant), perspective, or cube: six faces side by side, east west "
             "north south up down "
             "(default equirectangular)")
      .group(camera)
      .type_name("NAME");
  sky.option("--size", options->size,
             "pixels, 1 .. 65536 a side, or the width alone; cube: of one face, 1 .. 4096 (default 2048x1024, "
             "fisheye 1024, cube 512, "
             "perspective 1280x720)")
      .group(camera)
      .type_name("WxH");
  sky.number("--altitude", options->altitude, {lowest_altitude, highest_altitude, "m"}, "camera above the ground")
      .group(camera);
  sky.number("--camera-azimuth", options->azimuth, {-360, 360, "degrees"},
             "middle of the picture, from north, clockwise")
      .group(camera);
  sky.number("--camera-elevation", options->elevation, {-90, 90, "degrees"},
             "axis of fisheye and perspective above the horizon (default 0, fisheye 90)")
      .group(camera);
  sky.number("--field-of-view", options->field_of_view, {0.1, 360, "degrees"},
             "perspective: horizontal, up to 170 (default 90); fisheye: across the circle, from 1 (default 180)")
      .group(camera);
  sky.option(
         "--exposure", options->exposure,
         "of a .png: auto, or EV, by which 1 cd/m2 is brightened by 2^EV [EV, -100 .. 100] (default auto; a published "
         "system's own)")
      .group(picture)
      .type_name("EV");
  sky.option("--tone", options->tone,
             "tone curve of a .png: filmic, reinhard, clip, codeflow, sqrt, exponential (default filmic; a "
             "published system's own)")
      .group(picture)
      .type_name("NAME");
  sky.flag("--float", options->full_float, "32-bit .exr in place of half floats, which end at 65504 cd/m2")
      .group(picture);
  sky.flag("--no-sun", options->no_sun, "leave the sun's disc out").group(picture);
  for (const Option& option : add_spectral_options(sky, options->wavelengths, options->spectral, options->sensor))
    option.group(picture);
  sky.number("--target-error", options->target_error, {1e-4, 1, ""},
             "--model reference: walk until the median pixel's standard error / luminance is below")
      .group(picture);
  options->sun.add_to(sky);
  sky.option(
         "--light", options->lights,
         "another light, by the keys of [[light]] in docs/scene_file.md: 'body = \"moon\"' with --place and --time, or "
         "'body = \"moon\", elevation = 30, azimuth = 120, phase = 20'; may be repeated")
      .one_value_each()
      .group("Sun")
      .type_name("KEYS");
  options->air.add_to(sky);
  options->machine.add_to(sky);
  options->own.add_to(sky);
  sky.runs([options] { return run_sky(*options); });
}

}  // namespace airlight::cli
