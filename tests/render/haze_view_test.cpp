// A camera in words and the same camera as matrices see the same.
#include "render/haze_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"

namespace airlight {
namespace {

using Vector = std::array<double, 3>;
constexpr double deg = 0.017453292519943295;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// East, north, up as a file with that axis up has them.
Vector to_file(const Vector& p, UpAxis up) { return up == UpAxis::z ? p : Vector{p[0], p[2], -p[1]}; }

/// Matrices for row vectors, made from the camera's own axes.
struct Matrices {
  Matrix44 world_to_camera, world_to_ndc;
};
Matrices matrices(const Camera& camera, const Vector& eye, UpAxis up, bool left_handed, double shift = 0) {
  Vector forward = direction(camera.azimuth, camera.elevation);
  const Vector level{std::cos(camera.azimuth), -std::sin(camera.azimuth), 0}, above = cross(level, forward);
  Vector right{}, top{};
  for (std::size_t i = 0; i < 3; ++i) {
    right[i] = level[i] * std::cos(camera.roll) + above[i] * std::sin(camera.roll);
    top[i] = above[i] * std::cos(camera.roll) - level[i] * std::sin(camera.roll);
  }
  const Vector axes[] = {to_file(right, up), to_file(top, up), to_file(forward, up)}, from = to_file(eye, up);
  Matrices m{};
  const double half_width = std::tan(camera.field_of_view / 2), half_height = half_width * camera.height / camera.width;
  for (std::size_t row = 0; row < 4; ++row) {
    double along[3];
    for (std::size_t c = 0; c < 3; ++c) along[c] = row < 3 ? axes[c][row] : -dot(from, axes[c]);
    m.world_to_camera[4 * row] = along[0];
    m.world_to_camera[4 * row + 1] = along[1];
    m.world_to_camera[4 * row + 2] = left_handed ? along[2] : -along[2];
    m.world_to_camera[4 * row + 3] = row == 3;
    m.world_to_ndc[4 * row] = 0.5 * along[0] / half_width + (0.5 + shift) * along[2];
    m.world_to_ndc[4 * row + 1] = -0.5 * along[1] / half_height + 0.5 * along[2];
    m.world_to_ndc[4 * row + 2] = 0.1 * along[2] + (row == 3);
    m.world_to_ndc[4 * row + 3] = along[2];
  }
  return m;
}

const Camera camera{.projection = Projection::perspective,
                    .width = 160,
                    .height = 90,
                    .azimuth = 130 * deg,
                    .elevation = -20 * deg,
                    .roll = 12 * deg,
                    .field_of_view = 50 * deg};
const Vector eye{3, -5, 7};

void expect_same(const HazeView& a, const HazeView& b) {
  for (const double u : {0.0, 0.3, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 0.9}) {
      const SightLine x = *a.look(u, v), y = *b.look(u, v);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(x.view[i], y.view[i], 1e-12) << u << ' ' << v;
      EXPECT_NEAR(x.cosine, y.cosine, 1e-12);
    }
  }
}

TEST(HazeView, matrices_of_every_convention_see_what_words_say) {
  for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
    for (const bool left_handed : {true, false}) {
      const Matrices m = matrices(camera, eye, up, left_handed);
      InputPicture picture{.path = "shot.exr", .width = 160, .height = 90};
      picture.world_to_camera = m.world_to_camera;
      const HazeView of_camera = haze_view(picture, up, 0, camera);
      picture.world_to_ndc = m.world_to_ndc;
      Camera unknown{.projection = Projection::perspective, .width = 160, .height = 90, .field_of_view = 1};
      const HazeView of_ndc = haze_view(picture, up, 0, unknown);
      const HazeView of_words = haze_view(camera);
      expect_same(of_camera, of_words);
      expect_same(of_ndc, of_words);
      expect_same(haze_view(of_ndc.camera), of_words);  // its words too
      for (const HazeView* view : {&of_camera, &of_ndc}) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*view->eye)[i], to_file(eye, up)[i], 1e-11);
        EXPECT_NEAR(view->eye_height, eye[2], 1e-11);
      }
    }
  }
}

TEST(HazeView, the_compass_turns_the_file) {
  InputPicture picture{.path = "shot.exr", .width = 160, .height = 90};
  picture.world_to_ndc = matrices(camera, eye, UpAxis::y, true).world_to_ndc;
  Camera turned = camera;
  turned.azimuth += 40 * deg;
  expect_same(haze_view(picture, UpAxis::y, 40 * deg, camera), haze_view(turned));
}

TEST(HazeView, a_shifted_lens_shows_its_axis_beside_the_middle) {
  InputPicture picture{.path = "shot.exr", .width = 160, .height = 90};
  picture.world_to_ndc = matrices(camera, eye, UpAxis::z, true, 0.25).world_to_ndc;
  const HazeView shifted = haze_view(picture, UpAxis::z, 0, camera), straight = haze_view(camera);
  for (const double u : {0.3, 0.75, 1.0}) {
    const SightLine a = *shifted.look(u, 0.4), b = *straight.look(u - 0.25, 0.4);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.view[i], b.view[i], 1e-12);
    EXPECT_NEAR(a.cosine, b.cosine, 1e-12);  // z is measured along the axis, not along the middle
  }
}

TEST(HazeView, a_cube_has_an_axis_for_each_face) {
  const HazeView view = haze_view(Camera{.projection = Projection::cube, .width = 16, .height = 16});
  for (int face = 0; face < 6; ++face) {
    EXPECT_NEAR(view.look((face + 0.5) / 6, 0.5)->cosine, 1, 1e-12);
    EXPECT_NEAR(view.look((face + 1e-9) / 6, 0.5)->cosine, std::sqrt(0.5), 1e-6);
  }
}

TEST(HazeView, files_without_a_lens_are_refused) {
  InputPicture picture{.path = "shot.exr", .width = 160, .height = 90};
  EXPECT_THROW(haze_view(picture, UpAxis::z, 0, camera), InputError);
  picture.world_to_ndc = Matrix44{};
  EXPECT_THROW(haze_view(picture, UpAxis::z, 0, camera), InputError);
  picture.world_to_ndc = Matrix44{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // orthographic
  EXPECT_THROW(haze_view(picture, UpAxis::z, 0, camera), InputError);
}

}  // namespace
}  // namespace airlight
