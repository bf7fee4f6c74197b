#include "airlight/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/atmosphere.h"

namespace airlight {
namespace {

TEST(Spectrum, points_are_linear_between_and_constant_beyond) {
  const Spectrum spectrum(TableSpectrum{{400, 500, 700}, {1, 3, 7}, Sampling::point, ""});
  EXPECT_DOUBLE_EQ(spectrum.at(400), 1);
  EXPECT_DOUBLE_EQ(spectrum.at(450), 2);
  EXPECT_DOUBLE_EQ(spectrum.at(600), 5);
  EXPECT_DOUBLE_EQ(spectrum.at(700), 7);
  EXPECT_DOUBLE_EQ(spectrum.at(100), 1);
  EXPECT_DOUBLE_EQ(spectrum.at(9000), 7);
}

TEST(Spectrum, bins_belong_to_their_centres) {
  const Spectrum spectrum(TableSpectrum{{400, 410, 420}, {1, 3, 7}, Sampling::bins, ""});
  EXPECT_DOUBLE_EQ(spectrum.at(405), 1);
  EXPECT_DOUBLE_EQ(spectrum.at(410), 2);
  EXPECT_DOUBLE_EQ(spectrum.at(415), 3);
  EXPECT_DOUBLE_EQ(spectrum.at(400), 1) << "the first half bin holds the first value";
  EXPECT_DOUBLE_EQ(spectrum.at(430), 7);
}

TEST(Spectrum, stated_wavelengths_are_inside_the_data) {
  const Spectrum bins(TableSpectrum{{400, 410, 420}, {1, 3, 7}, Sampling::bins, ""});
  EXPECT_EQ(bins.range()->first, 400);
  EXPECT_EQ(bins.range()->last, 420);
  EXPECT_FALSE(Spectrum(3.0).range().has_value());
  EXPECT_FALSE(Spectrum(PowerSpectrum{550, 1, -4}).range().has_value());
}

TEST(Spectrum, power_law_doubles_as_it_should) {
  const Spectrum law(PowerSpectrum{500, 3, -1});
  EXPECT_DOUBLE_EQ(law.at(500), 3);
  EXPECT_DOUBLE_EQ(law.at(1000), 1.5);
}

TEST(Spectrum, scaling_multiplies_every_law) {
  const std::vector<Spectrum> laws{Spectrum(2.0),
                                   Spectrum(PowerSpectrum{500, 3, -1}),
                                   Spectrum(TableSpectrum{{400, 500}, {1, 3}, Sampling::point, ""}),
                                   Spectrum(RayleighAirSpectrum{}),
                                   Spectrum(HestrofferMagnanSpectrum{}),
                                   Spectrum(ProductSpectrum{{2.0, 3.0}, {0.25}}),
                                   Spectrum(ColumnSpectrum{300, 1e4, {1e-25}})};
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double value = laws[i].at(470);
    EXPECT_GT(value, 0) << i;
    EXPECT_DOUBLE_EQ(laws[i].scaled(0.3).at(470), 0.3 * value) << i;
    EXPECT_DOUBLE_EQ(laws[i].scaled(0.3).scaled(5).at(470), 1.5 * value) << i;
    EXPECT_EQ(laws[i].scaled(0), Spectrum(0.0)) << i;
    EXPECT_EQ(laws[i].scaled(1), laws[i]) << i;
    EXPECT_NE(laws[i].scaled(2), laws[i]) << i;
  }
  EXPECT_EQ(Spectrum(2.0).scaled(3), Spectrum(6.0)) << "a constant stays a plain number";
}

TEST(Spectrum, product_multiplies_factors_and_complements) {
  const Spectrum half(TableSpectrum{{400, 500}, {0.5, 0.25}, Sampling::point, ""});
  EXPECT_DOUBLE_EQ(Spectrum(ProductSpectrum{{4.0, half}, {0.2}}).at(400), 4 * 0.5 * 0.8);
  EXPECT_DOUBLE_EQ(Spectrum(ProductSpectrum{{4.0}, {half}}).at(500), 4 * 0.75);
  const Spectrum other(TableSpectrum{{450, 600}, {1, 1}, Sampling::point, ""});
  const auto range = Spectrum(ProductSpectrum{{half}, {other}}).range();
  EXPECT_EQ(range->first, 450);
  EXPECT_EQ(range->last, 500);
}

TEST(Spectrum, column_spreads_dobson_units_over_the_path) {
  // 100 units of 2.687e20 / m^2 over 1 km, 1e-25 m^2 each.
  const Spectrum column(ColumnSpectrum{100, 1000, {1e-25}});
  EXPECT_DOUBLE_EQ(column.at(550), 100 * dobson_unit / 1000 * 1e-25);
}

// Hestroffer & Magnan 1998 fit to Neckel & Labs 1994. The ratio of mean to central brightness of a disc with
// I(mu) = mu^a is 2 / (a + 2); Allen's Astrophysical Quantities (4th ed., section 14.7) lists 0.83 at 600 nm and 0.76
// at 400 nm, rounded to 0.01.
TEST(Spectrum, limb_darkening_gives_the_suns_mean_brightness) {
  const Spectrum exponent(HestrofferMagnanSpectrum{});
  EXPECT_NEAR(exponent.at(600), -0.023 + 0.292 / 0.6, 1e-12);
  EXPECT_NEAR(exponent.at(350), -0.507 + 0.441 / 0.35, 1e-12);
  EXPECT_NEAR(2 / (exponent.at(600) + 2), 0.83, 0.02);
  EXPECT_NEAR(2 / (exponent.at(400) + 2), 0.76, 0.02);
}

TEST(Spectrum, limb_darkening_has_no_steps) {
  const Spectrum exponent(HestrofferMagnanSpectrum{});
  // The steepest fit falls by 441 / 303^2 = 0.005 a nanometre.
  for (double nm = 250; nm < 1200; nm += 0.5) EXPECT_NEAR(exponent.at(nm), exponent.at(nm + 0.5), 0.003) << nm;
}

}  // namespace
}  // namespace airlight
