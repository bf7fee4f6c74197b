#include "render/scene_renderer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "optics/colour.h"
#include "optics/number_text.h"
#include "scene/sky_view.h"
#include "sky/camera.h"

namespace airlight {
namespace {

constexpr int sky_view_cells = 512;
constexpr double least_height = 0.5;  // of the eye above the ground [m]

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Direction unit(const Direction& d) {
  const double n = std::sqrt(dot(d, d));
  return {d[0] / n, d[1] / n, d[2] / n};
}
Direction wide(const std::array<float, 3>& a) { return {double(a[0]), double(a[1]), double(a[2])}; }

/// East, north and up at a point of the scene, in the scene's frame: north is the scene's, laid level.
struct EyeFrame {
  Direction east, north, up;
  EyeFrame(const LocalFrame& frame, const Position& p) : up(frame.up(p)) {
    east = unit({1 - up[0] * up[0], -up[0] * up[1], -up[0] * up[2]});
    north = {up[1] * east[2] - up[2] * east[1], up[2] * east[0] - up[0] * east[2], up[0] * east[1] - up[1] * east[0]};
  }
  Direction to_scene(const Direction& d) const {
    Direction out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = d[0] * east[i] + d[1] * north[i] + d[2] * up[i];
    return out;
  }
  Direction from_scene(const Direction& d) const { return {dot(d, east), dot(d, north), dot(d, up)}; }
};

/// The scene's shadow map as the air's kernels read it, in the eye's frame.
AirShadows air_shadows(const ShadowMap& map, const EyeFrame& frame, const Position& eye, int steps) {
  AirShadows shadows;
  shadows.width = shadows.height = map.cells;
  shadows.steps = steps;
  shadows.highest = *std::ranges::max_element(map.lit);
  std::vector<float> edges;
  edges.reserve(2 * map.lit.size());
  for (std::size_t i = 0; i < map.lit.size(); ++i) edges.insert(edges.end(), {map.dark[i], map.lit[i]});
  shadows.edges = std::make_shared<const std::vector<float>>(std::move(edges));
  const double size = map.spacing * map.cells;
  const Direction* const axes[] = {&frame.east, &frame.north, &frame.up};
  const std::array<double, 2> origin = map.texel(eye);
  for (std::size_t i = 0; i < 3; ++i) {
    shadows.across[i] = ((*axes[i])[0] * map.along[0] + (*axes[i])[1] * map.along[1]) / size;
    shadows.along[i] = ((*axes[i])[0] * map.across[0] + (*axes[i])[1] * map.across[1]) / size;
  }
  shadows.across[3] = (origin[0] + 0.5) / map.cells;
  shadows.along[3] = (origin[1] + 0.5) / map.cells;
  return shadows;
}

double camera_pixel(const Camera& camera) {
  switch (camera.projection) {
    case Projection::equirectangular:
      return 2 * std::numbers::pi / camera.width;
    case Projection::fisheye:
      return camera.field_of_view / camera.width;
    case Projection::cube:
      return 2.0 / camera.width;
    case Projection::perspective:
      break;
  }
  return 2 * std::tan(camera.field_of_view / 2) / camera.width;
}

/// The cone around the camera's axis that holds the picture [rad].
double camera_cone(const Camera& camera) {
  switch (camera.projection) {
    case Projection::equirectangular:
      return std::numbers::pi;
    case Projection::fisheye:
      return camera.field_of_view / 2;
    case Projection::cube:
      return 0.96;  // atan(sqrt 2)
    case Projection::perspective:
      break;
  }
  return std::atan(std::tan(camera.field_of_view / 2) * std::hypot(1.0, double(camera.height) / camera.width));
}

std::shared_ptr<const Land> checked(std::shared_ptr<const Land> land, const SceneView& view,
                                    const SceneOptions& options) {
  const double ground = land->altitude(view.eye.east, view.eye.north);
  if (!(view.eye.altitude >= ground + least_height)) {
    throw InputError("altitude of the camera = " + number_text(view.eye.altitude) + " m: the land there is " +
                     number_text(ground) + " m high; expected at least " + number_text(ground + least_height) + " m");
  }
  const int side = int(std::lround(std::sqrt(options.samples)));
  if (options.samples < 1 || options.samples > 256 || side * side != options.samples) {
    throw InputError("samples = " + std::to_string(options.samples) + ": expected a square number, 1 .. 256");
  }
  return land;
}

template <class Work>
void in_parallel(std::size_t count, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
  });
}

LevelOfDetail level_of_detail(const EyeFrame& frame, const Position& eye, const Camera& camera,
                              const SceneOptions& options) {
  LevelOfDetail detail;
  detail.eye = eye;
  detail.pixel_angle = camera_pixel(camera);
  detail.pixels = options.triangle_pixels;
  detail.half_angle = camera_cone(camera);
  detail.axis = frame.to_scene(view_direction(camera, 0.5, 0.5));
  return detail;
}

}  // namespace

struct SceneRenderer::Impl {
  const Sky& sky;
  std::shared_ptr<const Land> land;
  SceneView view;
  SceneOptions options;
  Position eye;
  EyeFrame frame;
  Direction sun_at_eye;
  Terrain terrain;
  std::vector<double> wavelengths;
  SurfaceColour colour;
  SkyViewMap sky_view;
  std::optional<AirShadows> shadows;
  std::vector<std::array<double, 3>> to_rgb;  // a wavelength: linear sRGB of its radiance
  DiscInPicture disc;
  std::array<double, 4> limb{}, irradiance{};

  Impl(const Sky& s, std::shared_ptr<const Land> l, const SurfaceSettings& surface, const SceneView& v,
       const SceneOptions& o)
      : sky(s),
        land(checked(std::move(l), v, o)),
        view(v),
        options(o),
        eye(land->frame().position(v.eye)),
        frame(land->frame(), eye),
        sun_at_eye(frame.from_scene(v.sun)),
        terrain(land, level_of_detail(frame, eye, v.camera, o)),
        wavelengths([&] {
          const auto quad = s.realtime_wavelengths();
          return std::vector<double>(quad.begin(), quad.end());
        }()),
        colour(surface, land, wavelengths) {
    const Atmosphere& air = sky.atmosphere();
    const double reach = std::min(options.shadow_grid.half_width, land->extent());
    sky_view = sky_view_map(*land, view.eye.east, view.eye.north, reach, sky_view_cells);
    if (options.air_shadows) {
      ShadowGrid grid = options.shadow_grid;
      grid.east = eye[0];
      grid.north = eye[1];
      shadows =
          air_shadows(shadow_map(*land, view.sun, air.sun.angular_radius, grid), frame, eye, options.shadow_steps);
    }
    for (const Xyz& weight : colour_weights(air, wavelengths)) to_rgb.push_back(xyz_to_srgb(weight));
    for (std::size_t k = 0; k < 4; ++k) {
      limb[k] = air.sun.limb_darkening.at(wavelengths[k]);
      irradiance[k] = air.sun.irradiance.at(wavelengths[k]);
    }
    disc = disc_in_picture(view.camera, sun_at_eye, air.sun.angular_radius, limb);
  }

  std::array<double, 3> rgb(const double* spectrum) const {
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t c = 0; c < 3; ++c) out[c] += to_rgb[k][c] * spectrum[k];
    }
    return out;
  }

  // The samples of a strip, one after the other, pixel by pixel.
  struct Samples {
    std::vector<Sight> sights;
    std::vector<char> inside;
    std::vector<TerrainHit> hits;
    std::vector<float> sun_visibility;
    std::vector<double> albedo, surface, skylight, inscatter, transmittance;  // 4 a sample
  };

  Samples see_rows(int begin, int end) const {
    const Camera& camera = view.camera;
    const std::size_t pixels = std::size_t(end - begin) * std::size_t(camera.width),
                      count = pixels * std::size_t(options.samples);
    const int side = int(std::lround(std::sqrt(options.samples)));
    const auto look = viewer(camera);
    Samples s;
    s.sights.resize(count);
    s.inside.resize(count);
    in_parallel(count, [&](std::size_t i) {
      const std::size_t pixel = i / std::size_t(options.samples), sample = i % std::size_t(options.samples);
      const double x = double(pixel % std::size_t(camera.width)),
                   y = double(begin) + double(pixel / std::size_t(camera.width));
      const double dx = (double(sample % std::size_t(side)) + 0.5) / side,
                   dy = (double(sample / std::size_t(side)) + 0.5) / side;
      const std::optional<Direction> seen = look((x + dx) / camera.width, (y + dy) / camera.height);
      s.inside[i] = seen.has_value();
      s.sights[i].view = seen.value_or(Direction{0, 0, 1});
      // A low-discrepancy pattern over the picture (Roberts 2018, sequence R2) and the samples of a pixel (golden ratio).
      const double place = 0.5 + 0.7548776662466927 * x + 0.5698402909980532 * y + 0.6180339887498949 * double(sample);
      s.sights[i].offset = place - std::floor(place);
    });
    see(s);
    return s;
  }

  // What the samples' lines of sight meet, and all its light.
  void see(Samples& s) const {
    const std::size_t count = s.sights.size();
    std::vector<SceneRay> rays(count);
    in_parallel(count, [&](std::size_t i) { rays[i] = {eye, frame.to_scene(s.sights[i].view)}; });
    s.hits.resize(count);
    terrain.hits(rays, s.hits);

    std::vector<std::size_t> on_ground;
    for (std::size_t i = 0; i < count; ++i) {
      if (s.hits[i].hit()) on_ground.push_back(i), s.sights[i].distance = s.hits[i].distance;
    }
    shade(s, on_ground);

    s.inscatter.resize(4 * count);
    s.transmittance.resize(4 * count);
    sky.haze(view.eye.altitude, sun_at_eye, s.sights, wavelengths, shadows ? &*shadows : nullptr, s.inscatter,
             s.transmittance);
    if (options.sun_disc) {
      const double reach = disc.radius + disc.edge;
      in_parallel(count, [&](std::size_t i) {
        if (s.hits[i].hit()) return;
        const Direction& v = s.sights[i].view;
        const double dx = v[0] - sun_at_eye[0], dy = v[1] - sun_at_eye[1], dz = v[2] - sun_at_eye[2];
        const double one_minus_cos = 0.5 * (dx * dx + dy * dy + dz * dz);
        if (2 * one_minus_cos >= reach * reach) return;
        const auto shape = disc_radiance(disc, limb, one_minus_cos);
        for (std::size_t k = 0; k < 4; ++k) s.surface[4 * i + k] = shape[k] * irradiance[k];
      });
    }
  }

  Answer at(double u, double v) const {
    const std::optional<Direction> seen = viewer(view.camera)(u, v);
    if (!seen)
      throw InputError("picture coordinates (" + number_text(u) + ", " + number_text(v) +
                       "): outside the fisheye's circle");
    Samples s;
    s.sights = {{*seen}};
    s.inside = {1};
    see(s);
    Answer answer{*seen, sun_at_eye, frame.to_scene(*seen), s.hits[0].distance, {}, {}, {}};
    for (std::size_t k = 0; k < 4; ++k) {
      answer.inscatter[k] = s.inscatter[k];
      answer.transmittance[k] = s.transmittance[k];
      answer.surface[k] = s.surface[k];
    }
    return answer;
  }

  // What leaves the ground towards the eye.
  void shade(Samples& s, std::span<const std::size_t> which) const {
    const std::size_t count = s.hits.size();
    s.sun_visibility.assign(count, 0);
    s.albedo.assign(4 * count, 0);
    s.surface.assign(4 * count, 0);
    s.skylight.assign(4 * count, 0);
    if (which.empty()) return;
    std::vector<SunQuestion> questions;
    for (const std::size_t i : which) questions.push_back({s.hits[i].position, s.hits[i].normal});
    std::vector<float> visible(which.size());
    terrain.sun_visibility(questions, view.sun, sky.atmosphere().sun.angular_radius, visible);

    std::vector<SurfacePoint> points(which.size());
    std::vector<double> albedo(4 * which.size()), radiance(albedo.size()), skylight(albedo.size());
    const double pixel = camera_pixel(view.camera);
    in_parallel(which.size(), [&](std::size_t j) {
      const TerrainHit& hit = s.hits[which[j]];
      const Direction up = land->frame().up(hit.position), normal = wide(hit.shading_normal);
      const double mu_s = std::clamp(dot(up, view.sun), -1.0, 1.0), nz = std::clamp(dot(normal, up), -1.0, 1.0);
      const double cosine = std::clamp(dot(normal, view.sun), -1.0, 1.0);
      const double sin_s = std::sqrt(std::max(1 - mu_s * mu_s, 1e-12)), across = std::sqrt(std::max(1 - nz * nz, 0.0));
      const double nx = std::clamp((cosine - nz * mu_s) / sin_s, -across, across);
      SurfacePoint& p = points[j];
      p.altitude = hit.ground.altitude;
      p.sun_zenith_cosine = mu_s;
      p.sun_cosine = cosine;
      p.normal = {nx, std::sqrt(std::max(1 - nz * nz - nx * nx, 0.0)), nz};
      p.sun_visibility = std::clamp(double(visible[j]), 0.0, 1.0);
      p.sky_view = hit.mesh ? std::clamp(sky_view.at(hit.ground.east, hit.ground.north), 0.0, 1.0) : 1.0;
      std::array<float, 4> reflected{};
      colour.albedo(hit, pixel * hit.distance, reflected);
      for (std::size_t k = 0; k < 4; ++k) albedo[4 * j + k] = std::clamp(double(reflected[k]), 0.0, 1.0);
    });
    sky.surface(points, std::clamp(sun_at_eye[2], -1.0, 1.0), wavelengths, albedo, radiance, skylight);
    for (std::size_t j = 0; j < which.size(); ++j) {
      const std::size_t i = which[j];
      s.sun_visibility[i] = visible[j];
      for (std::size_t k = 0; k < 4; ++k) {
        s.albedo[4 * i + k] = albedo[4 * j + k];
        s.surface[4 * i + k] = radiance[4 * j + k];
        s.skylight[4 * i + k] = skylight[4 * j + k];
      }
    }
  }

  // Means over the samples of each pixel.
  SceneRows rows(const Samples& s, int begin, int end) const {
    const std::size_t pixels = std::size_t(end - begin) * std::size_t(view.camera.width),
                      per_pixel = std::size_t(options.samples);
    SceneRows out;
    out.begin = begin;
    out.end = end;
    for (auto* layer : {&out.rgb, &out.surface, &out.transmittance, &out.inscatter, &out.position, &out.normal,
                        &out.albedo, &out.sky_irradiance})
      layer->resize(3 * pixels);
    out.depth.resize(pixels);
    out.sun_visibility.resize(pixels);
    // Albedo as the colour that sunlight outside the air takes on, relative to that of white.
    const std::array<double, 3> white = rgb(irradiance.data());
    in_parallel(pixels, [&](std::size_t p) {
      std::array<double, 4> seen{}, surface{}, inscatter{}, skylight{}, reflected{};
      double through = 0, distance = 0, visible = 0, hits = 0;
      Direction position{}, normal{};
      for (std::size_t i = p * per_pixel; i < (p + 1) * per_pixel; ++i) {
        if (!s.inside[i]) continue;
        for (std::size_t k = 0; k < 4; ++k) {
          const double t = s.transmittance[4 * i + k];
          seen[k] += s.inscatter[4 * i + k] + s.surface[4 * i + k] * t;
          surface[k] += s.surface[4 * i + k];
          inscatter[k] += s.inscatter[4 * i + k];
          skylight[k] += s.skylight[4 * i + k];
          reflected[k] += s.albedo[4 * i + k] * irradiance[k];
          through += t / 4;
        }
        const TerrainHit& hit = s.hits[i];
        if (!hit.hit()) continue;
        hits += 1;
        distance += hit.distance;
        visible += double(s.sun_visibility[i]);
        for (std::size_t c = 0; c < 3; ++c) {
          position[c] += hit.position[c];
          normal[c] += double(hit.shading_normal[c]);
        }
      }
      const double scale = 1 / double(per_pixel), of_hits = hits > 0 ? 1 / hits : 0;
      const auto put = [&](std::vector<float>& layer, const std::array<double, 3>& value, double factor) {
        for (std::size_t c = 0; c < 3; ++c) layer[3 * p + c] = float(value[c] * factor);
      };
      put(out.rgb, rgb(seen.data()), scale);
      put(out.surface, rgb(surface.data()), scale);
      put(out.inscatter, rgb(inscatter.data()), scale);
      for (std::size_t c = 0; c < 3; ++c) {
        const float leaving = out.surface[3 * p + c];
        out.transmittance[3 * p + c] =
            leaving != 0 ? (out.rgb[3 * p + c] - out.inscatter[3 * p + c]) / leaving : float(through * scale);
      }
      put(out.sky_irradiance, rgb(skylight.data()), of_hits);
      const auto colours = rgb(reflected.data());
      put(out.albedo, {colours[0] / white[0], colours[1] / white[1], colours[2] / white[2]}, of_hits);
      put(out.position, position, of_hits);
      put(out.normal, hits > 0 ? unit(normal) : Direction{}, 1);
      out.depth[p] = 2 * hits >= double(per_pixel) ? float(distance * of_hits) : std::numeric_limits<float>::infinity();
      out.sun_visibility[p] = float(visible * of_hits);
    });
    return out;
  }
};

SceneRenderer::SceneRenderer(const Sky& sky, std::shared_ptr<const Land> land, const SurfaceSettings& surface,
                             const SceneView& view, const SceneOptions& options)
    : impl_(std::make_unique<Impl>(sky, std::move(land), surface, view, options)) {}
SceneRenderer::~SceneRenderer() = default;

SceneRenderer::Answer SceneRenderer::at(double u, double v) const { return impl_->at(u, v); }

const Terrain& SceneRenderer::terrain() const { return impl_->terrain; }

bool SceneRenderer::render(const std::function<bool(const SceneRows&)>& rows) const {
  const Camera& camera = impl_->view.camera;
  constexpr int samples_at_once =
      1 << 15;  // few enough that their arrays stay in the cache and are used again, many for all cores
  const int step = std::max(1, samples_at_once / (camera.width * impl_->options.samples));
  for (int begin = 0; begin < camera.height; begin += step) {
    const int end = std::min(begin + step, camera.height);
    if (!rows(impl_->rows(impl_->see_rows(begin, end), begin, end))) return false;
  }
  return true;
}

}  // namespace airlight
