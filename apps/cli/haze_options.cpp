#include "haze_options.h"

#include <fmt/core.h>

#include "airlight/error.h"
#include "lens.h"
#include "number.h"
#include "picture_outputs.h"

namespace airlight::cli {
namespace {

// Renderers mark the sky with numbers like 1e10 (Blender), which no scene reaches.
constexpr double far_away = 1e9;

const std::vector<std::string_view> depth_kinds{"z", "distance", "position", "buffer", "reversed", "logarithmic"};

}  // namespace

DepthMeaning HazeOptions::depth_meaning() const {
  DepthMeaning meaning;
  meaning.kind = static_cast<DepthKind>(choose("--depth-kind", depth_kind, depth_kinds));
  meaning.unit = unit;
  const bool zbuffer = meaning.kind == DepthKind::buffer || meaning.kind == DepthKind::reversed;
  const bool logarithmic = meaning.kind == DepthKind::logarithmic;
  if (near && !zbuffer && !logarithmic)
    throw InputError(fmt::format("--near has no meaning for --depth-kind {}", depth_kind));
  if (constant && !logarithmic)
    throw InputError(fmt::format("--log-constant has no meaning for --depth-kind {}", depth_kind));
  if (zbuffer && !near) throw InputError(fmt::format("--depth-kind {} needs --near [units of the file]", depth_kind));
  if (logarithmic && !(far && near.has_value() != constant.has_value()))
    throw InputError("--depth-kind logarithmic needs --far, and either --near or --log-constant");
  meaning.near = near.value_or(0);
  meaning.constant = constant.value_or(0);
  meaning.far = far.value_or(zbuffer ? std::numeric_limits<double>::infinity() : far_away);
  if (meaning.near >= meaning.far)
    throw InputError(fmt::format("--near = {:g}: expected less than --far = {:g}", meaning.near, meaning.far));
  return meaning;
}

UpAxis HazeOptions::up() const { return choose("--up-axis", up_axis, {"y", "z"}) == 0 ? UpAxis::y : UpAxis::z; }
bool HazeOptions::fill_sky() const { return choose("--sky", sky, {"fill", "leave"}) == 0; }
bool HazeOptions::bad_depth_is_sky() const { return choose("--bad-depth", bad_depth, {"error", "sky"}) == 1; }

std::optional<std::array<double, 3>> HazeOptions::eye_position() const {
  if (eye.empty()) return {};
  const std::vector<std::string_view> numbers = comma_separated(eye);
  if (numbers.size() != 3) throw InputError(fmt::format("--eye = {}: expected three numbers, X,Y,Z", eye));
  std::array<double, 3> position{};
  for (std::size_t i = 0; i < 3; ++i) position[i] = parse_number(numbers[i], "--eye", {-1e15, 1e15, "units"});
  return position;
}

void HazeOptions::change(Camera& camera, bool complete) const {
  if (!projection.empty() || complete) {
    const Lens& lens = lens_named("--projection", projection.empty() ? "perspective" : projection);
    camera.projection = lens.projection;
    // No usual view is taken for granted: the picture is there already.
    if (!field_of_view && !lens.has_one_view())
      throw InputError(
          fmt::format("which lens? Give --field-of-view (of {}) [degrees, {:g} .. {:g}], --exr-camera or --scene",
                      lens.name, lens.legal_view.low, lens.legal_view.high));
    camera.field_of_view = lens.field_of_view * degree;
    camera.elevation = lens.elevation * degree;
  }
  if (field_of_view) {
    check_field_of_view(lens_of(camera.projection), *field_of_view);
    camera.field_of_view = *field_of_view * degree;
  }
  if (azimuth) camera.azimuth = *azimuth * degree;
  if (elevation) camera.elevation = *elevation * degree;
  if (roll) camera.roll = *roll * degree;
}

void HazeOptions::add_to(const Verb& verb) {
  const char* const picture = "Picture";
  const char* const lens = "Camera";
  const char* const output = "Output";
  verb.option("--color", color, "finished picture, linear sRGB: .exr, or what else OpenImageIO reads")
      .required()
      .type_name("FILE");
  verb.option("-o,--output", outputs,
              "picture to write: .exr and .hdr linear in cd/m2, .png tone-mapped; may be repeated")
      .required()
      .one_value_each()
      .type_name("FILE");

  verb.option("--color-channels", color_channels,
              "names as in R,G,B or R,G,B,A, or a layer: LAYER.R, .G, .B and, where there is one, .A (default R,G,B "
              "with A)")
      .group(picture)
      .type_name("LIST");
  verb.number("--exposure-of-color", scale, {1e-9, 1e9, "cd/m2"}, "luminance of a white of 1 in the picture")
      .group(picture);
  verb.option("--depth", depth,
              "channel that holds depth (default Z); for positions three, or a layer: LAYER.X, .Y, .Z")
      .group(picture)
      .type_name("NAME");
  verb.option("--depth-file", depth_file, "where it is, if not beside the colour").group(picture).type_name("FILE");
  verb.option("--depth-kind", depth_kind,
              "z (along the camera's axis), distance, position, buffer (0 near, 1 far), reversed (1 near, 0 far), "
              "logarithmic (default z)")
      .group(picture)
      .type_name("NAME");
  verb.number("--unit", unit, {1e-9, 1e15, "m"}, "length of the file's unit").group(picture);
  verb.number("--near", near, {1e-12, 1e15, "units"}, "of buffer, reversed and logarithmic").group(picture);
  verb.number("--far", far, {1e-12, 1e15, "units"}, "the sky begins here (default 1e9; buffer and reversed: infinite)")
      .group(picture);
  verb.number("--log-constant", constant, {1e-12, 1e12, "1/units"},
              "C of a logarithmic depth log(C z + 1) / log(C far + 1), in place of --near")
      .group(picture);
  verb.option("--bad-depth", bad_depth, "NaN and negative depth: error, or sky (default error)")
      .group(picture)
      .type_name("WHAT");
  verb.option("--sky", sky, "pixels without depth: fill with the sky, or leave (default fill)")
      .group(picture)
      .type_name("WHAT");

  verb.option("--projection", projection, "perspective, fisheye, equirectangular, cube (default perspective)")
      .group(lens)
      .type_name("NAME");
  verb.number("--field-of-view", field_of_view, {0.1, 360, "degrees"},
              "perspective: horizontal, up to 170; fisheye: across the circle, from 1")
      .group(lens);
  verb.number("--camera-azimuth", azimuth, {-360, 360, "degrees"},
              "middle of the picture, from north, clockwise (default 0)")
      .group(lens);
  verb.number("--camera-elevation", elevation, {-90, 90, "degrees"}, "axis above the horizon (default 0, fisheye 90)")
      .group(lens);
  verb.number("--camera-roll", roll, {-360, 360, "degrees"}, "camera's turn about its axis, right side up (default 0)")
      .group(lens);
  verb.number("--altitude", altitude, {lowest_altitude, highest_altitude, "m"}, "camera above the ground (default 2)")
      .group(lens);
  const Option exr =
      verb.flag("--exr-camera", exr_camera, "camera from the picture's worldToNDC or worldToCamera").group(lens);
  for (const char* angle : {"--projection", "--camera-azimuth", "--camera-elevation", "--camera-roll"})
    exr.excludes(verb.find(angle));
  verb.option("--up-axis", up_axis, "of the file's world: y or z (default z)").group(lens).type_name("AXIS");
  verb.number("--north", north, {-360, 360, "degrees"}, "azimuth of the file's y (up z) or -z (up y), for --exr-camera")
      .group(lens);
  verb.option("--eye", eye, "camera in the file's axes and unit, for positions").group(lens).type_name("X,Y,Z");

  sun.add_to(verb);
  air.add_to(verb);
  const Option scene_option = verb.option("--scene", scene,
                                          "air, sun, camera and land of a scene file in place of these options; land "
                                          "casts shadows into the air where the model can")
                                  .group("Air")
                                  .type_name("FILE");
  for (const char* name : {"--planet", "--aerosol-optical-depth", "--angstrom", "--ozone", "--place", "--time",
                           "--sun-elevation", "--sun-azimuth"})
    scene_option.excludes(verb.find(name));
  verb.flag("--no-air-shadows", no_air_shadows, "the scene's land casts no shadows into the air").group("Air");
  verb.option("--model", model, "model of the sky (default skyview, or the scene's)")
      .group("Model and engine")
      .type_name("NAME");
  add_engine(verb, engine);

  verb.option("--exposure", exposure,
              "of a .png: auto, or EV, by which 1 cd/m2 is brightened by 2^EV [EV, -100 .. 100] (default auto)")
      .group(output)
      .type_name("EV");
  verb.option("--tone", tone,
              "tone curve of a .png: filmic, reinhard, clip, codeflow, sqrt, exponential (default filmic)")
      .group(output)
      .type_name("NAME");
  verb.flag("--float", full_float, "32-bit .exr in place of half floats, which end at 65504 cd/m2").group(output);
  verb.flag("--no-sun", no_sun, "leave the sun's disc out of a filled sky").group(output);
}

}  // namespace airlight::cli
