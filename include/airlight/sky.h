#pragma once
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/camera.h"
#include "airlight/engine.h"
#include "airlight/model_info.h"

namespace airlight {

/// A question about the air, in the observer's own frame (east, north, up): z is the local vertical at the observer.
struct Ray {
  double altitude = 0;      ///< observer above the ground sphere [m]; may be negative, may be in space
  Direction view{0, 0, 1};  ///< unit, observer -> scene
  Direction sun{0, 0, 1};   ///< unit, towards the Sun's centre; may be below the horizon
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinity: to space or the ground
};

enum class Quantity {
  radiance,  ///< [W m^-2 sr^-1 nm^-1] along the ray, sun disc excluded; ground's reflection included where the ray meets it
  path_radiance,   ///< [W m^-2 sr^-1 nm^-1] the air's part alone
  transmittance,   ///< [1] along the ray
  sun_irradiance,  ///< [W m^-2 nm^-1] direct sunlight on a plane normal to the beam; `view` and `distance` are not used
  sky_irradiance,  ///< [W m^-2 nm^-1] skylight on a horizontal plane facing up; `view` and `distance` are not used
};

/// What a picture shows beside the air.
struct PictureOptions {
  bool sun_disc = true;
  std::vector<double>
      wavelengths;  ///< [nm], increasing; empty: the four of real time. Others are run four at a time and accumulated
                    ///< to XYZ; best at equal spacing
};

/// A point in an observer's view, or the sky behind everything.
struct Sight {
  Direction view{0, 0, 1};                                    ///< unit, observer -> point
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinity: to space or the ground sphere
  double offset =
      0.5;  ///< in [0, 1): where between its points a ray looks for shadows; spread over pixels, it dissolves their steps
};

/// A piece of a solid surface out of doors. Its frame: x horizontal towards the Sun, z the local vertical.
struct SurfacePoint {
  double altitude = 0;           ///< [m]
  double sun_zenith_cosine = 1;  ///< of the Sun's centre, above the local horizontal
  double sun_cosine = 1;         ///< of the angle between the surface's normal and the Sun; negative: it faces away
  Direction normal{0, 0, 1};     ///< unit
  double sun_visibility = 1;     ///< part of the Sun's disc that other surfaces leave visible
  double sky_view =
      1;  ///< cosine-weighted part of the upper hemisphere in which the surface, tilted as it is, sees sky; see src/scene/sky_view.h
};

/// Shadows that land casts into the air: a map over it, for one direction of the Sun. Outside the map all is lit.
struct AirShadows {
  int width = 0, height = 0;
  std::shared_ptr<const std::vector<float>>
      edges;  ///< for each cell, rows of u first: altitude [m] below which the Sun's disc is hidden, and above which it is whole
  std::array<double, 4> across{},
      along{};  ///< map coordinate u (v) of a point p [m], in the observer's frame: across[0..2] . p + across[3]; 0 and 1 at the map's edges
  double highest = 0;  ///< altitude [m] above which all is lit
  int steps = 64;      ///< points on a ray, 1 to 1024
};

/// Binds an atmosphere, a model and an engine, and answers the questions of the interface in batches.
/// Objects are cheap to make; tables are built on the first question that needs them and kept by the engine.
class Sky {
 public:
  /// @param model       one of models()
  /// @param parameters  the model's own; those not named keep their defaults, or those of the preset that `preset` names
  /// @throws InputError for an unknown model, an invalid atmosphere, or a parameter that the model has not or that is out of range.
  Sky(Atmosphere atmosphere, std::string_view model = "skyview", std::shared_ptr<Engine> engine = make_engine("simd"),
      const Parameters& parameters = {});
  ~Sky();
  Sky(Sky&&) noexcept;
  Sky& operator=(Sky&&) noexcept;

  const Atmosphere& atmosphere() const;
  std::string_view model() const;
  /// The model's parameters, all of them.
  const Parameters& parameters() const;
  /// What the model has to say of parameters that are legal, but break what it promises.
  std::vector<std::string> warnings() const;
  Engine& engine() const;

  /// Answers one quantity for N rays at W wavelengths. A model that answers in colours (ModelInfo::colours) is asked at its nominal
  /// wavelengths alone; where it has none, `wavelengths` is empty and W is 3: red, green, blue, in the model's own unit.
  /// @param max_order  0: all the orders that the model has; 1: light scattered or reflected once
  /// @param out        N x W, ray slowest. @throws InputError naming the ray and the value; `out` is then untouched.
  void evaluate(Quantity quantity, std::span<const Ray> rays, std::span<const double> wavelengths,
                std::span<double> out, int max_order = 0) const;

  /// Whether the model can shade the air with land's shadows for an observer: haze() may then be given them.
  /// @param altitude  [m]. @throws InputError for one below half of the planet's radius, or not finite
  bool shades_air(double altitude) const;

  /// The air before N points of one observer's view, at W wavelengths: what a picture with depth needs. Lit by one Sun; land may shade
  /// it. Light of higher orders is not shaded: it comes from all sides.
  /// @param shadows        none: all lit
  /// @param inscatter      N x W [W m^-2 sr^-1 nm^-1], as path_radiance; where a distance is infinite, as radiance
  /// @param transmittance  N x W [1]
  /// @throws InputError naming the point and the value, and for shadows where shades_air() says no
  void haze(double altitude, Direction sun, std::span<const Sight> points, std::span<const double> wavelengths,
            const AirShadows* shadows, std::span<double> inscatter, std::span<double> transmittance) const;

  /// Light that N Lambertian surface points reflect, at W wavelengths, lit by the Sun and by the sky, which is brighter on one side.
  /// What hides the sky is taken for lit ground of the planet's albedo.
  /// @param sun_zenith_cosine  where the Sun is for most of them; the sky's light is known for Suns within 3 degrees of that
  /// @param albedo   N x W, in [0, 1]
  /// @param radiance N x W [W m^-2 sr^-1 nm^-1]
  /// @param skylight N x W [W m^-2 nm^-1] that reaches the surface from the sky and what hides it; may be empty
  void surface(std::span<const SurfacePoint> points, double sun_zenith_cosine, std::span<const double> wavelengths,
               std::span<const double> albedo, std::span<double> radiance, std::span<double> skylight) const;

  /// Linear-light picture in absolute units: RGBA rows of linear sRGB [cd/m^2], alpha 1.
  /// @param strip  Called with consecutive rows [begin, end) and their pixels, from the calling thread; return false to stop.
  /// @returns      false when stopped
  bool render(const Camera& camera, Direction sun, const PictureOptions& options,
              const std::function<bool(int begin, int end, std::span<const float> rgba)>& strip) const;

  /// The same picture as spectral radiance [W m^-2 sr^-1 nm^-1]: pixel after pixel, W values each, in the order of the wavelengths.
  /// @throws InputError also where the model answers in colours
  bool render_spectral(const Camera& camera, Direction sun, const PictureOptions& options,
                       const std::function<bool(int begin, int end, std::span<const float> values)>& strip) const;

  /// The four wavelengths [nm] of real time.
  std::array<double, 4> realtime_wavelengths() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// CIE 1931 colour of a spectrum sampled at W wavelengths with spacing-true weights: XYZ in cd/m^2 (or lx), 683 lm/W applied.
std::array<double, 3> spectrum_to_xyz(std::span<const double> wavelengths, std::span<const double> spectrum);
/// 40 wavelengths [nm] used for photometric answers: centres of 10 nm bins, 385 .. 775.
std::vector<double> photometric_wavelengths();

}  // namespace airlight
