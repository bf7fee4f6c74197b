// The star map: places, light and colours of real stars.
#include "model/realworldz_stars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "golden.h"
#include "model/realworldz.h"

namespace airlight::test {
namespace {

Direction sky(double ascension, double declination) {
  const double a = ascension * std::numbers::pi / 180, d = declination * std::numbers::pi / 180;
  return {std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
}

// Positions, magnitudes and colours of stars that any almanac has, to the digits given.
TEST(Stars, are_the_real_ones) {
  const std::vector<Star>& stars = star_catalogue();
  ASSERT_EQ(stars.size(), 5044u);
  const auto nearest = [&](const Direction& d) {
    return *std::ranges::max_element(stars, {}, [&](const Star& s) {
      return s.direction[0] * d[0] + s.direction[1] * d[1] + s.direction[2] * d[2];
    });
  };
  const Star sirius = nearest(sky(101.287, -16.716)), polaris = nearest(sky(37.95, 89.264)),
             betelgeuse = nearest(sky(88.793, 7.407)), rigel = nearest(sky(78.634, -8.202));
  EXPECT_NEAR(sirius.magnitude, -1.44, 0.03);
  EXPECT_NEAR(polaris.magnitude, 1.98, 0.05);
  EXPECT_NEAR(betelgeuse.colour_index, 1.5, 0.1);
  EXPECT_NEAR(rigel.colour_index, -0.03, 0.05);
}

TEST(Stars, are_white_blue_or_orange_as_their_index_says) {
  const auto blue = star_colour(-0.2), sun = star_colour(0.65), orange = star_colour(1.8);
  EXPECT_GT(blue[2], 1.3 * blue[0]);
  EXPECT_GT(orange[0], 2 * orange[2]);
  // A black body of 5800 K is near sRGB's white of 6500 K, a little warmer.
  EXPECT_NEAR(sun[0] / sun[2], 1.25, 0.25);
  for (double index : {-0.3, 0.0, 0.65, 1.5, 3.2}) {
    const auto c = star_colour(index);
    EXPECT_NEAR(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2], 1, 1e-12) << index;
  }
}

TEST(StarMap, holds_all_the_stars_light) {
  const int size = 128, height = size + 2;
  const StarMap map = star_map(size);
  double sum = 0, expected = 0;
  for (const Star& s : star_catalogue()) expected += std::pow(10, -0.4 * s.magnitude);
  for (int face = 0; face < 6; ++face) {
    for (int j = 1; j <= size; ++j) {
      for (int i = 1; i <= size; ++i) {
        const double s = (i - 0.5) * 2 / size - 1, t = (j - 0.5) * 2 / size - 1;
        const double* c = &map.rgba[4 * (std::size_t(face * height + j) * map.shape.width + i)];
        sum += (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]) * 4.0 / (size * size) / std::pow(1 + s * s + t * t, 1.5);
      }
    }
  }
  // A star within half a texel of an edge leaves part of its light on the border; a texel's solid angle is taken at the star: 1 % in all.
  EXPECT_NEAR(sum, expected, 0.01 * expected);
}

class StarKernel : public testing::TestWithParam<const char*> {};
// The kernel looks where the map was painted: in the direction of a star it finds light, ten degrees off the brightest none as bright.
TEST_P(StarKernel, finds_each_bright_star) {
  const auto engine = engine_or_none(GetParam());
  if (!engine) GTEST_SKIP() << "no engine " << GetParam();
  EngineCaller kernels(*engine);
  const int size = 256;
  const StarMap map = star_map(size);
  for (std::size_t k = 0; k < 60; ++k) {
    const Star& star = star_catalogue()[k];
    const auto at = kernels.call("core.cube_uv",
                                 {{"d", {star.direction.begin(), star.direction.end()}}, {"width", {size + 2.0}}}, {});
    const int i = int(std::lround(at[0] * map.shape.width - 0.5)), j = int(std::lround(at[1] * map.shape.height - 0.5));
    double brightest = 0;
    for (int y = j - 1; y <= j + 1; ++y)
      for (int x = i - 1; x <= i + 1; ++x)
        brightest = std::max(brightest, map.rgba[4 * (std::size_t(y) * map.shape.width + x) + 1]);
    // At least a quarter of the star's light is on its nearest texel.
    EXPECT_GT(brightest, 0.2 * std::pow(10, -0.4 * star.magnitude) * size * size / 4) << "star " << k;
  }
}
INSTANTIATE_TEST_SUITE_P(engines, StarKernel, testing::Values("double", "simd", "gl"));

}  // namespace
}  // namespace airlight::test
