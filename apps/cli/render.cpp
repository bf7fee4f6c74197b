// `airlight render`: a picture of a landscape in real air, with its layers.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "interrupt.h"
#include "model_options.h"
#include "number.h"
#include "progress.h"
#include "scene_render.h"
#include "scenefile/animation.h"
#include "spectral_colours.h"

namespace airlight::cli {
namespace {

struct RenderOptions {
  std::string scene, frame;
  std::vector<std::string> outputs;
  double frames_per_second = 24;
  ScenePictureOptions picture;
  std::string wavelengths = "4", sensor;
  bool spectral = false;

  /// More than the picture of real time.
  bool keeps_wavelengths() const { return spectral || wavelengths != "4" || !sensor.empty(); }
};

std::optional<int> frame_of(const RenderOptions& options) {
  if (options.frame.empty()) return {};
  return parse_whole(options.frame, "--frame", {0, 1e8, "frames"});
}

/// As it is written, or as its key frames have it.
Scene scene_of(const RenderOptions& options, std::optional<int> frame) {
  if (!frame) return load_scene(options.scene);
  return load_animation(options.scene, options.frames_per_second).frame(*frame).scene;
}

/// One picture for each four wavelengths, woven together.
void paint_spectrum(const RenderOptions& options, const Scene& scene, const std::shared_ptr<const Land>& land,
                    const SceneShot& shot, SpectralColours& colours, PictureOutputs& files) {
  const std::size_t W = colours.wavelengths().size(), row = std::size_t(shot.width()) * W;
  std::vector<float> values(row * std::size_t(shot.height()));
  Progress progress("render");
  for (std::size_t w = 0; w < W; w += 4) {
    std::vector<double> quad;
    for (std::size_t k = 0; k < 4; ++k) quad.push_back(colours.wavelengths()[std::min(w + k, W - 1)]);
    const SceneShot four(scene, land, engine_named(options.picture.engine), !options.picture.no_sun, quad);
    std::size_t pixel = 0;
    const bool whole = four.spectral_rows([&](int end, std::span<const float> radiance) {
      for (std::size_t i = 0; i < radiance.size(); i += 4, ++pixel)
        for (std::size_t k = 0; k < 4 && w + k < W; ++k) values[pixel * W + w + k] = radiance[i + k];
      progress.show((double(w) + 4.0 * end / shot.height()) / double(W));
      return !interrupted();
    });
    if (!whole) throw Interrupted{};
  }
  check_interrupt();
  for (int y = 0; y < shot.height(); ++y)
    colours.write(files, y, y + 1, std::span(values).subspan(std::size_t(y) * row, row));
  files.finish();
}

int run_render(const RenderOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  const std::vector<double> wavelengths = picture_wavelengths(options.wavelengths);
  const std::vector<Layer> layers = options.picture.layers(options.outputs);
  const std::optional<int> frame = frame_of(options);
  Scene scene = scene_of(options, frame);
  options.picture.apply(scene);
  PictureFormat format = options.picture.format(scene);
  // Everything that can be wrong is found before a file is touched.
  const auto land = std::make_shared<const Land>(scene.land);
  const SceneShot shot(scene, land, engine_named(options.picture.engine), !options.picture.no_sun);
  tell_warnings(shot.warnings());
  const std::string engine = describe(shot.sky().engine());
  Metadata metadata = shot.metadata();
  metadata.push_back({"engine", engine});
  if (frame) metadata.push_back({"frame", double(*frame)});
  std::optional<SpectralColours> colours;
  if (options.keeps_wavelengths()) {
    colours.emplace(shot.sky(), wavelengths, options.sensor, options.spectral);
    std::string list;
    for (const double wavelength : colours->wavelengths())
      list += fmt::format("{}{:g}", list.empty() ? "" : " ", wavelength);
    metadata.push_back({"wavelengths [nm]", list});
    colours->describe(metadata);
    format.layers = colours->channels();
  }
  PictureOutputs files(options.outputs, shot.width(), shot.height(), format, metadata);
  if (colours) {
    paint_spectrum(options, scene, land, shot, *colours, files);
  } else {
    Progress progress("render");
    shot.paint(files, layers, [&](double fraction) { progress.show(fraction); });
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  fmt::print(
      stderr,
      "{}: {} x {}, {} samples a pixel, {}, {} on {}, sun at azimuth {:.2f}, elevation {:.2f} degrees, {} thousand "
      "triangles; {:.2f} s\n",
      files.names(), shot.width(), shot.height(), shot.samples(), scene.air.name, shot.sky().model(), engine,
      shot.sun().azimuth, shot.sun().elevation, 2 * shot.cells() / 1000, seconds);
  files.tell_notes();
  return ok;
}

}  // namespace

void add_render(CommandLine& line) {
  const auto options = std::make_shared<RenderOptions>();
  const Verb render = line.verb("render", "A picture of a landscape in real air, from a scene file");
  render.option("scene", options->scene, "scene to render, TOML (docs/scene_file.md)").required().type_name("FILE");
  render
      .option("-o,--output", options->outputs,
              "picture to write: .exr and .hdr linear in cd/m2, .png tone-mapped; may be repeated")
      .required()
      .one_value_each()
      .type_name("FILE");
  const Option frame = render
                           .option("--frame", options->frame,
                                   "of a scene with key frames: this one, as sequence makes it, from 0 (default: the "
                                   "scene as it is written)")
                           .type_name("N");
  render
      .number("--fps", options->frames_per_second, {0.001, 1000, "1/s"},
              "frames a second, of key frames that are given by times")
      .needs(frame);
  options->picture.add_to(render);
  for (const Option& option : add_spectral_options(render, options->wavelengths, options->spectral, options->sensor))
    option.excludes(render.find("--aov"));
  render.runs([options] { return run_render(*options); });
}

}  // namespace airlight::cli
