// `airlight haze`: air over a picture that another renderer made.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <filesystem>
#include <functional>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "haze_input.h"
#include "haze_options.h"
#include "interrupt.h"
#include "lens.h"
#include "model_options.h"
#include "number.h"
#include "picture_outputs.h"
#include "progress.h"
#include "render/air_shadows.h"
#include "render/haze_picture.h"
#include "render/scene_renderer.h"
#include "scenefile/scene_file.h"
#include "shaded_air.h"

namespace airlight::cli {
namespace {

/// One of a scene's lights.
struct LightOverLand {
  PlacedLight light;
  Direction direction, at_eye;  // towards it, in the scene's frame and the eye's
};

/// All that surrounds the picture: where it was seen from, in which air and light.
struct Surroundings {
  HazeView view;
  HazeSettings settings;
  Atmosphere air;
  SunPlace sun;
  std::string model;
  std::optional<std::array<double, 3>> eye;  // in the file's axes and unit
  std::vector<LightOverLand> more_lights;
  /// Those of the scene's land in a light of that angular radius [rad]; empty: there is no land, or they are not wanted.
  std::function<AirShadows(const Direction& towards, double angular_radius)> cast_shadows;
  std::optional<bool> asked_shadows;
};

/// The model that is asked for, or else the usual one.
std::string model_for(const HazeOptions& options, const std::string& usual) {
  const std::string name = options.model.empty() ? usual : options.model;
  if (!model_info(name).colours) return name;
  std::string able;
  for (const ModelInfo& model : models())
    if (!model.colours) able += fmt::format("{}{}", able.empty() ? "" : ", ", model.name);
  throw InputError(fmt::format(
      "model {}: draws in red, green and blue, haze asks for light at wavelengths; expected one of {}", name, able));
}

/// The file's point in the scene's frame [m], and back.
Position to_scene(const std::array<double, 3>& p, UpAxis up, double unit) {
  return up == UpAxis::z ? Position{p[0] * unit, p[1] * unit, p[2] * unit}
                         : Position{p[0] * unit, -p[2] * unit, p[1] * unit};
}
std::array<double, 3> from_scene(const Position& p, UpAxis up, double unit) {
  return up == UpAxis::z ? std::array{p[0] / unit, p[1] / unit, p[2] / unit}
                         : std::array{p[0] / unit, p[2] / unit, -p[1] / unit};
}

/// Pixels of the picture; a cube's are those of one face.
void set_size(Camera& camera, const InputPicture& picture) {
  camera.width = picture.width;
  camera.height = picture.height;
  if (camera.projection != Projection::cube) return;
  if (picture.width != 6 * picture.height)
    throw InputError(fmt::format("'{}' is {} x {} pixels: a cube is six square faces side by side", picture.path,
                                 picture.width, picture.height));
  camera.width = picture.height;
}

void check_kind(DepthKind kind, const Camera& camera) {
  const bool lens = camera.projection == Projection::perspective || camera.projection == Projection::cube;
  if (lens || kind == DepthKind::distance || kind == DepthKind::position) return;
  throw InputError(
      "--depth-kind: along the camera's axis depth ends at the side; fisheye and equirectangular pictures "
      "have distance or position");
}

Surroundings plain_surroundings(const HazeOptions& options, const InputPicture& picture) {
  Surroundings s;
  Camera camera;
  s.sun = options.sun.resolve();
  s.air = options.air.load();
  if (options.exr_camera) {
    camera.field_of_view = options.field_of_view.value_or(0) * degree;
    if (!options.field_of_view && picture.world_to_camera && !picture.world_to_ndc)
      throw InputError("--exr-camera: '" + picture.path + "' has worldToCamera alone: give --field-of-view [degrees]");
    if (options.field_of_view) check_field_of_view(lens_of(Projection::perspective), *options.field_of_view);
    set_size(camera, picture);
    s.view = haze_view(picture, options.up(), options.north * degree, camera);
    s.settings.altitude = options.altitude.value_or(s.view.eye_height * options.unit);
    s.eye = s.view.eye;
  } else {
    options.change(camera, true);
    set_size(camera, picture);
    s.view = haze_view(camera);
    s.settings.altitude = options.altitude.value_or(2);
  }
  s.settings.sun = s.sun.direction();
  s.model = model_for(options, "skyview");
  return s;
}

Surroundings scene_surroundings(const HazeOptions& options, const InputPicture& picture) {
  Surroundings s;
  Scene scene = load_scene(options.scene);
  s.air = scene.air;
  s.model = model_for(options, scene.picture.model);
  const auto shared_land = std::make_shared<const Land>(scene.land);
  const Land& land = *shared_land;
  PlacedCamera placed;
  if (options.exr_camera) {
    Camera camera = scene.camera.camera;
    if (options.field_of_view) camera.field_of_view = *options.field_of_view * degree;
    set_size(camera, picture);
    s.view = haze_view(picture, options.up(), options.north * degree, camera);
    s.eye = s.view.eye;
    placed.camera = s.view.camera;
    placed.eye = to_scene(*s.eye, options.up(), options.unit);
    placed.axes = land.frame().axes(placed.eye);
    // The file's axes are the scene's, which are not quite level where the eye is.
    s.view.look = [look = s.view.look, placed](double u, double v) {
      auto line = look(u, v);
      if (line) line->view = placed.from_scene(line->view);
      return line;
    };
  } else {
    options.change(scene.camera.camera, false);
    if (options.azimuth || options.elevation) scene.camera.target.reset();
    if (options.altitude) scene.camera.altitude = options.altitude;
    set_size(scene.camera.camera, picture);
    placed = place_camera(scene.camera, land);
    s.view = haze_view(placed.camera);
    s.eye = from_scene(placed.eye, options.up(), options.unit);
  }
  s.settings.altitude = land.frame().altitude(placed.eye);
  const SunPosition sun = sun_of(scene.sun, land.origin());
  s.sun.azimuth = sun.azimuth / degree;
  s.sun.elevation = sun.elevation / degree;
  s.sun.distance = sun.distance;
  s.settings.sun = placed.from_scene(s.sun.direction());
  for (const SceneLight& light : scene.lights) {
    const PlacedLight there = place_light(light, s.air.sun, land.origin());
    const Direction towards = direction(there.azimuth, there.elevation);
    s.more_lights.push_back({there, towards, placed.from_scene(towards)});
  }
  s.asked_shadows = options.no_air_shadows ? false : scene.picture.air_shadows;
  if (!scene.has_land || s.asked_shadows == false) return s;
  s.cast_shadows = [shared_land, placed](const Direction& towards, double angular_radius) {
    ShadowGrid grid;
    grid.east = placed.eye[0];
    grid.north = placed.eye[1];
    return air_shadows(shadow_map(*shared_land, towards, angular_radius, grid), placed, SceneOptions{}.shadow_steps);
  };
  return s;
}

/// "depth 12.5 .. 40210 m, 31 % sky"
std::string describe_depth(const std::vector<float>& distance) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  std::size_t sky = 0;
  for (const float d : distance) {
    sky += std::isinf(d);
    if (std::isinf(d)) continue;
    nearest = std::min(nearest, d);
    farthest = std::max(farthest, d);
  }
  const double part = 100 * double(sky) / double(distance.size());
  if (sky == distance.size()) return "no depth, all sky";
  return fmt::format("depth {:.6g} .. {:.6g} m, {:.0f} % sky", nearest, farthest, part);
}

/// A render is not made twice: its haze goes into another file.
void check_outputs(const HazeOptions& options) {
  for (const std::string& output : options.outputs) {
    for (const auto& [option, read] : {std::pair{"--color", options.color}, {"--depth-file", options.depth_file}}) {
      std::error_code none;
      if (std::filesystem::equivalent(output, read, none))
        throw InputError(fmt::format("-o {}: is the file that {} reads; expected another", output, option));
    }
  }
}

int run_haze(const HazeOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  // Everything that can be wrong with the words is found before any work is done or any file is touched.
  check_outputs(options);
  DepthMeaning meaning = options.depth_meaning();
  const bool bad_is_sky = options.bad_depth_is_sky();
  PictureFormat format = picture_format(options.exposure, options.tone, options.full_float);
  if (!options.model.empty()) check_model_name(options.model, "--model", model_names());
  HazeInput input(options, meaning.kind);
  const InputPicture& picture = input.picture();
  Surroundings s = options.scene.empty() ? plain_surroundings(options, picture) : scene_surroundings(options, picture);
  s.settings.fill_sky = options.fill_sky();
  s.settings.sun_disc = !options.no_sun;
  check_kind(meaning.kind, s.view.camera);
  if (const auto eye = options.eye_position()) s.eye = eye;
  if (meaning.kind == DepthKind::position && !s.eye)
    throw InputError("--depth-kind position needs --eye X,Y,Z, --exr-camera or --scene");
  meaning.eye = s.eye.value_or(meaning.eye);
  s.sun.apply_distance(s.air);
  const auto engine = engine_named(options.engine);
  const auto sky_of = [&](const Sun& sun) {
    Atmosphere air = s.air;
    air.sun = sun;
    return Sky(std::move(air), s.model, engine);
  };
  const Sky sky = sky_of(s.air.sun);
  const bool shaded = s.cast_shadows && shades_air(sky, s.settings.altitude, s.asked_shadows);
  if (s.cast_shadows && !shaded) tell_warnings({unshaded_note(sky)});
  std::vector<Sky> more_skies;
  for (const LightOverLand& more : s.more_lights) more_skies.push_back(sky_of(more.light.source));

  std::vector<float> distance = input.read_distance(meaning, s.view, bad_is_sky);
  std::vector<float> rgba = input.read_color(options.scale);
  mend_edges(picture.width, picture.height, distance, rgba);

  std::deque<AirShadows> shadows;  // which stay where they are
  const auto shadows_in = [&](const Sky& lit, const Direction& towards) -> const AirShadows* {
    if (!shaded) return nullptr;
    return &shadows.emplace_back(s.cast_shadows(towards, lit.atmosphere().sun.angular_radius));
  };
  s.settings.shadows = shadows_in(sky, s.sun.direction());
  for (std::size_t i = 0; i < more_skies.size(); ++i) {
    const LightOverLand& more = s.more_lights[i];
    s.settings.more_lights.push_back({&more_skies[i], more.at_eye, shadows_in(more_skies[i], more.direction)});
  }

  if (input.has_alpha()) format.layers = {"A"};
  Metadata metadata{{"Software", version()},
                    {"haze over", options.color},
                    {"atmosphere", sky.atmosphere().name},
                    {"model", std::string(sky.model())},
                    {"engine", describe(sky.engine())},
                    {"units", "cd m-2, linear sRGB primaries"},
                    {"camera altitude [m]", s.settings.altitude}};
  s.sun.describe(metadata);
  {
    const HazePicture haze(sky, s.view, s.settings);
    PictureOutputs files(options.outputs, picture.width, picture.height, format, metadata);
    Progress progress("haze");
    constexpr int pixels_at_once = 1 << 16;
    const int step = std::max(1, pixels_at_once / picture.width);
    const auto width = std::size_t(picture.width);
    for (int begin = 0; begin < picture.height; begin += step) {
      const int end = std::min(begin + step, picture.height);
      const std::size_t first = width * std::size_t(begin), count = width * std::size_t(end - begin);
      const auto strip = std::span(rgba).subspan(4 * first, 4 * count);
      haze.rows(begin, std::span(distance).subspan(first, count), strip);
      std::vector<LayerRows> alpha;
      if (input.has_alpha()) alpha.push_back({strip.data() + 3, 4});
      files.write(begin, end, strip, alpha);
      progress.show(double(end) / picture.height);
      check_interrupt();
    }
    files.finish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    fmt::print(stderr, "{}: {} x {}, {}, {}, {} on {}, sun at azimuth {:.2f}, elevation {:.2f} degrees; {:.2f} s\n",
               files.names(), picture.width, picture.height, describe_depth(distance), sky.atmosphere().name,
               sky.model(), describe(sky.engine()), s.sun.azimuth, s.sun.elevation, seconds);
    for (const std::string& note : input.notes()) fmt::print(stderr, "{}: {}\n", picture.path, note);
    files.tell_notes();
  }
  return ok;
}

}  // namespace

void add_haze(CommandLine& line) {
  const auto options = std::make_shared<HazeOptions>();
  const Verb haze = line.verb("haze", "Air over a picture with depth that another renderer made");
  options->add_to(haze);
  haze.runs([options] { return run_haze(*options); });
}

}  // namespace airlight::cli
