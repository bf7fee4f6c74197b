// Tools of the painter: tables from pictures, and what they do to a table.
#include "model/realworldz_paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Air of a small planet: thick at the horizon, all directions below it the same.
SkyGeometry sky() {
  return {direction(0.3, 12 * degree),
          [](double elevation) { return 0.3 / (std::max(std::sin(elevation), 0.0) + 0.12); }};
}
Camera panorama() {
  Camera camera;
  camera.width = 720, camera.height = 360;
  return camera;
}
std::vector<float> rendered(const SkyTable& table, const Camera& camera) {
  std::vector<float> rgb;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto c = colour_at(
          table, place_of(sky(), view_direction(camera, (x + 0.5) / camera.width, (y + 0.5) / camera.height)));
      for (int k = 0; k < 3; ++k) rgb.push_back(float(c[std::size_t(k)]));
    }
  }
  return rgb;
}

// The specification asks for a peak signal-to-noise ratio of 35 dB where the photograph covers.
TEST(BackProjection, of_a_rendered_sky_renders_the_same_sky) {
  const SkyTable table = realworldz_starter();
  const std::vector<float> photograph = rendered(table, panorama());
  const Projected projected = back_projected(photograph, panorama(), sky());
  const std::vector<float> again = rendered(projected.table, panorama());
  double sum = 0;
  for (std::size_t i = 0; i < again.size(); ++i) sum += std::pow(double(again[i]) - double(photograph[i]), 2);
  EXPECT_GE(10 * std::log10(1 / (sum / double(again.size()))), 35);
}

TEST(BackProjection, fills_what_no_pixel_showed_smoothly_between_what_they_did) {
  // A picture of one colour: every texel gets it, but for the starter's alpha.
  const Camera camera = panorama();
  std::vector<float> grey(3u * 720 * 360, 0.5f);
  const Projected projected = back_projected(grey, camera, sky());
  ASSERT_TRUE(std::ranges::count(projected.covered, false) > 1000);
  const SkyTable starter = realworldz_starter();
  for (std::size_t i = 0; i < projected.covered.size(); ++i) {
    const double expected = projected.covered[i] ? 0.5 : 0.5 * starter.rgba[4 * i + 3];
    ASSERT_NEAR(projected.table.rgba[4 * i], expected, 1e-6) << "texel " << i;
  }
}

TEST(Painter, finds_the_texel_of_a_pixel_and_the_pixels_of_a_texel) {
  const SkyTable table = realworldz_starter();
  const Camera camera = panorama();
  const TablePlace place = place_of(sky(), view_direction(camera, 200.5 / 720, 120.5 / 360));
  const int column = int(place.x * 256), row = int(place.y * 256);
  const std::vector<float> seen = highlight(table, column, row, sky(), camera);
  EXPECT_EQ(seen[120 * 720 + 200], 1);
  // A texel is a ring around the Sun cut by a ring of elevation: far fewer pixels than the picture has.
  EXPECT_LT(std::ranges::count(seen, 1.0f), 720 * 360 / 20);
  const TablePlace at_sun = place_of(sky(), sky().sun),
                   opposite = place_of(sky(), {-sky().sun[0], -sky().sun[1], -sky().sun[2]});
  EXPECT_NEAR(at_sun.x, 0, 1e-12);
  EXPECT_NEAR(opposite.x, 1, 1e-6);
}

TEST(Painter, sees_sharp_edges) {
  SkyTable table = realworldz_starter();
  const auto before = discontinuities(table);
  for (int column = 128; column < 256; ++column) table.texel(column, 100)[0] += 1;
  const auto after = discontinuities(table);
  EXPECT_GT(after[100 * 256 + 200], 0.9);
  EXPECT_GT(after[99 * 256 + 200], 0.9);
  EXPECT_EQ(after[50 * 256 + 200], before[50 * 256 + 200]);
}

TEST(Painter, adjusts_whole_tables) {
  const SkyTable starter = realworldz_starter();
  const double* const was = starter.texel(100, 50);
  SkyTable table = starter;
  adjust(table, {});
  for (std::size_t i = 0; i < table.rgba.size(); ++i)
    ASSERT_NEAR(table.rgba[i], starter.rgba[i], 1e-12) << "nothing asked";
  table = starter;
  adjust(table, {.lighten = 2});
  EXPECT_NEAR(table.texel(100, 50)[1], 2 * was[1], 1e-12);
  table = starter;
  adjust(table, {.redden = 0.2});
  EXPECT_GT(table.texel(100, 50)[0], was[0]);
  EXPECT_LT(table.texel(100, 50)[2], was[2]);
  table = starter;
  adjust(table, {.hue = 2 * std::numbers::pi / 3});  // a third of a turn moves the channels on
  EXPECT_NEAR(table.texel(100, 50)[1], was[0], 1e-12);
}

}  // namespace
}  // namespace airlight::test
