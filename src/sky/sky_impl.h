// What a Sky holds, for the files that answer its questions: sky.cpp rays, points.cpp what a picture shows, picture.cpp pictures.
#pragma once
#include <algorithm>
#include <map>
#include <tuple>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "engine/kernel_index.h"
#include "model/model.h"
#include "optics/bake.h"
#include "optics/number_text.h"
#include "sky/binder.h"
#include "sky/runs.h"

namespace airlight {

inline void set_texel(std::vector<double>& texels, std::size_t i, double x, double y, double z, double w) {
  texels[4 * i] = x, texels[4 * i + 1] = y, texels[4 * i + 2] = z, texels[4 * i + 3] = w;
}

/// The kernels' struct Observer.
inline Fields observer_fields(const Direction& sun, double altitude) {
  return {{"sun", {sun[0], sun[1], sun[2], 0}}, {"altitude", {altitude}}};
}

/// The kernels' struct SunDirection.
inline Fields sun_direction_fields(const Direction& sun) { return {{"direction", {sun[0], sun[1], sun[2], 0}}}; }

// Below the ground sphere the ground lies just below the eye.
inline constexpr double eye_height = 1;  // [m]

/// @param depth  vertical, of the air at these wavelengths
/// @throws InputError where the model does not take so dense an air
inline void check_optical_depth(const Model& m, const std::string& air, const Quad& quad, const Quad& depth) {
  for (std::size_t k = 0; k < quad.size(); ++k) {
    if (depth[k] <= m.greatest_optical_depth) continue;
    throw InputError("atmosphere '" + air + "': vertical optical depth " + number_text(depth[k]) + " at " +
                     number_text(quad[k]) + " nm: expected at most " + number_text(m.greatest_optical_depth) +
                     " for model " + std::string(m.name) + "; reference, or the approximate skyview, take denser air");
  }
}

struct Sky::Impl {
  Atmosphere atmosphere;
  const Model* model;
  std::shared_ptr<Engine> engine;
  Values parameters;  // the model's own
  // Of these parameters. Noise or stars take longer to make, and to compare with what the engine keeps, than a small picture.
  Binder::HostTables host_tables;

  struct Air {
    Fields fields;
    Table zones, profile, phases;
  };
  using Key = std::tuple<const Model*, Quad, double>;
  std::map<Key, Air> baked;

  // The air for four wavelengths above a datum.
  const Air& air(const Model& m, const Quad& quad, double datum) {
    const Key key{&m, quad, datum};
    if (const auto found = baked.find(key); found != baked.end()) return found->second;
    if (baked.size() > 64) baked.clear();  // observers below the ground sphere each have a datum of their own
    BakedAir b = bake(atmosphere, quad, datum, m.air);
    check_optical_depth(m, atmosphere.name, quad, vertical_optical_depth(b));
    const auto upload = [&](const BakedTable& t) { return engine->upload(t.shape, t.rgba); };
    return baked[key] = {std::move(b.numbers), upload(b.zones), upload(b.profile), upload(b.phases)};
  }

  Situation situation(double altitude, double datum) const {
    return {atmosphere.planet.ground_radius + datum, atmosphere.planet.top_altitude - datum, altitude - datum,
            &parameters};
  }
  static double datum_for(double altitude) { return altitude < 0 ? altitude - eye_height : 0; }

  Binder binder(const Model& m, const Quad& quad, double altitude) {
    const double datum = datum_for(altitude);
    Binder b(*engine, m, situation(altitude, datum));
    if (&m == model) b.keep_host_tables(host_tables);
    if (m.colours) return b;  // its air is in its parameters
    const Air& a = air(m, quad, datum);
    b.set("air", a.fields);
    b.set("zones", a.zones);
    b.set("profile", a.profile);
    b.set("phases", a.phases);
    return b;
  }

  /// Answers rays that share a datum, four wavelengths at a time, or in red, green and blue; `put(ray, wavelength, value)`.
  using Put = std::function<void(std::size_t ray, std::size_t wavelength, double value)>;
  void answer(Quantity quantity, std::span<const Ray> rays, std::span<const std::size_t> which,
              std::span<const double> wavelengths, const Model& m, const Put& put);

  /// One run of a picture's pass: four wavelengths, and what a unit of each adds to the three channels.
  struct Draw {
    const PassInfo* pass;
    std::vector<double> parameters;
    std::vector<Table> inputs;
  };
  /// One, or one for each frame that the model's pictures gather, the last one last.
  std::vector<Draw> draws_for(const Camera& camera, const Direction& to_sun, bool sun_disc, const Quad& quad,
                              const std::array<std::array<double, 3>, 4>& weights);
  /// Calls `make` with the first of each four wavelengths; whoever watches the engine is told how many are done.
  void for_each_quad(std::size_t wavelengths, const std::function<void(std::size_t first)>& make) const;
  Gathering gathering() const { return model->gathering ? model->gathering(parameters) : Gathering{}; }
  /// Runs them over one strip after the other; `drawn` is given each, `strip` told when all are, and stops by false.
  /// @param channels  numbers of a pixel that are kept
  bool draw_strips(const Camera& camera, std::span<const Draw> draws, std::size_t channels,
                   const std::function<void(std::size_t draw, std::span<const float> rgba)>& drawn,
                   const std::function<bool(int begin, int end)>& strip);

  // The map of shadows as a table. A picture is asked for in many parts, with one map: it is looked at once.
  struct Cast {
    std::shared_ptr<const std::vector<float>> edges;
    double datum = 0;
    Table table;
  } last_cast;
  const Table& cast(const AirShadows& shadows, double datum);

  /// The pass that answers for points in view; empty: its rays are marched.
  std::string_view haze_pass(double altitude) const { return model->haze(situation(altitude, datum_for(altitude))); }
  bool shades_air(double altitude) const;
  void haze(double altitude, const Direction& sun, std::span<const Sight> points, std::span<const double> wavelengths,
            const AirShadows* shadows, std::span<double> inscatter, std::span<double> transmittance);
  void march_haze(double altitude, const Direction& sun, std::span<const Sight> points,
                  std::span<const double> wavelengths, std::span<double> inscatter, std::span<double> transmittance);
  void surface(std::span<const SurfacePoint> points, double sun_zenith_cosine, std::span<const double> wavelengths,
               std::span<const double> albedo, std::span<double> radiance, std::span<double> skylight);
  /// Binds what the surfaces of a system of colours are lit by.
  void light_in_colours(Binder& b, double sun_zenith_cosine);
  /// The same of air with tables: the sky over altitudes and suns.
  void light_from_air(Binder& b, double sun_zenith_cosine);
};

}  // namespace airlight
