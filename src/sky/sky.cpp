#include "airlight/sky.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "airlight/error.h"
#include "engine/kernel_index.h"
#include "model/model.h"
#include "optics/bake.h"
#include "optics/colour.h"
#include "optics/number_text.h"
#include "sky/binder.h"
#include "sky/camera.h"

namespace airlight {
namespace {

// Below the ground sphere the ground lies just below the eye.
constexpr double eye_height = 1;  // [m]

double length(const Direction& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }

// The i-th of what was given, in an error; no text is made for the many that are good.
struct Nth {
  const char *kind = nullptr, *what;
  std::size_t i = 0;
  std::string text() const { return kind ? std::string(kind) + ' ' + std::to_string(i) + ": " + what : what; }
};
void check(bool good, const Nth& what, double value, const char* range) {
  if (!good) throw InputError(what.text() + " = " + number_text(value) + ": expected " + range);
}
void check(bool good, const char* what, double value, const char* range) { check(good, Nth{nullptr, what}, value, range); }
void check_altitude(double altitude, double ground_radius, const Nth& what) {
  check(altitude > -0.9 * ground_radius && altitude <= 1e12, what, altitude, "-0.9 ground radii .. 1e12 m");
}
Direction checked_unit(const Direction& d, const Nth& what) {
  const double n = length(d);
  check(std::abs(n - 1) < 1e-3, what, n, "a unit vector: length 1 within 0.001");
  return {d[0] / n, d[1] / n, d[2] / n};
}

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A ray from space, begun where it enters the air: in float its lowest point would be uncertain by half a metre, which is 2e-5 of
// a grazing ray's transmittance. Rays that miss the air are left alone. Radius and top are those of the datum.
Ray from_entry(const Ray& ray, double ground_radius, double top) {
  const double r = ground_radius + ray.altitude, outer = ground_radius + top, along = -r * ray.view[2];
  const double across = r * std::hypot(ray.view[0], ray.view[1]), half_chord = std::sqrt(std::max(outer * outer - across * across, 0.0));
  if (ray.altitude <= top || along <= 0 || across >= outer) return ray;
  const double path = std::max(along - half_chord, 0.0);
  // The frame at the entry: up, and two axes across it.
  const Direction up{ray.view[0] * path / outer, ray.view[1] * path / outer, (r + ray.view[2] * path) / outer};
  const Direction other = std::abs(up[0]) < 0.7 ? Direction{1, 0, 0} : Direction{0, 1, 0};
  const double shade = dot(other, up);
  Direction x{other[0] - shade * up[0], other[1] - shade * up[1], other[2] - shade * up[2]};
  for (const double n = length(x); double& c : x) c /= n;
  const Direction y{up[1] * x[2] - up[2] * x[1], up[2] * x[0] - up[0] * x[2], up[0] * x[1] - up[1] * x[0]};
  const auto turned = [&](const Direction& d) { return Direction{dot(d, x), dot(d, y), dot(d, up)}; };
  Ray inside{top, turned(ray.view), turned(ray.sun), std::max(ray.distance - path, 0.0)};
  inside.view[2] = -half_chord / outer;  // its digits are what this is for
  return inside;
}

void set_texel(std::vector<double>& texels, std::size_t i, double x, double y, double z, double w) {
  texels[4 * i] = x, texels[4 * i + 1] = y, texels[4 * i + 2] = z, texels[4 * i + 3] = w;
}

Fields observer_fields(const Direction& sun, double altitude) { return {{"sun", {sun[0], sun[1], sun[2], 0}}, {"altitude", {altitude}}}; }

// Without shadows: a map whose highest shadow lies below everything, so that no ray looks at it.
void check_shadows(const AirShadows& shadows) {
  check(shadows.width >= 2 && shadows.width <= 16384, "width of the shadow map", shadows.width, "2 .. 16384");
  check(shadows.height >= 2 && shadows.height <= 16384, "height of the shadow map", shadows.height, "2 .. 16384");
  check(shadows.steps >= 1 && shadows.steps <= 1024, "steps of the shadow map", shadows.steps, "1 .. 1024");
  const double expected = 2.0 * shadows.width * shadows.height;
  const std::size_t given = shadows.edges ? shadows.edges->size() : 0;
  check(double(given) == expected, "values of the shadow map", double(given), "two for each cell");
  for (const float edge : *shadows.edges) check(std::isfinite(edge), "an altitude of the shadow map", edge, "a finite number of metres");
}

// Four wavelengths from the w-th on; the last stands for those that are missing.
Quad quad_at(std::span<const double> wavelengths, std::size_t w) {
  Quad quad;
  for (std::size_t k = 0; k < 4; ++k) quad[k] = wavelengths[std::min(w + k, wavelengths.size() - 1)];
  return quad;
}

}  // namespace

struct Sky::Impl {
  Atmosphere atmosphere;
  const Model* model;
  std::shared_ptr<Engine> engine;

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
    const auto upload = [&](const BakedTable& t) { return engine->upload(t.shape, t.rgba); };
    return baked[key] = {std::move(b.numbers), upload(b.zones), upload(b.profile), upload(b.phases)};
  }

  Situation situation(double altitude, double datum) const {
    return {atmosphere.planet.ground_radius + datum, atmosphere.planet.top_altitude - datum, altitude - datum};
  }
  static double datum_for(double altitude) { return altitude < 0 ? altitude - eye_height : 0; }

  Binder binder(const Model& m, const Quad& quad, double altitude) {
    const double datum = datum_for(altitude);
    const Air& a = air(m, quad, datum);
    Binder b(*engine, m, situation(altitude, datum));
    b.set("air", a.fields);
    b.set("zones", a.zones);
    b.set("profile", a.profile);
    b.set("phases", a.phases);
    return b;
  }

  // Answers rays that share a datum, four wavelengths at a time; `put(ray, wavelength, value)`.
  template <class Put>
  void answer(Quantity quantity, std::span<const Ray> rays, std::span<const std::size_t> which, std::span<const double> wavelengths, const Model& m, const Put& put) {
    const bool sky_light = quantity == Quantity::sky_irradiance;  // sums over directions: observers are rows
    const int count = int(which.size()), width = sky_light ? 1 : std::min(count, 1024), height = (count + width - 1) / width;
    const Shape shape{width, height, 1};
    std::vector<double> eyes(4 * shape.texels()), suns(eyes.size());
    const double datum = datum_for(rays[which[0]].altitude);
    for (std::size_t i = 0; i < shape.texels(); ++i) {
      Ray r = rays[which[std::min(i, which.size() - 1)]];
      r.altitude -= datum;
      if (quantity < Quantity::sun_irradiance) r = from_entry(r, atmosphere.planet.ground_radius + datum, atmosphere.planet.top_altitude - datum);
      // Far beyond any air; float squares it.
      const double distance = std::min(r.distance, 1e15);
      set_texel(eyes, i, r.altitude, r.view[0], r.view[1], r.view[2]);
      set_texel(suns, i, distance, r.sun[0], r.sun[1], r.sun[2]);
    }
    std::vector<double> texels(4 * shape.texels()), more(texels.size());
    for (std::size_t w = 0; w < wavelengths.size(); w += 4) {
      Binder b = binder(m, quad_at(wavelengths, w), rays[which[0]].altitude);
      b.set("eyes", engine->upload(shape, eyes));
      b.set("suns", engine->upload(shape, suns));
      std::vector<Table> answers;
      if (sky_light) {
        b.set("sky_light", b.run(m.sky_light, {256, height, 1})[0]);
        answers = b.run("core.sky_irradiance", shape);
      } else {
        answers = b.run(quantity == Quantity::sun_irradiance ? "core.sun_irradiance" : m.rays, shape);
      }
      // rays: path radiance, transmittance, ground
      const std::size_t part = quantity == Quantity::transmittance ? 1 : 0;
      engine->read(answers[part], texels);
      if (quantity == Quantity::radiance) {
        engine->read(answers[2], more);
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] += more[i];
      }
      for (std::size_t i = 0; i < which.size(); ++i) {
        for (std::size_t k = 0; k < 4 && w + k < wavelengths.size(); ++k) put(which[i], w + k, texels[4 * i + k]);
      }
    }
  }

  // The map of shadows as a table. A picture is asked for in many parts, with one map: it is looked at once.
  struct Cast {
    std::shared_ptr<const std::vector<float>> edges;
    double datum = 0;
    Table table;
  } last_cast;
  const Table& cast(const AirShadows& shadows, double datum) {
    if (shadows.edges && shadows.edges == last_cast.edges && datum == last_cast.datum) return last_cast.table;
    check_shadows(shadows);
    std::vector<double> texels(2 * shadows.edges->size());
    for (std::size_t i = 0; 4 * i < texels.size(); ++i) set_texel(texels, i, (*shadows.edges)[2 * i] - datum, (*shadows.edges)[2 * i + 1] - datum, 0, 0);
    last_cast = {shadows.edges, datum, engine->lend({shadows.width, shadows.height, 1}, texels)};
    return last_cast.table;
  }

  void haze(double altitude, const Direction& sun, std::span<const Sight> points, std::span<const double> wavelengths, const AirShadows* shadows,
            std::span<double> inscatter, std::span<double> transmittance) {
    const Situation s = situation(altitude, datum_for(altitude));
    const std::string_view pass = model->haze(s);
    if (pass.empty()) {
      if (shadows) throw InputError("model " + std::string(model->name) + " cannot shade the air for an observer at " + number_text(altitude) + " m");
      march_haze(altitude, sun, points, wavelengths, inscatter, transmittance);
      return;
    }
    const int count = int(points.size()), width = std::min(count, 1024), height = (count + width - 1) / width;
    const Shape shape{width, height, 1};
    std::vector<double> sights(4 * shape.texels()), offsets(sights.size());
    for (std::size_t i = 0; i < shape.texels(); ++i) {
      const Sight& p = points[std::min(i, points.size() - 1)];
      set_texel(sights, i, p.view[0], p.view[1], p.view[2], std::min(p.distance, 1e15));
      set_texel(offsets, i, p.offset, 0, 0, 0);
    }
    const Table sight_table = engine->lend(shape, sights), offset_table = engine->lend(shape, offsets);
    const double datum = datum_for(altitude);
    const Table shadow_map = shadows ? cast(*shadows, datum) : engine->upload({2, 2, 1}, std::vector<double>(16, 0.0));
    const AirShadows map = shadows ? *shadows : AirShadows{};
    std::vector<double> texels(4 * shape.texels());
    for (std::size_t w = 0; w < wavelengths.size(); w += 4) {
      Binder b = binder(*model, quad_at(wavelengths, w), altitude);
      b.set("observer", observer_fields(sun, s.altitude));
      b.set("shadow", Fields{{"across", {map.across.begin(), map.across.end()}}, {"along", {map.along.begin(), map.along.end()}},
                             {"highest", {shadows ? map.highest - datum : -1}}, {"steps", {double(map.steps)}}});
      b.set("shadow_map", shadow_map);
      b.set("points", sight_table);
      b.set("offsets", offset_table);
      const std::vector<Table> answers = b.run_once(pass, shape);
      for (const std::span<double> out : {inscatter, transmittance}) {
        engine->read(answers[out.data() == inscatter.data() ? 0 : 1], texels);
        for (std::size_t i = 0; i < points.size(); ++i) {
          for (std::size_t k = 0; k < 4 && w + k < wavelengths.size(); ++k) out[i * wavelengths.size() + w + k] = texels[4 * i + k];
        }
      }
    }
  }

  void surface(std::span<const SurfacePoint> points, double sun_zenith_cosine, std::span<const double> wavelengths, std::span<const double> albedo,
               std::span<double> radiance, std::span<double> skylight) {
    const int count = int(points.size()), width = std::min(count, 1024), height = (count + width - 1) / width;
    const Shape shape{width, height, 1};
    std::vector<double> places(4 * shape.texels()), normals(places.size());
    for (std::size_t i = 0; i < shape.texels(); ++i) {
      const SurfacePoint& p = points[std::min(i, points.size() - 1)];
      set_texel(places, i, p.altitude, p.sun_zenith_cosine, p.sun_visibility, p.sky_view);
      set_texel(normals, i, p.normal[0], p.normal[1], p.normal[2], p.sun_cosine);
    }
    const Table place_table = engine->lend(shape, places), normal_table = engine->lend(shape, normals);

    // The sky is known for a few altitudes, dense near the ground as the kernel has it, and a few Suns.
    constexpr int azimuths = 12, tilts = 13, altitudes = 12, suns = 5;
    constexpr double spread = 0.0524;  // 3 degrees
    const double highest = std::min(10000.0, 0.3 * atmosphere.planet.top_altitude), elevation = std::asin(sun_zenith_cosine);
    const double low_sun = std::sin(std::max(elevation - spread, -1.57)), high_sun = std::sin(std::min(elevation + spread, 1.57));
    std::vector<double> eyes(4 * altitudes * suns), sun_rows(eyes.size());
    for (int i = 0; i < altitudes * suns; ++i) {
      const double v = double(i % altitudes) / (altitudes - 1), mu_s = low_sun + (high_sun - low_sun) * (i / altitudes) / (suns - 1);
      set_texel(eyes, std::size_t(i), v * v * highest, 0, 0, 1);
      set_texel(sun_rows, std::size_t(i), 1e15, std::sqrt(1 - mu_s * mu_s), 0, mu_s);
    }
    const Shape rows{1, altitudes * suns, 1};
    std::vector<double> colours(4 * shape.texels()), texels(colours.size());
    const std::size_t W = wavelengths.size();
    for (std::size_t w = 0; w < W; w += 4) {
      Binder b = binder(*model, quad_at(wavelengths, w), 0);
      b.set("grid", Fields{{"azimuths", {double(azimuths)}}, {"tilts", {double(tilts)}}, {"altitudes", {double(altitudes)}}, {"suns", {double(suns)}}, {"highest", {highest}}, {"low_sun", {low_sun}}, {"high_sun", {high_sun}}});
      b.set("eyes", engine->upload(rows, eyes));
      b.set("suns", engine->upload(rows, sun_rows));
      b.set("sky_light", b.run(model->sky_light, {256, altitudes * suns, 1})[0]);
      b.set("skylight", b.run("core.skylight", {azimuths, tilts * altitudes, suns})[0]);
      for (std::size_t i = 0; i < shape.texels(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) colours[4 * i + k] = albedo[std::min(i, points.size() - 1) * W + std::min(w + k, W - 1)];
      }
      b.set("places", place_table);
      b.set("normals", normal_table);
      b.set("albedos", engine->lend(shape, colours));
      const std::vector<Table> answers = b.run_once("core.surface", shape);
      for (const auto& [table, out] : {std::pair{answers[0], radiance}, std::pair{answers[1], skylight}}) {
        if (out.empty()) continue;
        engine->read(table, texels);
        for (std::size_t i = 0; i < points.size(); ++i) {
          for (std::size_t k = 0; k < 4 && w + k < W; ++k) out[i * W + w + k] = texels[4 * i + k];
        }
      }
    }
  }

  // The same question asked of the model's rays.
  void march_haze(double altitude, const Direction& sun, std::span<const Sight> points, std::span<const double> wavelengths, std::span<double> inscatter,
                  std::span<double> transmittance) {
    std::vector<Ray> rays;
    std::vector<std::size_t> which;
    for (const Sight& p : points) {
      which.push_back(rays.size());
      rays.push_back({altitude, p.view, sun, p.distance});
    }
    const auto into = [&](std::span<double> out) {
      return [&wavelengths, out](std::size_t ray, std::size_t w, double value) { out[ray * wavelengths.size() + w] = value; };
    };
    answer(Quantity::radiance, rays, which, wavelengths, *model, into(inscatter));
    answer(Quantity::transmittance, rays, which, wavelengths, *model, into(transmittance));
  }
};

Sky::Sky(Atmosphere atmosphere, std::string_view model, std::shared_ptr<Engine> engine) : impl_(std::make_unique<Impl>()) {
  validate(atmosphere);
  impl_->atmosphere = std::move(atmosphere);
  impl_->model = &find_model(model);
  impl_->engine = std::move(engine);
}
Sky::~Sky() = default;
Sky::Sky(Sky&&) noexcept = default;
Sky& Sky::operator=(Sky&&) noexcept = default;

const Atmosphere& Sky::atmosphere() const { return impl_->atmosphere; }
std::string_view Sky::model() const { return impl_->model->name; }
Engine& Sky::engine() const { return *impl_->engine; }
std::array<double, 4> Sky::realtime_wavelengths() const { return realtime_quad; }

void Sky::evaluate(Quantity quantity, std::span<const Ray> rays, std::span<const double> wavelengths, std::span<double> out, int max_order) const {
  if (out.size() != rays.size() * wavelengths.size()) {
    throw InputError("size of out = " + std::to_string(out.size()) + ": expected " + std::to_string(rays.size() * wavelengths.size()) + ", rays times wavelengths");
  }
  if (max_order < 0 || max_order > 1) throw InputError("max_order = " + std::to_string(max_order) + ": expected 0 (all) or 1 for this model");
  std::vector<Ray> checked(rays.begin(), rays.end());
  std::map<double, std::vector<std::size_t>> groups;  // by datum
  for (std::size_t i = 0; i < checked.size(); ++i) {
    Ray& r = checked[i];
    check_altitude(r.altitude, impl_->atmosphere.planet.ground_radius, {"ray", "altitude", i});
    check(r.distance >= 0, {"ray", "distance", i}, r.distance, "at least 0 m");
    r.view = checked_unit(r.view, {"ray", "view", i});
    r.sun = checked_unit(r.sun, {"ray", "sun", i});
    groups[Impl::datum_for(r.altitude)].push_back(i);
  }
  if (rays.empty() || wavelengths.empty()) return;
  // Light of the first order is what `single` computes.
  const Model& model = max_order == 1 ? find_model("single") : *impl_->model;
  std::vector<double> answers(out.size());
  for (const auto& [datum, group] : groups) {
    // In parts, so that the tables of a million rays fit an engine.
    constexpr std::size_t part = 4096;
    for (std::size_t begin = 0; begin < group.size(); begin += part) {
      impl_->answer(quantity, checked, std::span(group).subspan(begin, std::min(part, group.size() - begin)), wavelengths, model,
                    [&](std::size_t ray, std::size_t w, double value) { answers[ray * wavelengths.size() + w] = value; });
    }
  }
  std::ranges::copy(answers, out.begin());
}

void Sky::haze(double altitude, Direction sun, std::span<const Sight> points, std::span<const double> wavelengths, const AirShadows* shadows,
               std::span<double> inscatter, std::span<double> transmittance) const {
  check_altitude(altitude, impl_->atmosphere.planet.ground_radius, {nullptr, "altitude"});
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  const std::size_t expected = points.size() * wavelengths.size();
  check(inscatter.size() == expected, "size of inscatter", double(inscatter.size()), "points times wavelengths");
  check(transmittance.size() == expected, "size of transmittance", double(transmittance.size()), "points times wavelengths");
  std::vector<Sight> checked(points.begin(), points.end());
  for (std::size_t i = 0; i < checked.size(); ++i) {
    check(checked[i].distance >= 0, {"point", "distance", i}, checked[i].distance, "at least 0 m");
    check(checked[i].offset >= 0 && checked[i].offset < 1, {"point", "offset", i}, checked[i].offset, "0 .. 1");
    checked[i].view = checked_unit(checked[i].view, {"point", "view", i});
  }
  if (points.empty() || wavelengths.empty()) return;
  impl_->haze(altitude, to_sun, checked, wavelengths, shadows, inscatter, transmittance);
}

void Sky::surface(std::span<const SurfacePoint> points, double sun_zenith_cosine, std::span<const double> wavelengths, std::span<const double> albedo,
                  std::span<double> radiance, std::span<double> skylight) const {
  check(std::abs(sun_zenith_cosine) <= 1, "sun_zenith_cosine", sun_zenith_cosine, "-1 .. 1");
  const std::size_t expected = points.size() * wavelengths.size();
  check(albedo.size() == expected, "size of albedo", double(albedo.size()), "points times wavelengths");
  check(radiance.size() == expected, "size of radiance", double(radiance.size()), "points times wavelengths");
  check(skylight.empty() || skylight.size() == expected, "size of skylight", double(skylight.size()), "points times wavelengths, or 0");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    check_altitude(p.altitude, impl_->atmosphere.planet.ground_radius, {"point", "altitude", i});
    checked_unit(p.normal, {"point", "normal", i});
    check(std::abs(p.sun_zenith_cosine) <= 1, {"point", "sun_zenith_cosine", i}, p.sun_zenith_cosine, "-1 .. 1");
    check(std::abs(p.sun_cosine) <= 1, {"point", "sun_cosine", i}, p.sun_cosine, "-1 .. 1");
    check(p.sun_visibility >= 0 && p.sun_visibility <= 1, {"point", "sun_visibility", i}, p.sun_visibility, "0 .. 1");
    check(p.sky_view >= 0 && p.sky_view <= 1, {"point", "sky_view", i}, p.sky_view, "0 .. 1");
  }
  for (const double a : albedo) check(a >= 0 && a <= 1, "albedo", a, "0 .. 1");
  if (!points.empty() && !wavelengths.empty()) impl_->surface(points, sun_zenith_cosine, wavelengths, albedo, radiance, skylight);
}

bool Sky::render(const Camera& camera, Direction sun, const PictureOptions& options,
                 const std::function<bool(int, int, std::span<const float>)>& strip) const {
  check(camera.width >= 1 && camera.width <= 65536, "picture width", camera.width, "1 .. 65536");
  check(camera.height >= 1 && camera.height <= 65536, "picture height", camera.height, "1 .. 65536");
  check_altitude(camera.altitude, impl_->atmosphere.planet.ground_radius, {nullptr, "altitude"});
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  std::vector<double> wavelengths = options.wavelengths;
  if (wavelengths.empty()) wavelengths.assign(realtime_quad.begin(), realtime_quad.end());
  if (wavelengths.size() % 4) throw InputError("a picture of " + std::to_string(wavelengths.size()) + " wavelengths: expected a multiple of four");
  const std::vector<Xyz> weights = colour_weights(impl_->atmosphere, wavelengths);

  struct Draw {
    const PassInfo* pass;
    std::vector<double> parameters;
    std::vector<Table> inputs;
  };
  const Shape shape{camera.width, camera.height, 1};
  std::vector<Draw> draws;
  for (std::size_t w = 0; w < wavelengths.size(); w += 4) {
    const Quad quad = quad_at(wavelengths, w);
    Binder b = impl_->binder(*impl_->model, quad, camera.altitude);
    const Situation s = impl_->situation(camera.altitude, Impl::datum_for(camera.altitude));
    Fields display{{"disc", {options.sun_disc ? 1.0 : 0.0}}};
    std::array<double, 4> exponent;
    for (std::size_t k = 0; k < 4; ++k) exponent[k] = impl_->atmosphere.sun.limb_darkening.at(quad[k]);
    const DiscInPicture disc = disc_in_picture(camera, to_sun, impl_->atmosphere.sun.angular_radius, exponent);
    display["disc_gain"].assign(disc.gain.begin(), disc.gain.end());
    display["disc_radius"] = {disc.radius};
    display["disc_edge"] = {disc.edge};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto rgb = xyz_to_srgb(weights[w + k]);
      display["red"].push_back(rgb[0]);
      display["green"].push_back(rgb[1]);
      display["blue"].push_back(rgb[2]);
    }
    b.set("camera", camera_fields(camera));
    b.set("observer", observer_fields(to_sun, s.altitude));
    b.set("display", std::move(display));
    const PassInfo& pass = kernel_pass(impl_->model->picture(s));
    draws.push_back({&pass, b.parameters(pass, shape), b.inputs(pass)});
  }

  // A strip of 4 MB stays in the cache until it is written; one that takes long is halved, so that a person can watch and stop.
  int rows = std::max(1, (1 << 18) / camera.width);
  constexpr auto patience = std::chrono::milliseconds(200);
  std::vector<float> rgba, more;
  for (int begin = 0, next = 0; begin < camera.height; begin = next) {
    const auto start = std::chrono::steady_clock::now();
    const int end = std::min(begin + rows, camera.height);
    rgba.resize(4 * std::size_t(end - begin) * std::size_t(camera.width));
    more.resize(draws.size() > 1 ? rgba.size() : 0);
    for (std::size_t d = 0; d < draws.size(); ++d) {
      impl_->engine->draw(*draws[d].pass, draws[d].parameters, draws[d].inputs, shape, begin, end, d == 0 ? rgba : more);
      if (d > 0) {
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
          for (std::size_t c = 0; c < 3; ++c) rgba[i + c] += more[i + c];
        }
      }
    }
    if (!strip(begin, end, rgba)) return false;
    next = end;
    if (std::chrono::steady_clock::now() - start > patience) rows = std::max(1, rows / 2);
  }
  return true;
}

}  // namespace airlight
