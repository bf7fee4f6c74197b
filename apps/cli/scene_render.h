// What `render` and `sequence` share: the picture of a scene, with what the command line says instead of the scene.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/sky.h"
#include "command_line.h"
#include "lights.h"
#include "model_options.h"
#include "options.h"
#include "picture_outputs.h"
#include "render/scene_renderer.h"
#include "scenefile/scene_file.h"

namespace airlight::cli {

/// A layer's channels in the file, and where they stand in a strip.
struct Layer {
  std::string_view name;
  std::vector<std::string> channels;
  std::vector<float> SceneRows::*values;
};

/// Which layers, and what replaces a scene's own words.
struct ScenePictureOptions {
  std::string size, exposure, tone, aov, model, engine = "simd";
  ModelOptions own;
  std::optional<int> samples, accumulate;
  bool full_float = false, no_air_shadows = false, no_sun = false;

  void add_to(const Verb& verb);
  /// Those that concern the picture itself: not its layers, not the model.
  void add_picture_to(const Verb& verb);
  /// @throws InputError
  void apply(Scene& scene) const;
  /// @param outputs  one of them at least is an .exr, if there are layers
  /// @throws InputError, with "did you mean"
  std::vector<Layer> layers(const std::vector<std::string>& outputs) const;
  /// How the picture is written. @throws InputError
  PictureFormat format(const Scene& scene) const;

 private:
  std::vector<Layer> named_layers() const;
};

/// One picture of a scene, made ready: all that can be wrong with the scene has been said.
class SceneShot {
 public:
  /// @param scene        with its options applied
  /// @param wavelengths  [nm] the four that land's light is computed at; empty: those of real time
  SceneShot(const Scene& scene, std::shared_ptr<const Land> land, std::shared_ptr<Engine> engine, bool sun_disc,
            const std::vector<double>& wavelengths = {});
  SceneShot(const SceneShot&) = delete;  // the renderer knows where the sky lives
  SceneShot& operator=(const SceneShot&) = delete;

  /// Half the triangles of the land; 0 where a published system draws a sky without land.
  std::size_t cells() const { return renderer_ ? renderer_->terrain().statistics().cells : 0; }
  int width() const { return width_; }
  int height() const { return height_; }
  const SunPlace& sun() const { return sun_; }
  const Sky& sky() const { return sky_; }
  /// What the model has to say of its parameters, and of shadows that are left out.
  std::vector<std::string> warnings() const;
  int samples() const { return samples_; }
  /// All but the engine: threads and processor are no part of a picture.
  const Metadata& metadata() const { return metadata_; }

  /// The picture's rows from top to bottom up to `end`, linear sRGB [cd/m^2], three numbers a pixel; false stops.
  /// @returns false when stopped
  bool rows(const std::function<bool(int end, std::span<const float> rgb)>& take) const;
  /// The same as radiance [W m^-2 sr^-1 nm^-1] at the four wavelengths, four numbers a pixel.
  /// @throws InputError where the model answers in colours
  bool spectral_rows(const std::function<bool(int end, std::span<const float> radiance)>& take) const;
  /// Whether each pixel's middle looks into the sky, rows from the top: past all land, or above the horizon where there is none.
  std::vector<char> sky_pixels() const;
  /// Renders into files. @param progress  is told how much is done, 0 .. 1. @throws Interrupted
  void paint(PictureOutputs& files, const std::vector<Layer>& layers,
             const std::function<void(double)>& progress) const;

 private:
  SunPlace sun_;
  Sky sky_;
  std::vector<LitSky> more_lights_;
  std::unique_ptr<SceneRenderer> renderer_;  // none: a published system draws the sky
  PlacedCamera placed_;
  bool sun_disc_, has_land_;
  std::optional<bool> asked_shadows_;  // in the air
  bool shaded_ = false;
  int width_, height_, samples_;
  Metadata metadata_;

  void paint_sky(PictureOutputs& files, const std::function<void(double)>& progress) const;
};

}  // namespace airlight::cli
