#include "optics/colour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"

namespace airlight::test {
namespace {

TEST(Colour, an_equal_energy_spectrum_is_white_for_the_standard_observer) {
  std::vector<double> wavelengths, ones;
  for (int w = 360; w <= 830; w += 5) wavelengths.push_back(w), ones.push_back(1);
  const auto xyz = spectrum_to_xyz(wavelengths, ones);
  EXPECT_NEAR(xyz[0] / xyz[1], 1, 1e-3);  // CIE 15: the sums of the three curves agree to four digits
  EXPECT_NEAR(xyz[2] / xyz[1], 1, 1e-3);
  EXPECT_NEAR(xyz[1], 683 * 106.857, 0.001 * 683 * 106.857);  // integral of V at 1 nm
}

TEST(Colour, white_of_srgb_is_d65) {
  const auto rgb = xyz_to_srgb({0.95047, 1, 1.08883});
  for (double c : rgb) EXPECT_NEAR(c, 1, 1e-4);  // the matrix has seven digits
}

TEST(Colour, four_wavelengths_have_the_colour_of_forty_over_skies_and_twilight) {
  const Atmosphere a = built_in_atmosphere("earth");
  const Sky sky(a);
  const auto forty = photometric_wavelengths();
  const auto four = sky.realtime_wavelengths();
  const auto weights4 = colour_weights(a, four), weights40 = colour_weights(a, forty);
  std::vector<Ray> rays;
  for (double e : {60.0, 10.0, 0.0, -5.0}) {
    for (double v : {2.0, 20.0, 90.0}) rays.push_back({0, toward(40, v), toward(0, e)});
  }
  std::vector<double> few(4 * rays.size()), many(40 * rays.size());
  sky.evaluate(Quantity::radiance, rays, four, few);
  sky.evaluate(Quantity::radiance, rays, forty, many);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    Xyz a4{}, a40{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 4; ++k) a4[c] += weights4[k][c] * few[4 * r + k];
      for (std::size_t k = 0; k < 40; ++k) a40[c] += weights40[k][c] * many[40 * r + k];
    }
    const auto uv = [](const Xyz& v) {
      const double d = v[0] + 15 * v[1] + 3 * v[2];
      return std::array<double, 2>{4 * v[0] / d, 9 * v[1] / d};
    };
    // 0.004 in u'v' is about one just noticeable difference (MacAdam 1942); luminance: a third of one.
    EXPECT_LT(std::hypot(uv(a4)[0] - uv(a40)[0], uv(a4)[1] - uv(a40)[1]), 0.004) << "ray " << r;
    EXPECT_NEAR(a4[1] / a40[1], 1, 0.02) << "ray " << r;
  }
}

}  // namespace
}  // namespace airlight::test
