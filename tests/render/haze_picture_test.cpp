// Coverage, sky and edges of a hazed picture.
#include "render/haze_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace airlight {
namespace {

constexpr float sky_away = std::numeric_limits<float>::infinity();
constexpr int width = 16, height = 9;
constexpr std::size_t pixels = width * height;

struct Hazed : testing::Test {
  const Sky sky{built_in_atmosphere("earth"), "skyview"};
  const HazeView view = haze_view(Camera{.projection = Projection::perspective,
                                         .width = width,
                                         .height = height,
                                         .azimuth = 0.3,
                                         .elevation = 0.1,
                                         .field_of_view = 0.9});
  HazeSettings settings{.altitude = 500, .sun = direction(0.5, 0.4), .sun_disc = false};

  std::vector<float> haze(std::vector<float> distance, std::vector<float> rgba) const {
    HazePicture(sky, view, settings).rows(0, distance, rgba);
    return rgba;
  }
  static std::vector<float> flat(float r, float g, float b, float alpha) {
    std::vector<float> rgba;
    for (std::size_t i = 0; i < pixels; ++i) rgba.insert(rgba.end(), {r * alpha, g * alpha, b * alpha, alpha});
    return rgba;
  }
};

TEST_F(Hazed, covers_like_paint) {
  const std::vector<float> far(pixels, 20'000), none(pixels, sky_away);
  const auto solid = haze(far, flat(300, 500, 200, 1)), half = haze(far, flat(300, 500, 200, 0.25f)),
             behind = haze(none, flat(0, 0, 0, 0));
  settings.fill_sky = false;
  const auto left = haze(far, flat(300, 500, 200, 0.25f));
  for (std::size_t i = 0; i < 4 * pixels; ++i) {
    ASSERT_NEAR(half[i], 0.25 * double(solid[i]) + 0.75 * double(behind[i]),
                1e-5 * double(solid[i] + behind[i]));  // floats
    ASSERT_NEAR(left[i], 0.25 * double(solid[i]), 1e-5 * double(solid[i]));
  }
}

TEST_F(Hazed, a_point_on_the_lens_has_no_air_before_it) {
  const auto rgba = haze(std::vector<float>(pixels, 0.0f), flat(300, 500, 200, 1));
  for (std::size_t i = 0; i < pixels; ++i) {
    EXPECT_NEAR(rgba[4 * i], 300, 1e-3);  // floats, and an air of no length
    EXPECT_NEAR(rgba[4 * i + 1], 500, 1e-3);
    EXPECT_NEAR(rgba[4 * i + 2], 200, 1e-3);
  }
}

TEST_F(Hazed, the_sky_is_that_of_sky_pictures) {
  const auto rgba = haze(std::vector<float>(pixels, sky_away), flat(1, 2, 3, 1));
  Camera camera = view.camera;
  camera.altitude = settings.altitude;
  sky.render(camera, settings.sun, {.sun_disc = false, .wavelengths = {}},
             [&](int begin, int end, std::span<const float> rows) {
               for (std::size_t i = 0; i < rows.size(); ++i) {
                 const float here = rgba[std::size_t(4 * width * begin) + i];
                 // Pictures come from a table made for the sky, haze from one for points: 1 % between two interpolations.
                 EXPECT_NEAR(here, rows[i], 0.01 * double(rows[i])) << begin << ' ' << end << ' ' << i;
               }
               return true;
             });
  settings.fill_sky = false;
  const auto left = haze(std::vector<float>(pixels, sky_away), flat(1, 2, 3, 1));
  EXPECT_EQ(left, flat(1, 2, 3, 1));
}

TEST_F(Hazed, dark_things_brighten_with_distance_and_turn_blue_first) {
  double before = 0;
  for (const float away : {100.0f, 3000.0f, 100'000.0f}) {
    const auto rgba = haze(std::vector<float>(pixels, away), flat(0, 0, 0, 1));
    const double red = rgba[4 * (pixels / 2)], blue = rgba[4 * (pixels / 2) + 2];
    EXPECT_GT(blue, before);
    // Thin air scatters blue more than red; a hundred kilometres are not thin.
    if (away < 10'000) {
      EXPECT_GT(blue, red);
    }
    before = blue;
  }
}

TEST(HazeEdges, take_the_nearest_depth_beside_them) {
  //           sky   edge  far  near
  std::vector<float> distance{sky_away, sky_away, 900, 300};
  const std::vector<float> rgba{0, 0, 0, 0, 1, 1, 1, 0.5f, 1, 1, 1, 1, 1, 1, 1, 1};
  mend_edges(4, 1, distance, rgba);
  EXPECT_EQ(distance, (std::vector<float>{sky_away, 900, 900, 300}));  // empty and opaque pixels stay
}

}  // namespace
}  // namespace airlight
