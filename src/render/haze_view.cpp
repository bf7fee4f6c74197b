#include "render/haze_view.h"

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "sky/camera.h"

namespace airlight {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector times(const Vector& a, double f) { return {a[0] * f, a[1] * f, a[2] * f}; }
Vector plus(const Vector& a, const Vector& b, double f = 1) {
  return {a[0] + b[0] * f, a[1] + b[1] * f, a[2] + b[2] * f};
}
Vector unit(const Vector& a) { return times(a, 1 / std::sqrt(dot(a, a))); }

/// The view at (u, v) points along corner + u across + v down; depth z is measured along `axis`.
struct Lens {
  Vector corner, across, down, axis, eye;
};

/// The first three numbers of a column, and the fourth.
Vector column(const Matrix44& m, std::size_t c) { return {m[c], m[4 + c], m[8 + c]}; }

/// NDC = (p a, p b) / (p c): points of one pixel's line obey p (a - u c) = 0 and p (b - v c) = 0, so that it runs along the cross
/// product of the two, which is linear in u and v.
std::optional<Lens> lens_of_ndc(const Matrix44& m) {
  const Vector a = column(m, 0), b = column(m, 1), c = column(m, 3);
  const double volume = dot(cross(a, b), c);
  const double size = std::sqrt(dot(a, a) * dot(b, b) * dot(c, c));
  if (!std::isfinite(volume) || !(std::abs(volume) > 1e-12 * size)) return {};
  // In front of the eye p c is positive. The eye itself has all three zero: Cramer's rule.
  const double sign = volume > 0 ? 1 : -1;
  const Vector eye = times(plus(plus(times(cross(b, c), m[12]), cross(c, a), m[13]), cross(a, b), m[15]), -1 / volume);
  return Lens{times(cross(a, b), sign), times(cross(b, c), sign), times(cross(c, a), sign), unit(c), eye};
}

std::optional<Lens> lens_of_camera(const Matrix44& m, const Camera& camera) {
  const Vector x = column(m, 0), y = column(m, 1), z = column(m, 2);
  const double volume = dot(cross(x, y), z);
  if (!std::isfinite(volume) || !(std::abs(volume) > 1e-12 * std::sqrt(dot(x, x) * dot(y, y) * dot(z, z)))) return {};
  const Vector eye = times(plus(plus(times(cross(y, z), m[12]), cross(z, x), m[13]), cross(x, y), m[14]), -1 / volume);
  // World is right-handed: a matrix that mirrors leads to a left-handed camera space.
  const Vector forward = times(unit(z), volume < 0 ? 1 : -1);
  const double half_width = std::tan(camera.field_of_view / 2), half_height = half_width * camera.height / camera.width;
  const Vector right = times(unit(x), half_width), up = times(unit(y), half_height);
  return Lens{plus(plus(forward, right, -1), up), times(right, 2), times(up, -2), forward, eye};
}

}  // namespace

HazeView haze_view(const Camera& camera) {
  HazeView result;
  result.camera = camera;
  if (camera.projection == Projection::cube) result.faces = 6;
  struct Face {
    std::function<std::optional<Direction>(double, double)> look;
    Direction axis;
  };
  std::vector<Face> faces;
  for (Camera face = camera; face.face < result.faces; ++face.face)
    faces.push_back({viewer(face), view_direction(face, 0.5, 0.5)});
  result.look = [faces](double u, double v) -> std::optional<SightLine> {
    const double across = u * double(faces.size());
    const std::size_t face = std::min(std::size_t(std::max(across, 0.0)), faces.size() - 1);
    const auto seen = faces[face].look(across - double(face), v);
    if (!seen) return {};
    return SightLine{*seen, dot(*seen, faces[face].axis)};
  };
  return result;
}

HazeView haze_view(const InputPicture& picture, UpAxis up, double north, const Camera& camera) {
  const auto fail = [&](const std::string& what) { throw InputError("'" + picture.path + "': " + what); };
  if (!picture.world_to_ndc && !picture.world_to_camera)
    fail("has neither of the attributes worldToNDC and worldToCamera that --exr-camera needs");
  std::optional<Lens> lens =
      picture.world_to_ndc ? lens_of_ndc(*picture.world_to_ndc) : lens_of_camera(*picture.world_to_camera, camera);
  if (!lens) {
    fail(picture.world_to_ndc ? "worldToNDC is no perspective projection" : "worldToCamera has no inverse");
  }
  const double c = std::cos(north), s = std::sin(north);
  const auto to_compass = [&](const Vector& p) -> Vector {
    const Vector level = up == UpAxis::y ? Vector{p[0], -p[2], p[1]} : p;
    return {level[0] * c + level[1] * s, level[1] * c - level[0] * s, level[2]};
  };
  HazeView result;
  result.eye = lens->eye;
  result.eye_height = to_compass(lens->eye)[2];
  for (Vector* v : {&lens->corner, &lens->across, &lens->down, &lens->axis}) *v = to_compass(*v);
  result.look = [l = *lens](double u, double v) -> std::optional<SightLine> {
    const Vector seen = unit(plus(plus(l.corner, l.across, u), l.down, v));
    return SightLine{seen, dot(seen, l.axis)};
  };
  // The same in words, for the Sun's disc: roll is the turn of `across` from the horizontal.
  const Vector middle = plus(plus(lens->corner, lens->across, 0.5), lens->down, 0.5), forward = unit(middle);
  result.camera = camera;
  result.camera.projection = Projection::perspective;
  result.camera.azimuth = std::atan2(forward[0], forward[1]);
  result.camera.elevation = std::asin(std::clamp(forward[2], -1.0, 1.0));
  result.camera.roll = 0;
  result.camera.field_of_view = 2 * std::atan(std::sqrt(dot(lens->across, lens->across) / dot(middle, middle)) / 2);
  const Vector right{std::cos(result.camera.azimuth), -std::sin(result.camera.azimuth), 0};
  result.camera.roll = std::atan2(dot(lens->across, cross(right, forward)), dot(lens->across, right));
  return result;
}

}  // namespace airlight
