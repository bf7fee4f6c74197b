// What a picture with depth needs: the air before its points, and light on its surfaces.
#include <cmath>

#include "airlight/error.h"
#include "engine/stage.h"
#include "sky/checks.h"
#include "sky/colour_answers.h"
#include "sky/sky_impl.h"

namespace airlight {
namespace {

void check_shadows(const AirShadows& shadows) {
  check(shadows.width >= 2 && shadows.width <= 16384, "width of the shadow map", shadows.width, "2 .. 16384");
  check(shadows.height >= 2 && shadows.height <= 16384, "height of the shadow map", shadows.height, "2 .. 16384");
  check(shadows.steps >= 1 && shadows.steps <= 1024, "steps of the shadow map", shadows.steps, "1 .. 1024");
  const double expected = 2.0 * shadows.width * shadows.height;
  const std::size_t given = shadows.edges ? shadows.edges->size() : 0;
  check(double(given) == expected, "values of the shadow map", double(given), "two for each cell");
  for (const float edge : *shadows.edges)
    check(std::isfinite(edge), "an altitude of the shadow map", edge, "a finite number of metres");
}

/// A table that holds as many questions, or a few more: those repeat the last.
Shape shape_for(std::size_t questions) {
  constexpr std::size_t widest = 16384;  // what every graphics card takes
  const std::size_t rows = (questions + widest - 1) / widest;
  return {int((questions + rows - 1) / rows), int(rows), 1};
}

/// Copies one run's answers into questions x wavelengths.
void copy_out(Engine& engine, const Table& table, const Run& run, std::size_t wavelengths, std::span<double> out) {
  if (out.empty()) return;
  if (wavelengths == 4 && out.size() == 4 * table.shape.texels()) return engine.read(table, out);
  std::vector<double> texels(4 * table.shape.texels());
  engine.read(table, texels);
  for (std::size_t i = 0; i < out.size() / wavelengths; ++i) {
    for (const auto& [component, w] : run.parts) out[i * wavelengths + w] = texels[4 * i + component];
  }
}

bool takes(const PassInfo& pass, std::string_view argument) {
  const auto named = [&](const ArgumentInfo& a) { return a.name == argument; };
  return std::ranges::any_of(pass.parameters, named) || std::ranges::any_of(pass.tables, named);
}

}  // namespace

const Table& Sky::Impl::cast(const AirShadows& shadows, double datum) {
  if (shadows.edges && shadows.edges == last_cast.edges && datum == last_cast.datum) return last_cast.table;
  check_shadows(shadows);
  // Beside each cell its neighbour, as the kernel wants it.
  const std::vector<float>& edges = *shadows.edges;
  const auto width = std::size_t(shadows.width);
  std::vector<double> texels(2 * edges.size());
  for (std::size_t i = 0; 2 * i < edges.size(); ++i) {
    const std::size_t next = (i + 1) % width ? i + 1 : i;
    set_texel(texels, i, edges[2 * i] - datum, edges[2 * i + 1] - datum, edges[2 * next] - datum,
              edges[2 * next + 1] - datum);
  }
  last_cast = {shadows.edges, datum, engine->lend({shadows.width, shadows.height, 1}, texels)};
  return last_cast.table;
}

bool Sky::Impl::shades_air(double altitude) const {
  const std::string_view pass = haze_pass(altitude);
  return !pass.empty() && takes(kernel_pass(pass), "shadow");
}

void Sky::Impl::haze(double altitude, const Direction& sun, std::span<const Sight> points,
                     std::span<const double> wavelengths, const AirShadows* shadows, std::span<double> inscatter,
                     std::span<double> transmittance) {
  const std::string_view pass = haze_pass(altitude);
  if (shadows && !shades_air(altitude)) {
    throw InputError("model " + std::string(model->name) + " cannot shade the air for an observer at " +
                     number_text(altitude) + " m: expected a lower one, or no shadows in the air");
  }
  if (pass.empty()) {
    march_haze(altitude, sun, points, wavelengths, inscatter, transmittance);
    return;
  }
  const Shape shape = shape_for(points.size());
  std::vector<double> sights(4 * shape.texels()), offsets(sights.size());
  for (std::size_t i = 0; i < shape.texels(); ++i) {
    const Sight& p = points[std::min(i, points.size() - 1)];
    const Direction view = unit(p.view);
    set_texel(sights, i, view[0], view[1], view[2], std::min(p.distance, 1e15));
    set_texel(offsets, i, p.offset, 0, 0, 0);
  }
  const Table sight_table = engine->lend(shape, sights), offset_table = engine->lend(shape, offsets);
  const double datum = datum_for(altitude);
  const Table shadow_map = shadows ? cast(*shadows, datum) : engine->upload({2, 2, 1}, std::vector<double>(16, 0.0));
  const AirShadows map = shadows ? *shadows : AirShadows{};
  const std::size_t W = answers_for(*model, wavelengths);
  const std::vector<Run> runs = runs_for(*model, wavelengths);
  const Stage whole(*engine, 0.0, 1.0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& run = runs[r];
    const Stage stage(*engine, r, runs.size());
    Binder b = binder(*model, run.quad, altitude);
    b.set("observer", observer_fields(sun, altitude - datum));
    b.set("sun_direction", sun_direction_fields(sun));
    b.set("shadow", Fields{{"across", {map.across.begin(), map.across.end()}},
                           {"along", {map.along.begin(), map.along.end()}},
                           {"highest", {shadows ? map.highest - datum : -1}},
                           {"steps", {double(map.steps)}}});
    b.set("shadow_map", shadow_map);
    b.set("points", sight_table);
    b.set("offsets", offset_table);
    const std::vector<Table> answers = b.run_once(pass, shape);
    copy_out(*engine, answers[0], run, W, inscatter);
    copy_out(*engine, answers[1], run, W, transmittance);
  }
}

void Sky::Impl::surface(std::span<const SurfacePoint> points, double sun_zenith_cosine,
                        std::span<const double> wavelengths, std::span<const double> albedo, std::span<double> radiance,
                        std::span<double> skylight) {
  const Shape shape = shape_for(points.size());
  std::vector<double> places(4 * shape.texels()), normals(places.size());
  for (std::size_t i = 0; i < shape.texels(); ++i) {
    const SurfacePoint& p = points[std::min(i, points.size() - 1)];
    set_texel(places, i, p.altitude, p.sun_zenith_cosine, p.sun_visibility, p.sky_view);
    set_texel(normals, i, p.normal[0], p.normal[1], p.normal[2], p.sun_cosine);
  }
  const Table place_table = engine->lend(shape, places), normal_table = engine->lend(shape, normals);

  std::vector<double> colours;
  const std::size_t W = answers_for(*model, wavelengths);
  const std::vector<Run> runs = runs_for(*model, wavelengths);
  const Stage whole(*engine, 0.0, 1.0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& run = runs[r];
    const Stage stage(*engine, r, runs.size());
    Binder b = binder(*model, run.quad, 0);
    model->colours ? light_in_colours(b, sun_zenith_cosine) : light_from_air(b, sun_zenith_cosine);
    if (W != 4 || points.size() != shape.texels()) {
      colours.assign(4 * shape.texels(), 0.0);
      for (std::size_t i = 0; i < shape.texels(); ++i) {
        for (const auto& [component, w] : run.parts)
          colours[4 * i + component] = albedo[std::min(i, points.size() - 1) * W + w];
      }
    }
    b.set("places", place_table);
    b.set("normals", normal_table);
    b.set("albedos", engine->lend(shape, colours.empty() ? albedo : colours));
    const std::vector<Table> answers = b.run_once(model->surface, shape);
    copy_out(*engine, answers[0], run, W, radiance);
    copy_out(*engine, answers[1], run, W, skylight);
  }
}

void Sky::Impl::light_from_air(Binder& b, double sun_zenith_cosine) {
  // The sky is known for a few altitudes, dense near the ground as the kernel has it, and a few Suns.
  constexpr int azimuths = 12, tilts = 13, altitudes = 12, suns = 5;
  constexpr double spread = 0.0524;  // 3 degrees
  const double highest = std::min(10000.0, 0.3 * atmosphere.planet.top_altitude),
               elevation = std::asin(sun_zenith_cosine);
  const double low_sun = std::sin(std::max(elevation - spread, -1.57)),
               high_sun = std::sin(std::min(elevation + spread, 1.57));
  std::vector<double> eyes(4 * altitudes * suns), sun_rows(eyes.size());
  for (int i = 0; i < altitudes * suns; ++i) {
    const double v = double(i % altitudes) / (altitudes - 1),
                 mu_s = low_sun + (high_sun - low_sun) * (i / altitudes) / (suns - 1);
    set_texel(eyes, std::size_t(i), v * v * highest, 0, 0, 1);
    set_texel(sun_rows, std::size_t(i), 1e15, std::sqrt(1 - mu_s * mu_s), 0, mu_s);
  }
  const Shape rows{1, altitudes * suns, 1};
  b.set("grid", Fields{{"azimuths", {double(azimuths)}},
                       {"tilts", {double(tilts)}},
                       {"altitudes", {double(altitudes)}},
                       {"suns", {double(suns)}},
                       {"highest", {highest}},
                       {"low_sun", {low_sun}},
                       {"high_sun", {high_sun}}});
  b.set("eyes", engine->upload(rows, eyes));
  b.set("suns", engine->upload(rows, sun_rows));
  b.set("sky_light", b.run(model->sky_light, {256, altitudes * suns, 1})[0]);
  b.set("skylight", b.run("core.skylight", {azimuths, tilts * altitudes, suns})[0]);
}

void Sky::Impl::light_in_colours(Binder& b, double sun_zenith_cosine) {
  const Direction sun{std::sqrt(1 - sun_zenith_cosine * sun_zenith_cosine), 0, sun_zenith_cosine};
  b.set("sun_direction", sun_direction_fields(sun));
  if (!takes(kernel_pass(model->surface), "skylight")) return;
  const Shape one{1, 1, 1};
  b.set("eyes", engine->upload(one, std::vector<double>{0, 0, 0, 1}));
  b.set("suns", engine->upload(one, std::vector<double>{1e15, sun[0], sun[1], sun[2]}));
  b.set("sky_light", b.run(model->sky_light, {256, 1, 1})[0]);
  b.set("skylight", b.run("core.sky_irradiance", one)[0]);
}

// The same question asked of the model's rays.
void Sky::Impl::march_haze(double altitude, const Direction& sun, std::span<const Sight> points,
                           std::span<const double> wavelengths, std::span<double> inscatter,
                           std::span<double> transmittance) {
  std::vector<Ray> rays;
  // A point on the ground sphere is where a ray's own ground is, give or take a rounding: its light is the caller's, and air alone is asked.
  std::vector<std::size_t> all, ends, open;
  for (const Sight& p : points) {
    all.push_back(rays.size());
    (std::isinf(p.distance) ? open : ends).push_back(rays.size());
    rays.push_back({altitude, unit(p.view), sun, p.distance});
  }
  if (model->colours) check_answerable(*model, Quantity::transmittance, rays);
  const auto into = [W = answers_for(*model, wavelengths)](std::span<double> out) {
    return [W, out](std::size_t ray, std::size_t w, double value) { out[ray * W + w] = value; };
  };
  if (!ends.empty()) answer(Quantity::path_radiance, rays, ends, wavelengths, *model, into(inscatter));
  if (!open.empty()) answer(Quantity::radiance, rays, open, wavelengths, *model, into(inscatter));
  answer(Quantity::transmittance, rays, all, wavelengths, *model, into(transmittance));
}

bool Sky::shades_air(double altitude) const {
  check_altitude(altitude, impl_->atmosphere.planet.ground_radius, {nullptr, "altitude"});
  return impl_->shades_air(altitude);
}

void Sky::haze(double altitude, Direction sun, std::span<const Sight> points, std::span<const double> wavelengths,
               const AirShadows* shadows, std::span<double> inscatter, std::span<double> transmittance) const {
  check_altitude(altitude, impl_->atmosphere.planet.ground_radius, {nullptr, "altitude"});
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  const std::size_t W = answers_for(*impl_->model, wavelengths), expected = points.size() * W;
  check(inscatter.size() == expected, "size of inscatter", double(inscatter.size()), "points times wavelengths");
  check(transmittance.size() == expected, "size of transmittance", double(transmittance.size()),
        "points times wavelengths");
  for (std::size_t i = 0; i < points.size(); ++i) {
    check(points[i].distance >= 0, {"point", "distance", i}, points[i].distance, "at least 0 m");
    check(points[i].offset >= 0 && points[i].offset < 1, {"point", "offset", i}, points[i].offset, "0 .. 1");
    check_unit(points[i].view, {"point", "view", i});
  }
  if (points.empty() || W == 0) return;
  impl_->haze(altitude, to_sun, points, wavelengths, shadows, inscatter, transmittance);
}

void Sky::surface(std::span<const SurfacePoint> points, double sun_zenith_cosine, std::span<const double> wavelengths,
                  std::span<const double> albedo, std::span<double> radiance, std::span<double> skylight) const {
  check(std::abs(sun_zenith_cosine) <= 1, "sun_zenith_cosine", sun_zenith_cosine, "-1 .. 1");
  if (impl_->model->surface.empty())
    throw InputError("model " + std::string(impl_->model->name) + " says nothing on light that surfaces reflect");
  const std::size_t W = answers_for(*impl_->model, wavelengths), expected = points.size() * W;
  check(albedo.size() == expected, "size of albedo", double(albedo.size()), "points times wavelengths");
  check(radiance.size() == expected, "size of radiance", double(radiance.size()), "points times wavelengths");
  check(skylight.empty() || skylight.size() == expected, "size of skylight", double(skylight.size()),
        "points times wavelengths, or 0");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    check_altitude(p.altitude, impl_->atmosphere.planet.ground_radius, {"point", "altitude", i});
    check_unit(p.normal, {"point", "normal", i});
    check(std::abs(p.sun_zenith_cosine) <= 1, {"point", "sun_zenith_cosine", i}, p.sun_zenith_cosine, "-1 .. 1");
    check(std::abs(p.sun_cosine) <= 1, {"point", "sun_cosine", i}, p.sun_cosine, "-1 .. 1");
    check(p.sun_visibility >= 0 && p.sun_visibility <= 1, {"point", "sun_visibility", i}, p.sun_visibility, "0 .. 1");
    check(p.sky_view >= 0 && p.sky_view <= 1, {"point", "sky_view", i}, p.sky_view, "0 .. 1");
  }
  for (const double a : albedo) check(a >= 0 && a <= 1, "albedo", a, "0 .. 1");
  if (!points.empty() && W > 0) impl_->surface(points, sun_zenith_cosine, wavelengths, albedo, radiance, skylight);
}

}  // namespace airlight
