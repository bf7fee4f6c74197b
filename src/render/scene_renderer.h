// A picture of land in air: Embree says what is seen, `Sky` what light it reflects and what the air does to it on the way.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "airlight/sky.h"
#include "scene/scene_camera.h"
#include "scene/shadow_map.h"
#include "scene/surface_colour.h"

namespace airlight {

/// A light beside the Sun.
struct MoreLight {
  const Sky* sky;       ///< of the same air and model, whose sun is this light; must outlive the renderer
  Direction direction;  ///< unit, towards its centre, in the scene's frame
};

/// Who looks, in which light.
struct SceneView {
  PlacedCamera camera;
  Direction sun{0, 0, 1};  ///< unit, towards the Sun's centre, in the scene's frame
  std::vector<MoreLight> more_lights = {};
};

struct SceneOptions {
  int samples = 1;           ///< a pixel, a square number to 256; the Sun's disc and shadows soften with it
  bool air_shadows = true;   ///< land casts shadows into the air
  bool soft_shadows = true;  ///< on the ground, by the Sun's size
  bool sun_disc = true;
  double triangle_pixels = 2;            ///< wanted side of a triangle
  std::vector<double> wavelengths = {};  ///< [nm] the four that light is computed at; empty: those of real time
  ShadowGrid shadow_grid;                ///< centred on the eye; its middle is not used
  int shadow_steps =
      32;  ///< points on a view ray where shadows are looked for; twice as many where a pixel has several samples
};

/// Layers of consecutive rows [begin, end): pixel after pixel. Radiance as linear sRGB [cd/m^2].
struct SceneRows {
  int begin = 0, end = 0;
  std::vector<float> rgb;      ///< 3: what the eye sees
  std::vector<float> surface;  ///< 3: what leaves the ground, or the Sun's disc, towards the eye
  std::vector<float>
      transmittance;  ///< 3: (rgb - inscatter) / surface; without surface, of the air at the three primaries' mean
  std::vector<float> inscatter;       ///< 3: what the air adds
  std::vector<float> depth;           ///< 1: distance [m]; infinite: the sky
  std::vector<float> position;        ///< 3: in the scene's frame [m]; sky: 0
  std::vector<float> normal;          ///< 3: smooth, in the scene's frame; sky: 0
  std::vector<float> albedo;          ///< 3: linear sRGB of a white-lit surface
  std::vector<float> sun_visibility;  ///< 1: part of the Sun's disc that land leaves visible; sky: 0
  std::vector<float> sky_irradiance;  ///< 3: on the surface, photometric, linear sRGB [lx]
  // At each of the four wavelengths of real time: radiances [W m^-2 sr^-1 nm^-1], and transmittance, by which what leaves the pixel's
  // surfaces comes to the eye. Empty for a model that answers in colours.
  std::vector<float> spectral_surface, spectral_transmittance, spectral_inscatter;
};

class SceneRenderer {
 public:
  /// @throws InputError for an eye in the ground, more lights than a system of colours knows, and all that Sky and Terrain refuse.
  SceneRenderer(const Sky& sky, std::shared_ptr<const Land> land, const SurfaceSettings& surface, const SceneView& view,
                const SceneOptions& options);
  ~SceneRenderer();

  const Terrain& terrain() const;
  int width() const;  ///< of the picture [pixels]: a cube's six faces lie side by side

  /// What one line of sight brings, spectrally, at the four wavelengths of real time; or in red, green and blue, and 0.
  struct Answer {
    Direction view, sun, view_in_scene;                       ///< view and Sun in the eye's own frame; unit
    double distance;                                          ///< [m]; infinite: the sky
    std::array<double, 4> inscatter, transmittance, surface;  ///< radiances [W m^-2 sr^-1 nm^-1]
  };
  /// @param u, v  picture coordinates: (0, 0) top left, (1, 1) bottom right
  /// @throws InputError outside a fisheye's circle
  Answer at(double u, double v) const;

  /// Whether each pixel's middle looks past all ground, rows from the top.
  std::vector<char> sky_pixels() const;

  /// @param rows    called with strips from top to bottom, from the calling thread; false stops
  /// @param layers  false: `rgb` alone, the rest is empty
  /// @returns       false when stopped
  bool render(const std::function<bool(const SceneRows&)>& rows, bool layers = true) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
