#include "airlight/sky.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "airlight/error.h"
#include "engine/stage.h"
#include "optics/colour.h"
#include "sky/checks.h"
#include "sky/colour_answers.h"
#include "sky/sky_impl.h"

namespace airlight {
namespace {

double length(const Direction& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A ray from space, begun where it enters the air: in float its lowest point would be uncertain by half a metre, which is 2e-5 of
// a grazing ray's transmittance. Rays that miss the air are left alone. Radius and top are those of the datum.
Ray from_entry(const Ray& ray, double ground_radius, double top) {
  const double r = ground_radius + ray.altitude, outer = ground_radius + top, along = -r * ray.view[2];
  const double across = r * std::hypot(ray.view[0], ray.view[1]),
               half_chord = std::sqrt(std::max(outer * outer - across * across, 0.0));
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

}  // namespace

void Sky::Impl::answer(Quantity quantity, std::span<const Ray> rays, std::span<const std::size_t> which,
                       std::span<const double> wavelengths, const Model& m, const Put& put) {
  const bool sky_light = quantity == Quantity::sky_irradiance;  // sums over directions: observers are rows
  const int count = int(which.size()), width = sky_light ? 1 : std::min(count, 1024),
            height = (count + width - 1) / width;
  const Shape shape{width, height, 1};
  std::vector<double> eyes(4 * shape.texels()), suns(eyes.size());
  const double datum = datum_for(rays[which[0]].altitude);
  for (std::size_t i = 0; i < shape.texels(); ++i) {
    Ray r = rays[which[std::min(i, which.size() - 1)]];
    r.altitude -= datum;
    if (quantity < Quantity::sun_irradiance && !m.colours)
      r = from_entry(r, atmosphere.planet.ground_radius + datum, atmosphere.planet.top_altitude - datum);
    // Far beyond any air; float squares it.
    const double distance = std::min(r.distance, 1e15);
    set_texel(eyes, i, r.altitude, r.view[0], r.view[1], r.view[2]);
    set_texel(suns, i, distance, r.sun[0], r.sun[1], r.sun[2]);
  }
  std::vector<double> texels(4 * shape.texels()), more(texels.size());
  const std::vector<Run> runs = runs_for(m, wavelengths);
  const Stage whole(*engine, 0.0, 1.0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& run = runs[r];
    const Stage stage(*engine, r, runs.size());
    Binder b = binder(m, run.quad, rays[which[0]].altitude);
    b.set("eyes", engine->upload(shape, eyes));
    b.set("suns", engine->upload(shape, suns));
    std::vector<Table> answers;
    if (sky_light) {
      b.set("sky_light", b.run(m.sky_light, {256, height, 1})[0]);
      answers = b.run("core.sky_irradiance", shape);
    } else {
      const bool alone = quantity == Quantity::transmittance && !m.transmittance.empty();
      answers = b.run(quantity == Quantity::sun_irradiance ? m.sun : alone ? m.transmittance : m.rays, shape);
    }
    // rays: path radiance, transmittance unless a pass of its own answers it, ground
    const std::size_t part = quantity == Quantity::transmittance && m.transmittance.empty() ? 1 : 0;
    engine->read(answers[part], texels);
    if (quantity == Quantity::radiance) {
      engine->read(answers[m.transmittance.empty() ? 2 : 1], more);
      for (std::size_t i = 0; i < texels.size(); ++i) texels[i] += more[i];
    }
    for (std::size_t i = 0; i < which.size(); ++i) {
      for (const auto& [component, w] : run.parts) put(which[i], w, texels[4 * i + component]);
    }
  }
}

Sky::Sky(Atmosphere atmosphere, std::string_view model, std::shared_ptr<Engine> engine, const Parameters& parameters)
    : impl_(std::make_unique<Impl>()) {
  validate(atmosphere);
  impl_->atmosphere = std::move(atmosphere);
  impl_->model = &find_model(model);
  impl_->engine = std::move(engine);
  impl_->parameters = model_parameters(*impl_->model, parameters, std::string(impl_->model->name) + ".");
}
Sky::~Sky() = default;
Sky::Sky(Sky&&) noexcept = default;
Sky& Sky::operator=(Sky&&) noexcept = default;

const Atmosphere& Sky::atmosphere() const { return impl_->atmosphere; }
std::string_view Sky::model() const { return impl_->model->name; }
const Parameters& Sky::parameters() const { return impl_->parameters.all(); }
std::vector<std::string> Sky::warnings() const {
  return impl_->model->warnings ? impl_->model->warnings(impl_->parameters) : std::vector<std::string>{};
}
Engine& Sky::engine() const { return *impl_->engine; }
std::array<double, 4> Sky::realtime_wavelengths() const { return realtime_quad; }

void Sky::evaluate(Quantity quantity, std::span<const Ray> rays, std::span<const double> wavelengths,
                   std::span<double> out, int max_order) const {
  const Model& own = *impl_->model;
  const std::size_t W = answers_for(own, wavelengths);
  if (out.size() != rays.size() * W) {
    throw InputError("size of out = " + std::to_string(out.size()) + ": expected " + std::to_string(rays.size() * W) +
                     ", rays times wavelengths");
  }
  if (own.colours) check_answerable(own, quantity, rays);
  if (max_order < 0 || max_order > 1)
    throw InputError("max_order = " + std::to_string(max_order) + ": expected 0 (all) or 1 for this model");
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
  if (rays.empty() || W == 0) return;
  if (own.colours && max_order != 0)
    throw InputError("max_order = 1: expected 0: model " + std::string(own.name) + " has no orders of scattering");
  // Light of the first order is what `single` computes.
  const Model& model = max_order == 1 ? find_model("single") : own;
  std::vector<double> answers(out.size());
  const Stage whole(*impl_->engine, 0.0, 1.0);
  for (const auto& [datum, group] : groups) {
    // In parts, so that the tables of a million rays fit an engine.
    constexpr std::size_t part = 4096;
    for (std::size_t begin = 0; begin < group.size(); begin += part) {
      impl_->answer(quantity, checked, std::span(group).subspan(begin, std::min(part, group.size() - begin)),
                    wavelengths, model,
                    [&](std::size_t ray, std::size_t w, double value) { answers[ray * W + w] = value; });
    }
  }
  std::ranges::copy(answers, out.begin());
}

}  // namespace airlight
