#include "render/scene_renderer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "optics/colour.h"
#include "optics/number_text.h"
#include "render/air_shadows.h"
#include "scene/sky_view.h"
#include "sky/camera.h"

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

}  // namespace

struct SceneRenderer::Impl {
  const Sky& sky;
  std::shared_ptr<const Land> land;
  SceneView view;
  SceneOptions options;
  int samples, width;
  Position eye;
  double altitude, pixel;  // of the eye [m]; of a pixel [rad]
  Direction sun_at_eye;
  Terrain terrain;
  std::vector<double> wavelengths;
  SurfaceColour colour;
  SkyViewMap sky_view, sky_view_near;  // the same, finer around the eye
  std::optional<AirShadows> shadows;
  std::vector<std::array<double, 3>> to_rgb;  // a wavelength: linear sRGB of its radiance
  std::array<double, 4> limb{}, irradiance{};
  struct Face {
    std::function<std::optional<Direction>(double u, double v)> look;
    DiscInPicture disc;
  };
  std::vector<Face> faces;   // a cube has six, every other picture one
  std::size_t sun_face = 0;  // the one that looks nearest to the Sun
  double nearest = -2;       // cosine of the angle between

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
        sun_at_eye(v.camera.from_scene(v.sun)),
        terrain(land, level_of_detail(v.camera, o.triangle_pixels)),
        wavelengths([&] {
          if (!o.wavelengths.empty()) return o.wavelengths;
          const auto quad = s.realtime_wavelengths();
          return std::vector<double>(quad.begin(), quad.end());
        }()),
        colour(surface, land, wavelengths) {
    const Atmosphere& air = sky.atmosphere();
    const double reach = std::min(options.shadow_grid.half_width, land->extent());
    const GroundPoint below = land->frame().ground(eye);
    sky_view = sky_view_map(*land, below.east, below.north, reach, sky_view_cells);
    sky_view_near = sky_view_map(*land, below.east, below.north, 0.25 * reach, sky_view_cells);
    if (options.air_shadows) {
      ShadowGrid grid = options.shadow_grid;
      grid.east = eye[0];
      grid.north = eye[1];
      // Several samples mostly share one look at the air, which may then be closer.
      const int steps = options.shadow_steps * (samples > 1 ? 2 : 1);
      shadows = air_shadows(shadow_map(*land, view.sun, air.sun.angular_radius, grid), view.camera, steps);
    }
    for (const Xyz& weight : colour_weights(air, wavelengths)) to_rgb.push_back(xyz_to_srgb(weight));
    for (std::size_t k = 0; k < 4; ++k) {
      limb[k] = air.sun.limb_darkening.at(wavelengths[k]);
      irradiance[k] = air.sun.irradiance.at(wavelengths[k]);
    }
    Camera camera = view.camera.camera;
    for (camera.face = 0; camera.face < width / camera.width; ++camera.face) {
      faces.push_back({viewer(camera), disc_in_picture(camera, sun_at_eye, air.sun.angular_radius, limb)});
      const Direction axis = view_direction(camera, 0.5, 0.5);
      if (camera.face == 0 || dot(axis, sun_at_eye) > nearest)
        sun_face = std::size_t(camera.face), nearest = dot(axis, sun_at_eye);
    }
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
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t c = 0; c < 3; ++c) out[c] += to_rgb[k][c] * spectrum[k];
    }
    return out;
  }

  // The direction at picture coordinates; a cube's faces lie side by side.
  std::optional<Direction> look(double u, double v) const {
    const double across = u * double(faces.size());
    const std::size_t face = std::min(std::size_t(std::max(across, 0.0)), faces.size() - 1);
    return faces[face].look(across - double(face), v);
  }

  // The samples of a strip, one after the other, pixel by pixel. One object serves all strips.
  struct Samples {
    std::vector<Sight> sights;
    std::vector<char> inside;
    std::vector<SceneRay> rays;
    std::vector<TerrainHit> hits;
    std::vector<int> nth_on_ground;  // place in the ground's lists; -1: the sky
    std::vector<int> nth_in_air;     // place in the air's lists
    // The air before samples; those of a pixel that lie equally far off share it.
    std::vector<Sight> air;
    std::vector<double> inscatter, transmittance;  // 4 each
    // Of those on the ground alone.
    std::vector<std::size_t> on_ground;
    std::vector<SunQuestion> questions;
    std::vector<float> sun_visibility;
    std::vector<SurfacePoint> points;
    std::vector<double> albedo, surface, skylight;  // 4 each
  };

  void see_rows(int begin, int end, Samples& s) const {
    const Camera& camera = view.camera.camera;
    const std::size_t count = std::size_t(end - begin) * std::size_t(width) * std::size_t(samples);
    const int side = int(std::lround(std::sqrt(samples)));
    s.sights.resize(count);
    s.inside.resize(count);
    in_parallel(count, [&](std::size_t i) {
      const std::size_t nth = i / std::size_t(samples), sample = i % std::size_t(samples);
      const double x = double(nth % std::size_t(width)), y = double(begin) + double(nth / std::size_t(width));
      const double dx = (double(sample % std::size_t(side)) + 0.5) / side,
                   dy = (double(sample / std::size_t(side)) + 0.5) / side;
      const std::optional<Direction> seen = look((x + dx) / width, (y + dy) / camera.height);
      s.inside[i] = seen.has_value();
      s.sights[i] = {seen.value_or(Direction{0, 0, 1}), std::numeric_limits<double>::infinity(),
                     shadow_offset(x, y, double(sample))};
    });
    see(s);
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

    share_air(s);
    s.inscatter.resize(4 * s.air.size());
    s.transmittance.resize(4 * s.air.size());
    sky.haze(altitude, sun_at_eye, s.air, wavelengths, shadows ? &*shadows : nullptr, s.inscatter, s.transmittance);
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

  // What comes from the far end of a sample's line of sight: light of the ground, or of the Sun.
  std::array<double, 4> behind(const Samples& s, std::size_t i) const {
    std::array<double, 4> light{};
    if (const int n = s.nth_on_ground[i]; n >= 0) {
      std::copy_n(&s.surface[4 * std::size_t(n)], 4, light.begin());
    } else if (options.sun_disc) {
      const DiscInPicture& disc = faces[sun_face].disc;
      const double reach = disc.radius + disc.edge;
      const Direction& v = s.sights[i].view;
      const double dx = v[0] - sun_at_eye[0], dy = v[1] - sun_at_eye[1], dz = v[2] - sun_at_eye[2];
      const double one_minus_cos = 0.5 * (dx * dx + dy * dy + dz * dz);
      if (2 * one_minus_cos >= reach * reach) return light;
      const auto shape = disc_radiance(disc, limb, one_minus_cos);
      for (std::size_t k = 0; k < 4; ++k) light[k] = shape[k] * irradiance[k];
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
    Answer answer{*seen, sun_at_eye, view.camera.to_scene(*seen), s.hits[0].distance, {}, {}, behind(s, 0)};
    for (std::size_t k = 0; k < 4; ++k) {
      answer.inscatter[k] = s.inscatter[k];
      answer.transmittance[k] = s.transmittance[k];
    }
    return answer;
  }

  // What leaves the ground towards the eye.
  void shade(Samples& s) const {
    const std::vector<std::size_t>& which = s.on_ground;
    if (which.empty()) return;
    s.questions.clear();
    for (const std::size_t i : which) s.questions.push_back({s.hits[i].position, s.hits[i].normal});
    s.sun_visibility.resize(which.size());
    s.points.resize(which.size());
    for (auto* spectra : {&s.albedo, &s.surface, &s.skylight}) spectra->resize(4 * which.size());
    terrain.sun_visibility(s.questions, view.sun, options.soft_shadows ? sky.atmosphere().sun.angular_radius : 0.0,
                           s.sun_visibility);
    in_parallel(which.size(), [&](std::size_t j) {
      const TerrainHit& hit = s.hits[which[j]];
      const Direction up = land->frame().up(hit.position), normal = wide(hit.shading_normal);
      const double mu_s = std::clamp(dot(up, view.sun), -1.0, 1.0), nz = std::clamp(dot(normal, up), -1.0, 1.0);
      const double cosine = std::clamp(dot(normal, view.sun), -1.0, 1.0);
      const double sin_s = std::sqrt(std::max(1 - mu_s * mu_s, 1e-12)), across = std::sqrt(std::max(1 - nz * nz, 0.0));
      const double nx = std::clamp((cosine - nz * mu_s) / sin_s, -across, across);
      SurfacePoint& p = s.points[j];
      p.altitude = hit.ground.altitude;
      p.sun_zenith_cosine = mu_s;
      p.sun_cosine = cosine;
      p.normal = {nx, std::sqrt(std::max(1 - nz * nz - nx * nx, 0.0)), nz};
      // The air's own sunlight knows the planet's horizon: land takes a part of what that leaves.
      const double above = mu_s > 0.2 ? 1
                                      : disc_above_sphere(mu_s, hit.ground.altitude, land->frame().radius(),
                                                          sky.atmosphere().sun.angular_radius);
      p.sun_visibility = above > 0 ? std::clamp(double(s.sun_visibility[j]) / above, 0.0, 1.0) : 0.0;
      p.sky_view = hit.mesh ? sky_seen(hit.ground) : 1.0;
    });
    constexpr std::size_t lanes = SurfaceColour::lanes;
    in_parallel((which.size() + lanes - 1) / lanes, [&](std::size_t packet) {
      const std::size_t begin = packet * lanes, end = std::min(begin + lanes, which.size());
      const TerrainHit* hits[lanes];
      for (std::size_t j = begin; j < end; ++j) hits[j - begin] = &s.hits[which[j]];
      colour.albedo({hits, end - begin}, pixel, std::span(s.albedo).subspan(4 * begin, 4 * (end - begin)));
    });
    sky.surface(s.points, std::clamp(sun_at_eye[2], -1.0, 1.0), wavelengths, s.albedo, s.surface, s.skylight);
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
      for (std::size_t i = p * per_pixel; i < (p + 1) * per_pixel; ++i) {
        if (!s.inside[i]) continue;
        const std::array<double, 4> light = behind(s, i);
        const double *inscatter = &s.inscatter[4 * std::size_t(s.nth_in_air[i])],
                     *transmittance = &s.transmittance[4 * std::size_t(s.nth_in_air[i])];
        for (std::size_t k = 0; k < 4; ++k) seen[k] += inscatter[k] + light[k] * transmittance[k];
      }
      put(out.rgb, p, rgb(seen.data()), 1 / double(per_pixel));
    });
    if (layers) fill_layers(s, out);
    return out;
  }

  static void put(std::vector<float>& layer, std::size_t pixel, const std::array<double, 3>& value, double factor) {
    for (std::size_t c = 0; c < 3; ++c) layer[3 * pixel + c] = float(value[c] * factor);
  }

  void fill_layers(const Samples& s, SceneRows& out) const {
    const std::size_t pixels = out.rgb.size() / 3, per_pixel = std::size_t(samples);
    for (auto* layer : {&out.surface, &out.transmittance, &out.inscatter, &out.position, &out.normal, &out.albedo,
                        &out.sky_irradiance})
      layer->resize(3 * pixels);
    for (auto* layer : {&out.spectral_surface, &out.spectral_transmittance, &out.spectral_inscatter})
      layer->resize(4 * pixels);
    out.depth.resize(pixels);
    out.sun_visibility.resize(pixels);
    // Albedo as the colour that sunlight outside the air takes on, relative to that of white.
    const std::array<double, 3> white = rgb(irradiance.data());
    in_parallel(pixels, [&](std::size_t p) {
      std::array<double, 4> surface{}, arriving{}, through{}, inscatter{}, skylight{}, reflected{};
      double distance = 0, visible = 0, hits = 0;
      Direction position{}, normal{};
      for (std::size_t i = p * per_pixel; i < (p + 1) * per_pixel; ++i) {
        if (!s.inside[i]) continue;
        const std::array<double, 4> light = behind(s, i);
        const auto in_air = std::size_t(s.nth_in_air[i]);
        for (std::size_t k = 0; k < 4; ++k) {
          surface[k] += light[k];
          arriving[k] += light[k] * s.transmittance[4 * in_air + k];
          through[k] += s.transmittance[4 * in_air + k];
          inscatter[k] += s.inscatter[4 * in_air + k];
        }
        if (s.nth_on_ground[i] < 0) continue;
        const auto n = std::size_t(s.nth_on_ground[i]);
        const TerrainHit& hit = s.hits[i];
        hits += 1;
        distance += hit.distance;
        visible += double(s.sun_visibility[n]);
        for (std::size_t k = 0; k < 4; ++k) {
          skylight[k] += s.skylight[4 * n + k];
          reflected[k] += s.albedo[4 * n + k] * irradiance[k];
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
        out.transmittance[3 * p + c] = leaving != 0
                                           ? (out.rgb[3 * p + c] - out.inscatter[3 * p + c]) / leaving
                                           : float((through[0] + through[1] + through[2] + through[3]) * scale / 4);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        out.spectral_surface[4 * p + k] = float(surface[k] * scale);
        out.spectral_transmittance[4 * p + k] = float(surface[k] > 0 ? arriving[k] / surface[k] : through[k] * scale);
        out.spectral_inscatter[4 * p + k] = float(inscatter[k] * scale);
      }
      put(out.sky_irradiance, p, rgb(skylight.data()), of_hits);
      const auto colours = rgb(reflected.data());
      put(out.albedo, p, {colours[0] / white[0], colours[1] / white[1], colours[2] / white[2]}, of_hits);
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
