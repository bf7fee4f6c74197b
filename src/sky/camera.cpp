// The kernels' camera on the host, in double.
#define AIRLIGHT_TARGET host_camera
#define AIRLIGHT_REP double
#include "prelude/prelude.hpp"
namespace airlight::host_camera {
#include "core/camera.glsl"
#include "core/disc.glsl"
}  // namespace airlight::host_camera

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sky/camera.h"

namespace airlight {
namespace {

using std::numbers::pi;

Direction combine(const Direction& a, double x, const Direction& b, double y) {
  return {a[0] * x + b[0] * y, a[1] * x + b[1] * y, a[2] * x + b[2] * y};
}
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Frame {
  Direction right, up, forward;
};
Frame frame(const Camera& c) {
  double azimuth = c.azimuth, elevation = c.elevation;
  if (c.projection == Projection::cube) {
    constexpr double faces[6][2] = {{pi / 2, 0}, {-pi / 2, 0}, {0, 0}, {pi, 0}, {0, pi / 2}, {0, -pi / 2}};
    azimuth = faces[c.face][0];
    elevation = faces[c.face][1];
  }
  if (c.projection == Projection::equirectangular) elevation = 0;  // its rows are elevations
  Frame f;
  f.forward = direction(azimuth, elevation);
  f.right = {std::cos(azimuth), -std::sin(azimuth), 0};
  f.up = {-std::sin(elevation) * std::sin(azimuth), -std::sin(elevation) * std::cos(azimuth), std::cos(elevation)};
  const double c1 = std::cos(c.roll), s1 = c.projection == Projection::equirectangular ? 0 : std::sin(c.roll);
  return {combine(f.right, c1, f.up, s1), combine(f.up, c1, f.right, -s1), f.forward};
}

host_camera::Camera kernel_camera(const Camera& c) {
  const Fields fields = camera_fields(c);
  const auto four = [&](const char* name) {
    const auto& v = fields.at(name);
    return host_camera::Scalar4(v[0], v[1], v[2], 0.0);
  };
  host_camera::Camera k;
  k.right = four("right");
  k.up = four("up");
  k.forward = four("forward");
  k.projection = fields.at("projection")[0];
  k.half_width = fields.at("half_width")[0];
  k.half_height = fields.at("half_height")[0];
  k.pad = 0.0;
  return k;
}
Direction view_of(const host_camera::Camera& camera, double u, double v) {
  host_camera::Float inside;
  const host_camera::Vec3 d = camera_view(camera, {u, v}, inside);
  return {d.x.v, d.y.v, d.z.v};
}

}  // namespace

Direction direction(double azimuth, double elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth), std::sin(elevation)};
}

Fields camera_fields(const Camera& c) {
  const Frame f = frame(c);
  const auto list = [](const Direction& d) { return std::vector<double>{d[0], d[1], d[2], 0}; };
  const double aspect = double(c.height) / c.width;
  double projection = 2, half_width = std::tan(std::min(c.field_of_view, 3.1) / 2);
  if (c.projection == Projection::equirectangular) projection = 0, half_width = 1;
  if (c.projection == Projection::fisheye) projection = 1, half_width = c.field_of_view / 2;
  if (c.projection == Projection::cube) half_width = 1;
  return {{"right", list(f.right)},
          {"up", list(f.up)},
          {"forward", list(f.forward)},
          {"projection", {projection}},
          {"half_width", {half_width}},
          {"half_height", {half_width * aspect}},
          {"pad", {0}}};
}

Direction view_direction(const Camera& camera, double u, double v) { return view_of(kernel_camera(camera), u, v); }

std::function<std::optional<Direction>(double u, double v)> viewer(const Camera& camera) {
  return [kernel = kernel_camera(camera)](double u, double v) -> std::optional<Direction> {
    host_camera::Float inside;
    const host_camera::Vec3 d = camera_view(kernel, {u, v}, inside);
    if (inside.v < 0.5) return {};
    return Direction{d.x.v, d.y.v, d.z.v};
  };
}

std::array<double, 4> disc_radiance(const DiscInPicture& disc, const std::array<double, 4>& exponent,
                                    double one_minus_cos) {
  const host_camera::Scalar4 limb(exponent[0], exponent[1], exponent[2], exponent[3]);
  const host_camera::Vec4 shape = disc_shape(limb, disc.radius, disc.edge, host_camera::Float(one_minus_cos));
  return {shape.x.v * disc.gain[0], shape.y.v * disc.gain[1], shape.z.v * disc.gain[2], shape.w.v * disc.gain[3]};
}

DiscInPicture disc_in_picture(const Camera& camera, Direction sun, double angular_radius,
                              const std::array<double, 4>& exponent) {
  const host_camera::Camera kernel = kernel_camera(camera);
  // The picture goes on a block beyond its frame, so that a disc cut by the frame is not made brighter. An equirectangular one wraps.
  constexpr int block = 16;
  const bool wraps = camera.projection == Projection::equirectangular;
  const auto view = [&](double x, double y) { return view_of(kernel, x / camera.width, y / camera.height); };
  const auto solid_angle = [&](double x, double y) {
    const Direction a = view(x - 0.25, y), b = view(x + 0.25, y), c = view(x, y - 0.25), d = view(x, y + 0.25);
    const Direction e = combine(b, 2, a, -2), f = combine(d, 2, c, -2);
    const Direction n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    return std::sqrt(dot(n, n));
  };
  const auto apart = [&](const Direction& v) {
    const Direction d = combine(v, 1, sun, -1);
    return 2 * std::asin(std::min(std::sqrt(dot(d, d)) / 2, 1.0));
  };
  struct Block {
    int x, y;
    double angle;
  };
  std::vector<Block> blocks;
  double nearest = 10, sun_x = 0, sun_y = 0;
  const int margin = wraps ? 0 : block;
  for (int y = -margin; y < camera.height + margin; y += block) {
    for (int x = -margin; x < camera.width + margin; x += block) {
      const double cx = x + block / 2.0, cy = std::min(y + block / 2.0, wraps ? camera.height - 0.5 : 1e9);
      const double angle = apart(view(cx, cy));
      blocks.push_back({x, y, angle});
      if (angle < nearest) nearest = angle, sun_x = cx, sun_y = cy;
    }
  }
  // From the nearest block's centre downhill to the Sun: a pixel's size is wanted there. A Sun in the picture is a block's
  // diagonal away at most; one that is not would be chased without end.
  int steps_left = 4 * block;
  for (double step = block / 2.0; step >= 0.5 && steps_left-- > 0;) {
    const double before = nearest;
    for (const auto& [dx, dy] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const double angle = apart(view(sun_x + dx, sun_y + dy));
      if (angle < nearest && (!wraps || (sun_y + dy > 0 && sun_y + dy < camera.height))) {
        nearest = angle, sun_x += dx, sun_y += dy;
        break;
      }
    }
    if (nearest == before) step /= 2;
  }
  const double pixel = std::sqrt(solid_angle(sun_x, sun_y));
  DiscInPicture disc;
  disc.edge = pixel;
  disc.radius = std::max(angular_radius, 0.6 * pixel);
  const host_camera::Scalar4 limb(exponent[0], exponent[1], exponent[2], exponent[3]);
  std::array<double, 4> sum{};
  const double reach = disc.radius + disc.edge;
  for (const Block& b : blocks) {
    if (b.angle > reach + 24 * pixel && b.angle > 3 * reach && !wraps) continue;
    if (wraps && b.angle > reach + block * pi / camera.height + block * 2 * pi / camera.width) continue;
    for (int y = b.y; y < b.y + block && (!wraps || y < camera.height); ++y) {
      for (int x = b.x; x < b.x + block && (!wraps || x < camera.width); ++x) {
        const double angle = apart(view(x + 0.5, y + 0.5));
        if (angle >= reach) continue;
        const host_camera::Vec4 shape = disc_shape(limb, disc.radius, disc.edge, host_camera::Float(angle * angle / 2));
        const double omega = solid_angle(x + 0.5, y + 0.5);
        const double weights[4] = {shape.x.v, shape.y.v, shape.z.v, shape.w.v};
        for (std::size_t k = 0; k < 4; ++k) sum[k] += weights[k] * omega;
      }
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    // No pixel sees the Sun: the gain of a resolved disc, which is never used.
    disc.gain[k] = 1 / (sum[k] > 0 ? sum[k] : pi * disc.radius * disc.radius * 2 / (exponent[k] + 2));
  }
  return disc;
}

}  // namespace airlight
