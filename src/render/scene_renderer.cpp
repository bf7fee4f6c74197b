#include "render/scene_renderer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "airlight/error.h"
#include "airlight/model_info.h"
#include "model/model.h"
#include "optics/number_text.h"
#include "render/air_light.h"
#include "render/air_shadows.h"
#include "render/ground_light.h"
#include "render/light_disc.h"
#include "scene/sky_view.h"
#include "sky/camera.h"
#include "sky/channel_colours.h"

namespace airlight {
namespace {

constexpr int sky_view_cells = 160;  // of each of two maps

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Direction unit(const Direction& d) {
  const double n = std::sqrt(dot(d, d));
  return {d[0] / n, d[1] / n, d[2] / n};
}
Direction wide(const std::array<float, 3>& a) { return {double(a[0]), double(a[1]), double(a[2])}; }

int checked_samples(int samples) {
  const int side = int(std::lround(std::sqrt(samples)));
  if (samples < 1 || samples > 256 || side * side != samples)
    throw InputError("samples = " + std::to_string(samples) + ": expected a square number, 1 .. 256");
  return samples;
}

template <class Work>
void in_parallel(std::size_t count, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 2048), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
  });
}

LevelOfDetail level_of_detail(const PlacedCamera& camera, double pixels) {
  LevelOfDetail detail = camera.detail();
  detail.pixels = pixels;
  return detail;
}

/// What the sky is asked at; nothing where its colours stand for no wavelengths.
std::vector<double> sky_wavelengths(const Sky& sky, const ColourModel* colours, const SceneOptions& options) {
  if (colours) return colours->wavelengths;
  if (!options.wavelengths.empty()) return options.wavelengths;
  const auto quad = sky.realtime_wavelengths();
  return {quad.begin(), quad.end()};
}

bool means_corners(const Sky& sky) {
  const Model& model = find_model(sky.model());
  if (!model.haze_at_corners) return false;
  const Values values = model_parameters(model, sky.parameters(), "");
  return model.haze_at_corners(values);
}

/// Land has a colour at wavelengths. Colours that stand for none are taken at the dominant wavelengths of sRGB's primaries.
std::vector<double> albedo_wavelengths(const std::vector<double>& asked) {
  return asked.empty() ? std::vector<double>{611, 549, 464} : asked;
}

}  // namespace

struct SceneRenderer::Impl {
  const Sky& sky;
  std::shared_ptr<const Land> land;
  SceneView view;
  SceneOptions options;
  int samples, width;
  Position eye;
  double altitude, pixel;  // of the eye [m]; of a pixel [rad]
  Terrain terrain;
  const ColourModel* colours;       // set: the model answers in red, green and blue
  std::vector<double> wavelengths;  // that the sky is asked at
  std::size_t channels;             // numbers that answer one question
  bool haze_at_corners;             // of triangles alone, as the model means it
  SurfaceColour colour;
  SkyViewMap sky_view, sky_view_near;  // the same, finer around the eye
  ChannelColours to_rgb;               // a channel: linear sRGB of its radiance
  std::vector<std::function<std::optional<Direction>(double u, double v)>> faces;  // a cube has six, other pictures one
  struct Light {
    const Sky* sky;
    Direction direction, at_eye;          // towards it, in the scene's frame and the eye's
    double radius;                        // [rad]
    std::optional<ShadowMap> shadow_map;  // and what the air makes of it
    std::optional<AirShadows> shadows;
    std::optional<LightDisc> disc;
  };
  std::vector<Light> lights;          // the Sun first
  std::vector<AirLight> more_in_air;  // the others, as the air is asked

  Impl(const Sky& s, std::shared_ptr<const Land> l, const SurfaceSettings& surface, const SceneView& v,
       const SceneOptions& o)
      : sky(s),
        land(std::move(l)),
        view(v),
        options(o),
        samples(checked_samples(o.samples)),
        width(v.camera.camera.width * (v.camera.camera.projection == Projection::cube ? 6 : 1)),
        eye(v.camera.eye),
        altitude(land->frame().altitude(eye)),
        pixel(v.camera.detail().pixel_angle),
        terrain(land, level_of_detail(v.camera, o.triangle_pixels)),
        colours(model_info(s.model()).colours),
        wavelengths(sky_wavelengths(s, colours, o)),
        channels(colours ? 3 : 4),
        haze_at_corners(means_corners(s)),
        colour(surface, land, albedo_wavelengths(wavelengths)),
        to_rgb(colours ? primaries(colours->luminance) : srgb_weights(s.atmosphere(), wavelengths)) {
    if (colours && !view.more_lights.empty())
      throw InputError("model " + std::string(sky.model()) +
                       " knows one light, its sun: expected a scene without others");
    const double reach = std::min(options.shadow_grid.half_width, land->extent());
    const GroundPoint below = land->frame().ground(eye);
    sky_view = sky_view_map(*land, below.east, below.north, reach, sky_view_cells);
    sky_view_near = sky_view_map(*land, below.east, below.north, 0.25 * reach, sky_view_cells);
    Camera camera = view.camera.camera;
    for (camera.face = 0; camera.face < width / camera.width; ++camera.face) faces.push_back(viewer(camera));
    lights.push_back(light(sky, view.sun));
    for (const MoreLight& more : view.more_lights) lights.push_back(light(*more.sky, more.direction));
    for (std::size_t i = 1; i < lights.size(); ++i)
      more_in_air.push_back({lights[i].sky, lights[i].at_eye, lights[i].shadows ? &*lights[i].shadows : nullptr});
  }

  Light light(const Sky& of, const Direction& direction) const {
    const Sun& source = of.atmosphere().sun;
    Light result{&of, direction, view.camera.from_scene(direction), source.angular_radius, {}, {}, {}};
    if (options.air_shadows) {
      ShadowGrid grid = options.shadow_grid;
      grid.east = eye[0];
      grid.north = eye[1];
      const LevelOfDetail seen = view.camera.detail();
      grid.axis = seen.axis;
      grid.half_angle = seen.half_angle;
      // Several samples mostly share one look at the air, which may then be closer.
      const int steps = options.shadow_steps * (samples > 1 ? 2 : 1);
      result.shadow_map = shadow_map(*land, direction, source.angular_radius, grid);
      result.shadows = air_shadows(*result.shadow_map, view.camera, steps);
    }
    if (options.sun_disc) result.disc = disc(result);
    return result;
  }

  std::optional<LightDisc> disc(const Light& light) const {
    const Camera& camera = view.camera.camera;
    const int count = int(faces.size());
    if (!colours) return LightDisc(camera, count, light.at_eye, light.sky->atmosphere().sun, wavelengths);
    // A system of colours has an even disc of the sunlight that arrives; some have none, or one of their own making.
    if (colours->sun_radius == 0) return {};
    std::array<double, 4> arriving{};
    const Ray ray{.altitude = altitude, .view = {0, 0, 1}, .sun = light.at_eye};
    sky.evaluate(Quantity::sun_irradiance, {&ray, 1}, wavelengths, std::span(arriving).first(channels));
    return LightDisc(camera, count, light.at_eye, colours->sun_radius, {}, arriving);
  }

  double sky_seen(const GroundPoint& g) const {
    constexpr double edge = 8;  // cells over which one map takes over from the other
    const double near = std::clamp(sky_view_near.inside(g.east, g.north) / edge, 0.0, 1.0);
    const double fine = near > 0 ? sky_view_near.at(g.east, g.north) : 0;
    const double coarse = near < 1 ? sky_view.at(g.east, g.north) : 0;
    return std::clamp(near * fine + (1 - near) * coarse, 0.0, 1.0);
  }

  std::array<double, 3> rgb(const double* spectrum) const {
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < channels; ++k) {
      for (std::size_t c = 0; c < 3; ++c) out[c] += to_rgb[k][c] * spectrum[k];
    }
    return out;
  }

  // The direction at picture coordinates; a cube's faces lie side by side.
  std::optional<Direction> look(double u, double v) const {
    const double across = u * double(faces.size());
    const std::size_t face = std::min(std::size_t(std::max(across, 0.0)), faces.size() - 1);
    return faces[face](across - double(face), v);
  }

  // The samples of a strip, one after the other, pixel by pixel, each column from the top: neighbours in all directions then share packets
  // of rays and of lanes. One object serves all strips.
  struct Samples {
    std::vector<Sight> sights;
    std::vector<char> inside;
    std::vector<SceneRay> rays;
    std::vector<TerrainHit> hits;
    std::vector<int> nth_on_ground;  // place in the ground's lists; -1: the sky
    std::vector<int> nth_in_air;     // place in the air's lists
    // The air before samples; those of a pixel that lie equally far off share it.
    std::vector<Sight> air;
    std::vector<double> inscatter, transmittance;  // `channels` each
    std::vector<double> corner_inscatter, corner_transmittance;
    // Of those on the ground alone.
    std::vector<std::size_t> on_ground;
    std::vector<SunQuestion> questions;
    std::vector<float> answers, sun_visibility;
    std::vector<SurfacePoint> points;
    std::vector<double> albedo, surface, skylight;  // `channels` each
  };

  void see_rows(int begin, int end, Samples& s) const {
    const Camera& camera = view.camera.camera;
    const std::size_t count = std::size_t(end - begin) * std::size_t(width) * std::size_t(samples);
    const int side = int(std::lround(std::sqrt(samples)));
    s.sights.resize(count);
    s.inside.resize(count);
    in_parallel(count, [&](std::size_t i) {
      const std::size_t nth = i / std::size_t(samples), sample = i % std::size_t(samples);
      const std::size_t rows = std::size_t(end - begin);
      const double x = double(nth / rows), y = double(begin) + double(nth % rows);
      const double dx = (double(sample % std::size_t(side)) + 0.5) / side,
                   dy = (double(sample / std::size_t(side)) + 0.5) / side;
      const std::optional<Direction> seen = look((x + dx) / width, (y + dy) / camera.height);
      s.inside[i] = seen.has_value();
      s.sights[i] = {seen.value_or(Direction{0, 0, 1}), std::numeric_limits<double>::infinity(),
                     shadow_offset(x, y, double(sample))};
    });
    see(s);
  }

  // Row by row: a picture's rays at once would be as large as its samples.
  std::vector<char> sky_pixels() const {
    const int height = view.camera.camera.height;
    std::vector<char> open;
    std::vector<SceneRay> rays;
    std::vector<TerrainHit> hits;
    for (int y = 0; y < height; ++y) {
      rays.clear();
      for (int x = 0; x < width; ++x) {
        const std::optional<Direction> seen = look((x + 0.5) / width, (y + 0.5) / height);
        rays.push_back({eye, view.camera.to_scene(seen.value_or(Direction{0, 0, 1}))});
        open.push_back(seen.has_value());
      }
      hits.resize(rays.size());
      terrain.hits(rays, hits);
      for (std::size_t x = 0; x < hits.size(); ++x) {
        if (hits[x].hit()) open[std::size_t(y) * hits.size() + x] = 0;
      }
    }
    return open;
  }

  // What the samples' lines of sight meet, and all its light.
  void see(Samples& s) const {
    const std::size_t count = s.sights.size();
    s.rays.resize(count);
    in_parallel(count, [&](std::size_t i) { s.rays[i] = {eye, view.camera.to_scene(s.sights[i].view)}; });
    s.hits.resize(count);
    terrain.hits(s.rays, s.hits);
    s.on_ground.clear();
    s.nth_on_ground.assign(count, -1);
    for (std::size_t i = 0; i < count; ++i) {
      if (!s.hits[i].hit()) continue;
      s.nth_on_ground[i] = int(s.on_ground.size());
      s.on_ground.push_back(i);
      s.sights[i].distance = s.hits[i].distance;
    }
    shade(s);

    if (haze_at_corners) {
      air_from_corners(s);
    } else {
      share_air(s);
      ask_air(s.air, s.inscatter, s.transmittance);
    }
  }

  void ask_air(const std::vector<Sight>& points, std::vector<double>& inscatter,
               std::vector<double>& transmittance) const {
    inscatter.resize(channels * points.size());
    transmittance.resize(channels * points.size());
    const Light& sun = lights[0];
    sky.haze(altitude, sun.at_eye, points, wavelengths, sun.shadows ? &*sun.shadows : nullptr, inscatter,
             transmittance);
    add_haze(more_in_air, altitude, points, wavelengths, inscatter);
    // The disc of a system of colours is of the light that arrives: no air dims it again.
    for (std::size_t i = 0; colours && i < points.size(); ++i) {
      if (std::isinf(points[i].distance)) std::fill_n(&transmittance[channels * i], channels, 1.0);
    }
  }

  // As a graphics card does that is told nothing between corners: the air before the corners of the triangles that samples meet, and
  // between them its values weighted as the corners are. Each corner is asked for once.
  void air_from_corners(Samples& s) const {
    const std::size_t count = s.sights.size();
    std::unordered_map<std::size_t, std::size_t> places;
    std::vector<std::array<std::pair<std::size_t, double>, 3>> parts(count);  // place in the air's lists, weight
    s.air.clear();
    s.nth_in_air.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      s.nth_in_air[i] = int(i);
      if (!s.hits[i].hit() || !s.hits[i].mesh) {
        parts[i] = {{{s.air.size(), 1}, {s.air.size(), 0}, {s.air.size(), 0}}};
        s.air.push_back(s.sights[i]);
        continue;
      }
      const TerrainTriangle triangle = terrain.triangle(s.hits[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [place, is_new] = places.try_emplace(triangle.numbers[c], s.air.size());
        if (is_new) s.air.push_back(sight_of(triangle.corners[c]));
        parts[i][c] = {place->second, triangle.weights[c]};
      }
    }
    ask_air(s.air, s.corner_inscatter, s.corner_transmittance);
    s.inscatter.assign(channels * count, 0);
    s.transmittance.assign(channels * count, 0);
    in_parallel(count, [&](std::size_t i) {
      for (const auto& [place, weight] : parts[i]) {
        for (std::size_t k = 0; k < channels; ++k) {
          s.inscatter[channels * i + k] += weight * s.corner_inscatter[channels * place + k];
          s.transmittance[channels * i + k] += weight * s.corner_transmittance[channels * place + k];
        }
      }
    });
  }

  Sight sight_of(const Position& p) const {
    const Direction to{p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]};
    const double distance = std::sqrt(dot(to, to));
    return {distance > 0 ? view.camera.from_scene(unit(to)) : Direction{0, 0, 1}, distance};
  }

  // Light and transmittance of the air are smooth: over a pixel whose samples' distances differ by a fiftieth at most, those of its
  // middle differ from the samples' mean by less than a thousandth.
  void share_air(Samples& s) const {
    constexpr double alike = 1.02;
    const std::size_t count = s.sights.size(), per_pixel = std::min(std::size_t(samples), count);
    s.air.clear();
    s.nth_in_air.resize(count);
    for (std::size_t first = 0; first < count; first += per_pixel) {
      const auto sights = std::span(s.sights).subspan(first, per_pixel);
      Sight middle{{0, 0, 0}, 0, sights[0].offset};
      double near = sights[0].distance, far = near;
      bool whole = true;
      for (std::size_t i = 0; i < per_pixel; ++i) {
        near = std::min(near, sights[i].distance), far = std::max(far, sights[i].distance);
        whole = whole && s.inside[first + i];
        for (std::size_t c = 0; c < 3; ++c) middle.view[c] += sights[i].view[c];
        middle.distance += sights[i].distance / double(per_pixel);
      }
      const bool shared = whole && (near == far || far <= alike * near);
      for (std::size_t i = 0; i < per_pixel; ++i) s.nth_in_air[first + i] = int(s.air.size() + (shared ? 0 : i));
      if (shared) {
        middle.view = unit(middle.view);
        s.air.push_back(middle);
      } else {
        s.air.insert(s.air.end(), sights.begin(), sights.end());
      }
    }
  }

  // What comes from the far end of a sample's line of sight: light of the ground, or of discs.
  std::array<double, 4> behind(const Samples& s, std::size_t i) const {
    std::array<double, 4> light{};
    if (const int n = s.nth_on_ground[i]; n >= 0) {
      std::copy_n(&s.surface[channels * std::size_t(n)], channels, light.begin());
    } else {
      for (const Light& source : lights) {
        if (!source.disc) continue;
        const auto more = source.disc->radiance(s.sights[i].view);
        for (std::size_t k = 0; k < channels; ++k) light[k] += more[k];
      }
    }
    return light;
  }

  Answer at(double u, double v) const {
    const std::optional<Direction> seen = look(u, v);
    if (!seen)
      throw InputError("picture coordinates (" + number_text(u) + ", " + number_text(v) +
                       "): outside the fisheye's circle");
    Samples s;
    s.sights = {{*seen}};
    s.inside = {1};
    see(s);
    Answer answer{*seen, lights[0].at_eye, view.camera.to_scene(*seen), s.hits[0].distance, {}, {}, behind(s, 0)};
    for (std::size_t k = 0; k < channels; ++k) {
      answer.inscatter[k] = s.inscatter[k];
      answer.transmittance[k] = s.transmittance[k];
    }
    return answer;
  }

  // What leaves the ground towards the eye.
  void shade(Samples& s) const {
    const std::vector<std::size_t>& which = s.on_ground;
    if (which.empty()) return;
    s.sun_visibility.resize(which.size());
    s.points.resize(which.size());
    for (auto* spectra : {&s.albedo, &s.surface, &s.skylight}) spectra->resize(channels * which.size());
    constexpr std::size_t lanes = SurfaceColour::lanes;
    in_parallel((which.size() + lanes - 1) / lanes, [&](std::size_t packet) {
      const std::size_t begin = packet * lanes, end = std::min(begin + lanes, which.size());
      const TerrainHit* hits[lanes];
      for (std::size_t j = begin; j < end; ++j) hits[j - begin] = &s.hits[which[j]];
      colour.albedo({hits, end - begin}, pixel,
                    std::span(s.albedo).subspan(channels * begin, channels * (end - begin)));
    });
    light_up(lights[0], s, s.sun_visibility, s.surface, s.skylight);
    if (lights.size() == 1) return;
    std::vector<float> visibility(which.size());
    std::vector<double> surface(s.surface.size()), skylight(s.skylight.size());
    for (std::size_t n = 1; n < lights.size(); ++n) {
      light_up(lights[n], s, visibility, surface, skylight);
      for (std::size_t i = 0; i < surface.size(); ++i) s.surface[i] += surface[i], s.skylight[i] += skylight[i];
    }
  }

  // How much of a light's disc the ground sees. Far below the edge of a shadow the map knows; elsewhere rays tell.
  void see_light(const Light& light, Samples& s, std::span<float> visibility) const {
    constexpr double margin = 100;  // [m] more than the map's cells cut off a ridge
    const std::vector<std::size_t>& which = s.on_ground;
    in_parallel(which.size(), [&](std::size_t j) {
      const TerrainHit& hit = s.hits[which[j]];
      visibility[j] =
          light.shadow_map && light.shadow_map->surely_dark(hit.position, hit.ground.altitude, margin) ? 0.0f : 1.0f;
    });
    s.questions.clear();
    for (std::size_t j = 0; j < which.size(); ++j) {
      const TerrainHit& hit = s.hits[which[j]];
      if (visibility[j] > 0) s.questions.push_back(terrain.sun_question(hit));
    }
    s.answers.resize(s.questions.size());
    terrain.sun_visibility(s.questions, light.direction, options.soft_shadows ? light.radius : 0.0, s.answers);
    for (std::size_t j = 0, n = 0; j < which.size(); ++j)
      if (visibility[j] > 0) visibility[j] = s.answers[n++];
  }

  // What of one light the ground sends on.
  void light_up(const Light& light, Samples& s, std::span<float> visibility, std::span<double> surface,
                std::span<double> skylight) const {
    const std::vector<std::size_t>& which = s.on_ground;
    see_light(light, s, visibility);
    in_parallel(which.size(), [&](std::size_t j) {
      const TerrainHit& hit = s.hits[which[j]];
      const Direction up = land->frame().up(hit.position), normal = wide(hit.shading_normal);
      const double mu_s = std::clamp(dot(up, light.direction), -1.0, 1.0), nz = std::clamp(dot(normal, up), -1.0, 1.0);
      const double cosine = std::clamp(dot(normal, light.direction), -1.0, 1.0);
      const double sin_s = std::sqrt(std::max(1 - mu_s * mu_s, 1e-12)), across = std::sqrt(std::max(1 - nz * nz, 0.0));
      const double nx = std::clamp((cosine - nz * mu_s) / sin_s, -across, across);
      SurfacePoint& p = s.points[j];
      p.altitude = hit.ground.altitude;
      p.sun_zenith_cosine = mu_s;
      p.sun_cosine = cosine;
      p.normal = {nx, std::sqrt(std::max(1 - nz * nz - nx * nx, 0.0)), nz};
      // The air's own sunlight knows the planet's horizon: land takes a part of what that leaves.
      const double above =
          mu_s > light.radius ? 1 : disc_above_sphere(mu_s, hit.ground.altitude, land->frame().radius(), light.radius);
      p.sun_visibility = above > 0 ? std::clamp(double(visibility[j]) / above, 0.0, 1.0) : 0.0;
      p.sky_view = hit.mesh ? sky_seen(hit.ground) : 1.0;
    });
    ground_light(*light.sky, s.points, std::clamp(light.at_eye[2], -1.0, 1.0), wavelengths, s.albedo, surface,
                 skylight);
  }

  // Means over the samples of each pixel.
  SceneRows rows(const Samples& s, int begin, int end, bool layers) const {
    const std::size_t pixels = std::size_t(end - begin) * std::size_t(width), per_pixel = std::size_t(samples);
    SceneRows out;
    out.begin = begin;
    out.end = end;
    out.rgb.resize(3 * pixels);
    in_parallel(pixels, [&](std::size_t p) {
      std::array<double, 4> seen{};
      const std::size_t first = first_sample(out, p);
      for (std::size_t i = first; i < first + per_pixel; ++i) {
        if (!s.inside[i]) continue;
        const std::array<double, 4> light = behind(s, i);
        const double *inscatter = &s.inscatter[channels * std::size_t(s.nth_in_air[i])],
                     *transmittance = &s.transmittance[channels * std::size_t(s.nth_in_air[i])];
        for (std::size_t k = 0; k < channels; ++k) seen[k] += inscatter[k] + light[k] * transmittance[k];
      }
      put(out.rgb, p, rgb(seen.data()), 1 / double(per_pixel));
    });
    if (layers) fill_layers(s, out);
    return out;
  }

  // Of a pixel, counted along rows.
  std::size_t first_sample(const SceneRows& out, std::size_t place) const {
    const auto x = place % std::size_t(width), y = place / std::size_t(width), rows = std::size_t(out.end - out.begin);
    return (x * rows + y) * std::size_t(samples);
  }

  static void put(std::vector<float>& layer, std::size_t pixel, const std::array<double, 3>& value, double factor) {
    for (std::size_t c = 0; c < 3; ++c) layer[3 * pixel + c] = float(value[c] * factor);
  }

  void fill_layers(const Samples& s, SceneRows& out) const {
    const std::size_t pixels = out.rgb.size() / 3, per_pixel = std::size_t(samples);
    for (auto* layer : {&out.surface, &out.transmittance, &out.inscatter, &out.position, &out.normal, &out.albedo,
                        &out.sky_irradiance})
      layer->resize(3 * pixels);
    if (!colours) {
      for (auto* layer : {&out.spectral_surface, &out.spectral_transmittance, &out.spectral_inscatter})
        layer->resize(4 * pixels);
    }
    out.depth.resize(pixels);
    out.sun_visibility.resize(pixels);
    // Albedo as the colour that sunlight outside the air takes on, relative to that of white.
    std::array<double, 4> white_light{1, 1, 1, 0};
    for (std::size_t k = 0; k < 4 && !colours; ++k) white_light[k] = sky.atmosphere().sun.irradiance.at(wavelengths[k]);
    const std::array<double, 3> white = rgb(white_light.data());
    in_parallel(pixels, [&](std::size_t p) {
      std::array<double, 4> surface{}, arriving{}, through{}, inscatter{}, skylight{}, reflected{};
      double distance = 0, visible = 0, hits = 0;
      Direction position{}, normal{};
      const std::size_t first = first_sample(out, p);
      for (std::size_t i = first; i < first + per_pixel; ++i) {
        if (!s.inside[i]) continue;
        const std::array<double, 4> light = behind(s, i);
        const auto in_air = std::size_t(s.nth_in_air[i]);
        for (std::size_t k = 0; k < channels; ++k) {
          surface[k] += light[k];
          arriving[k] += light[k] * s.transmittance[channels * in_air + k];
          through[k] += s.transmittance[channels * in_air + k];
          inscatter[k] += s.inscatter[channels * in_air + k];
        }
        if (s.nth_on_ground[i] < 0) continue;
        const auto n = std::size_t(s.nth_on_ground[i]);
        const TerrainHit& hit = s.hits[i];
        hits += 1;
        distance += hit.distance;
        visible += double(s.sun_visibility[n]);
        for (std::size_t k = 0; k < channels; ++k) {
          skylight[k] += s.skylight[channels * n + k];
          reflected[k] += s.albedo[channels * n + k] * white_light[k];
        }
        for (std::size_t c = 0; c < 3; ++c) {
          position[c] += hit.position[c];
          normal[c] += double(hit.shading_normal[c]);
        }
      }
      const double scale = 1 / double(per_pixel), of_hits = hits > 0 ? 1 / hits : 0;
      put(out.surface, p, rgb(surface.data()), scale);
      put(out.inscatter, p, rgb(inscatter.data()), scale);
      for (std::size_t c = 0; c < 3; ++c) {
        const float leaving = out.surface[3 * p + c];
        out.transmittance[3 * p + c] =
            leaving != 0 ? (out.rgb[3 * p + c] - out.inscatter[3 * p + c]) / leaving
                         : float((through[0] + through[1] + through[2] + through[3]) * scale / double(channels));
      }
      for (std::size_t k = 0; k < 4 && !colours; ++k) {
        out.spectral_surface[4 * p + k] = float(surface[k] * scale);
        out.spectral_transmittance[4 * p + k] = float(surface[k] > 0 ? arriving[k] / surface[k] : through[k] * scale);
        out.spectral_inscatter[4 * p + k] = float(inscatter[k] * scale);
      }
      put(out.sky_irradiance, p, rgb(skylight.data()), of_hits);
      const auto sent = rgb(reflected.data());
      put(out.albedo, p, {sent[0] / white[0], sent[1] / white[1], sent[2] / white[2]}, of_hits);
      put(out.position, p, position, of_hits);
      put(out.normal, p, hits > 0 ? unit(normal) : Direction{}, 1);
      out.depth[p] = 2 * hits >= double(per_pixel) ? float(distance * of_hits) : std::numeric_limits<float>::infinity();
      out.sun_visibility[p] = float(visible * of_hits);
    });
  }
};

SceneRenderer::SceneRenderer(const Sky& sky, std::shared_ptr<const Land> land, const SurfaceSettings& surface,
                             const SceneView& view, const SceneOptions& options)
    : impl_(std::make_unique<Impl>(sky, std::move(land), surface, view, options)) {}
SceneRenderer::~SceneRenderer() = default;

SceneRenderer::Answer SceneRenderer::at(double u, double v) const { return impl_->at(u, v); }

std::vector<char> SceneRenderer::sky_pixels() const { return impl_->sky_pixels(); }

int SceneRenderer::width() const { return impl_->width; }
const Terrain& SceneRenderer::terrain() const { return impl_->terrain; }

bool SceneRenderer::render(const std::function<bool(const SceneRows&)>& rows, bool layers) const {
  const Camera& camera = impl_->view.camera.camera;
  constexpr int samples_at_once = 1 << 13;  // their arrays stay in the second cache
  const int step = std::max(1, samples_at_once / (impl_->width * impl_->samples));
  Impl::Samples samples;
  for (int begin = 0; begin < camera.height; begin += step) {
    const int end = std::min(begin + step, camera.height);
    impl_->see_rows(begin, end, samples);
    if (!rows(impl_->rows(samples, begin, end, layers))) return false;
  }
  return true;
}

}  // namespace airlight
