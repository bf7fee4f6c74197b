#include "scene_render.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "airlight/error.h"
#include "blended_frames.h"
#include "commands.h"
#include "interrupt.h"
#include "model/model.h"
#include "number.h"
#include "optics/colour.h"
#include "parameter_pictures.h"
#include "shaded_air.h"

namespace airlight::cli {
namespace {

constexpr std::string_view spectral_layer = "spectral";

const std::vector<Layer>& all_layers() {
  const auto rgb = [](const char* name) {
    return std::vector<std::string>{fmt::format("{}.R", name), fmt::format("{}.G", name), fmt::format("{}.B", name)};
  };
  const auto xyz = [](const char* name) {
    return std::vector<std::string>{fmt::format("{}.X", name), fmt::format("{}.Y", name), fmt::format("{}.Z", name)};
  };
  const auto nm = [](const char* name) {
    std::vector<std::string> channels;
    for (const double wavelength : realtime_quad) channels.push_back(fmt::format("{}.{:g}nm", name, wavelength));
    return channels;
  };
  static const std::vector<Layer> all{{"surface", rgb("surface"), &SceneRows::surface},
                                      {"transmittance", rgb("transmittance"), &SceneRows::transmittance},
                                      {"inscatter", rgb("inscatter"), &SceneRows::inscatter},
                                      {"depth", {"Z"}, &SceneRows::depth},
                                      {"position", xyz("position"), &SceneRows::position},
                                      {"normal", xyz("normal"), &SceneRows::normal},
                                      {"albedo", rgb("albedo"), &SceneRows::albedo},
                                      {"sun_visibility", {"sun_visibility"}, &SceneRows::sun_visibility},
                                      {"sky_irradiance", rgb("sky_irradiance"), &SceneRows::sky_irradiance},
                                      {spectral_layer, nm("surface"), &SceneRows::spectral_surface},
                                      {spectral_layer, nm("transmittance"), &SceneRows::spectral_transmittance},
                                      {spectral_layer, nm("inscatter"), &SceneRows::spectral_inscatter}};
  return all;
}

SunPlace sun_place(const Scene& scene, const Land& land) {
  const SunPosition sun = sun_of(scene.sun, land.origin());
  SunPlace place;
  place.azimuth = sun.azimuth / degree;
  place.elevation = sun.elevation / degree;
  place.distance = sun.distance;
  return place;
}

Sky make_sky(const Scene& scene, const SunPlace& sun, std::shared_ptr<Engine> engine) {
  Atmosphere air = scene.air;
  sun.apply_distance(air);
  const auto own = scene.parameters.find(scene.picture.model);
  return Sky(std::move(air), scene.picture.model, std::move(engine),
             own == scene.parameters.end() ? Parameters{} : own->second);
}

/// A published system that answers in colours draws the sky of a scene without land by itself, through its camera.
bool draws_sky_alone(const Scene& scene) {
  const Model& model = find_model(scene.picture.model);
  if (!model.colours) return false;
  if (scene.has_land) {
    if (!model.surface.empty()) return false;
    throw InputError(
        fmt::format("model {}: draws the sky alone; expected a scene without terrain and relief", model.name));
  }
  if (scene.camera.camera.projection == Projection::cube)
    throw InputError(
        fmt::format("model {}: camera.type = cube: expected perspective, equirectangular or fisheye", model.name));
  return true;
}

SceneOptions scene_options(const Scene& scene, bool shaded, bool sun_disc, const std::vector<double>& wavelengths) {
  SceneOptions how;
  how.wavelengths = wavelengths;
  how.samples = scene.picture.samples;
  how.air_shadows = shaded;
  how.soft_shadows = scene.picture.soft_shadows;
  how.sun_disc = sun_disc;
  how.triangle_pixels = scene.detail;
  return how;
}

}  // namespace

constexpr char instead[] = "Instead of what the scene says";

void ScenePictureOptions::add_picture_to(const Verb& verb) {
  verb.option("--size", size, "pixels, 1 .. 16384 a side, or the width alone").group(instead).type_name("WxH");
  verb.option("--samples", samples, "rays a pixel, a square number [1 .. 256]").group(instead).type_name("N");
  verb.option("--accumulate", accumulate,
              "mean of that many frames, clouds standing still: jetlag's pictures without their noise [1 .. 65536]")
      .group(instead)
      .type_name("N");
  verb.option("--exposure", exposure,
              "of a .png: auto, or EV, by which 1 cd/m2 is brightened by 2^EV [EV, -100 .. 100]")
      .group(instead)
      .type_name("EV");
  verb.option("--tone", tone, "tone curve of a .png: filmic, reinhard, clip, codeflow, sqrt, exponential")
      .group(instead)
      .type_name("NAME");
  verb.flag("--float", full_float, "32-bit .exr in place of half floats, which end at 65504 cd/m2");
  verb.flag("--no-sun", no_sun, "leave the sun's disc out");
  add_engine(verb, engine);
}

void ScenePictureOptions::add_to(const Verb& verb) {
  verb.option("--aov", aov,
              "layers of an .exr, which then is of 32-bit floats: all, or surface,transmittance,inscatter,depth,"
              "position,normal,albedo,sun_visibility,sky_irradiance; and spectral, the first three at each of the four "
              "wavelengths")
      .type_name("LIST");
  verb.option("--model", model, "model of the sky (skyview alone has shadows in the air)")
      .group(instead)
      .type_name("NAME");
  own.add_to(verb);
  verb.flag("--no-air-shadows", no_air_shadows, "land casts no shadows into the air").group(instead);
  add_picture_to(verb);
}

void ScenePictureOptions::apply(Scene& scene) const {
  constexpr Interval legal_size{1, 16'384, "pixels"};
  Camera& camera = scene.camera.camera;
  if (!size.empty()) {
    const Size wanted = parse_size(size, "--size", legal_size);
    const double shape = double(camera.height) / camera.width;
    camera.width = wanted.width;
    camera.height = wanted.height.value_or(std::max(1, int(std::lround(camera.width * shape))));
  }
  if (samples) scene.picture.samples = *samples;
  if (no_air_shadows) scene.picture.air_shadows = false;
  if (!model.empty()) scene.picture.model = model;
  if (!tone.empty()) scene.picture.tone = tone;
  check_model_name(scene.picture.model, "--model", model_names());
  for (const auto& [name, value] : own.parameters())
    scene.parameters[scene.picture.model].insert_or_assign(name, value);
  if (const auto given = scene.parameters.find(scene.picture.model); given != scene.parameters.end())
    read_pictures(scene.picture.model, given->second);
  if (accumulate) cli::accumulate(scene, *accumulate);
}

std::vector<Layer> ScenePictureOptions::layers(const std::vector<std::string>& outputs) const {
  std::vector<Layer> chosen = named_layers();
  if (!chosen.empty() && std::ranges::none_of(outputs, PictureFile::has_layers))
    throw InputError("--aov: layers go into an .exr; expected one after -o");
  return chosen;
}

std::vector<Layer> ScenePictureOptions::named_layers() const {
  if (aov.empty()) return {};
  std::vector<std::string_view> names{"all"};
  for (const Layer& layer : all_layers())
    if (layer.name != names.back()) names.push_back(layer.name);
  std::vector<Layer> chosen;
  const auto add = [&](const auto& wanted) {
    std::ranges::copy_if(all_layers(), std::back_inserter(chosen), wanted, &Layer::name);
  };
  for (const std::string_view word : comma_separated(aov)) {
    if (word == "all") {
      add([](std::string_view name) { return name != spectral_layer; });
    } else {
      add([name = names[choose("--aov", word, names)]](std::string_view other) { return other == name; });
    }
  }
  return chosen;
}

PictureFormat ScenePictureOptions::format(const Scene& scene) const {
  const std::vector<Layer> extra = named_layers();
  const auto given = scene.parameters.find(scene.picture.model);
  const auto display = own_display(scene.picture.model, given == scene.parameters.end() ? Parameters{} : given->second);
  std::string ev = exposure, curve = scene.picture.tone;
  if (ev.empty() && scene.picture.exposure_ev) ev = fmt::format("{}", *scene.picture.exposure_ev);
  if (ev.empty()) ev = display ? display->exposure : "auto";
  if (curve.empty()) curve = display ? display->tone : "filmic";
  PictureFormat format = picture_format(ev, curve, full_float || !extra.empty());
  for (const Layer& layer : extra)
    format.layers.insert(format.layers.end(), layer.channels.begin(), layer.channels.end());
  return format;
}

SceneShot::SceneShot(const Scene& scene, std::shared_ptr<const Land> land, std::shared_ptr<Engine> engine,
                     bool sun_disc, const std::vector<double>& wavelengths)
    : sun_(sun_place(scene, *land)),
      sky_(make_sky(scene, sun_, engine)),
      more_lights_(lit_skies(scene.lights, scene.air, land->origin(), sky_, engine)),
      placed_(place_camera(scene.camera, *land)),
      sun_disc_(sun_disc),
      has_land_(scene.has_land),
      asked_shadows_(scene.picture.air_shadows),
      width_(placed_.camera.width),
      height_(scene.camera.camera.height),
      samples_(scene.picture.samples) {
  if (!draws_sky_alone(scene)) {
    // Said before the land's triangles are made.
    shaded_ = shades_air(sky_, land->frame().altitude(placed_.eye), asked_shadows_);
    SceneView view{placed_, sun_.direction()};
    for (const LitSky& more : more_lights_) view.more_lights.push_back({&more.sky, more.direction()});
    renderer_ = std::make_unique<SceneRenderer>(sky_, land, scene.surface, view,
                                                scene_options(scene, shaded_, sun_disc, wavelengths));
    width_ = renderer_->width();
  }
  metadata_ = {{"Software", version()},
               {"scene", scene.name},
               {"atmosphere", scene.air.name},
               {"model", std::string(sky_.model())},
               {"units", "cd m-2, linear sRGB primaries; channels of a wavelength W m-2 sr-1 nm-1"},
               {"samples a pixel", double(samples_)},
               {"shadows in the air", shaded_ ? "single scattering" : "none"},
               {"camera altitude [m]", land->frame().altitude(placed_.eye)},
               {"camera azimuth [degrees]", placed_.camera.azimuth / degree},
               {"camera elevation [degrees]", placed_.camera.elevation / degree},
               {"field of view [degrees]", placed_.camera.field_of_view / degree}};
  sun_.describe(metadata_);
  describe(more_lights_, metadata_);
}

std::vector<std::string> SceneShot::warnings() const {
  std::vector<std::string> all = sky_.warnings();
  if (renderer_ && has_land_ && !shaded_ && !asked_shadows_) all.push_back(unshaded_note(sky_));
  return all;
}

bool SceneShot::rows(const std::function<bool(int end, std::span<const float> rgb)>& take) const {
  if (renderer_) return renderer_->render([&](const SceneRows& strip) { return take(strip.end, strip.rgb); }, false);
  std::vector<float> rgb;
  return sky_.render(placed_.camera, placed_.from_scene(sun_.direction()), {.sun_disc = sun_disc_, .wavelengths = {}},
                     [&](int, int end, std::span<const float> rgba) {
                       rgb.clear();
                       for (std::size_t i = 0; i < rgba.size(); i += 4) rgb.insert(rgb.end(), &rgba[i], &rgba[i + 3]);
                       return take(end, rgb);
                     });
}

bool SceneShot::spectral_rows(const std::function<bool(int end, std::span<const float> radiance)>& take) const {
  if (!renderer_) throw InputError(fmt::format("--wavelengths: model {} draws in red, green and blue", sky_.model()));
  std::vector<float> radiance;
  return renderer_->render([&](const SceneRows& rows) {
    radiance.resize(rows.spectral_surface.size());
    for (std::size_t i = 0; i < radiance.size(); ++i)
      radiance[i] = rows.spectral_surface[i] * rows.spectral_transmittance[i] + rows.spectral_inscatter[i];
    return take(rows.end, radiance);
  });
}

std::vector<char> SceneShot::sky_pixels() const {
  if (renderer_) return renderer_->sky_pixels();
  std::vector<char> sky;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      sky.push_back(view_direction(placed_.camera, (x + 0.5) / width_, (y + 0.5) / height_)[2] > 0);
  return sky;
}

void SceneShot::paint_sky(PictureOutputs& files, const std::function<void(double)>& progress) const {
  const bool whole =
      sky_.render(placed_.camera, placed_.from_scene(sun_.direction()), {.sun_disc = sun_disc_, .wavelengths = {}},
                  [&](int begin, int end, std::span<const float> rgba) {
                    files.write(begin, end, rgba);
                    progress(double(end) / height_);
                    return !interrupted();
                  });
  if (!whole) throw Interrupted{};
}

void SceneShot::paint(PictureOutputs& files, const std::vector<Layer>& layers,
                      const std::function<void(double)>& progress) const {
  const bool colours = model_info(sky_.model()).colours != nullptr;
  if (colours && std::ranges::find(layers, spectral_layer, &Layer::name) != layers.end())
    throw InputError(fmt::format("--aov spectral: model {} draws in red, green and blue", sky_.model()));
  if (!renderer_) {
    if (!layers.empty())
      throw InputError(fmt::format("--aov: model {} draws the sky alone, without layers", sky_.model()));
    paint_sky(files, progress);
    check_interrupt();
    files.finish();
    return;
  }
  std::vector<float> rgba;
  const bool whole = renderer_->render(
      [&](const SceneRows& rows) {
        rgba.resize(4 * (rows.rgb.size() / 3));
        for (std::size_t i = 0; i < rows.rgb.size() / 3; ++i) {
          std::copy_n(&rows.rgb[3 * i], 3, &rgba[4 * i]);
          rgba[4 * i + 3] = 1;
        }
        std::vector<LayerRows> planes;
        for (const Layer& layer : layers)
          for (std::size_t c = 0; c < layer.channels.size(); ++c)
            planes.push_back({(rows.*layer.values).data() + c, layer.channels.size()});
        files.write(rows.begin, rows.end, rgba, planes);
        progress(double(rows.end) / height_);
        return !interrupted();
      },
      !layers.empty());
  if (!whole) throw Interrupted{};
  check_interrupt();
  files.finish();
}

}  // namespace airlight::cli
