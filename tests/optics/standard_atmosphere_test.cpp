#include "optics/standard_atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/atmosphere.h"

namespace airlight {
namespace {

struct Published {
  double altitude, value;
};

// Mass densities [kg/m^3] of the standard's table I at geometric altitudes, five digits. Up to 80 km air is mixed
// evenly, so relative mass density is relative number density.
TEST(StandardAtmosphere, density_is_that_of_the_published_table_below_80_km) {
  for (const auto [altitude, mass_density] : {Published{0, 1.2250},
                                              {5'000, 7.3643e-1},
                                              {10'000, 4.1351e-1},
                                              {15'000, 1.9476e-1},
                                              {20'000, 8.8910e-2},
                                              {25'000, 4.0084e-2},
                                              {30'000, 1.8410e-2},
                                              {35'000, 8.4634e-3},
                                              {40'000, 3.9957e-3},
                                              {45'000, 1.9663e-3},
                                              {50'000, 1.0269e-3},
                                              {55'000, 5.6810e-4},
                                              {60'000, 3.0968e-4},
                                              {65'000, 1.6321e-4},
                                              {70'000, 8.2829e-5},
                                              {75'000, 3.9921e-5}}) {
    EXPECT_NEAR(standard_atmosphere::density(altitude) * 1.2250 / mass_density, 1, 5e-5) << altitude;  // half a digit
  }
}

// The layers' bases: pressure [Pa] and temperature [K] at geopotential heights, table 4 and table I of the standard.
TEST(StandardAtmosphere, bases_of_the_layers_have_the_published_pressure) {
  struct Base {
    double height, pressure, temperature;
  };
  for (const auto [height, pressure, temperature] : {Base{11'000, 22'632.1, 216.65},
                                                     {20'000, 5'474.89, 216.65},
                                                     {32'000, 868.019, 228.65},
                                                     {47'000, 110.906, 270.65},
                                                     {51'000, 66.9389, 270.65},
                                                     {71'000, 3.95642, 214.65}}) {
    const double altitude = 6'356'766 * height / (6'356'766 - height);
    const double expected = pressure / 101'325 * 288.15 / temperature;
    EXPECT_NEAR(standard_atmosphere::density(altitude) / expected, 1, 1e-5) << height;  // six digits
  }
}

// Number densities [1/m^3], four digits; odd kilometres are not in our table, which is logarithmic between.
TEST(StandardAtmosphere, number_density_is_that_of_the_published_table_above_86_km) {
  for (const auto [altitude, number_density] : {Published{86'000, 1.447e20},
                                                {87'000, 1.212e20},
                                                {90'000, 7.116e19},
                                                {95'000, 2.920e19},
                                                {100'000, 1.189e19},
                                                {105'000, 5.021e18},
                                                {110'000, 2.144e18},
                                                {111'000, 1.800e18},
                                                {115'000, 9.681e17},
                                                {120'000, 5.107e17}}) {
    const double tolerance = std::fmod(altitude, 2000) == 0 ? 4e-4 : 6e-3;
    EXPECT_NEAR(standard_atmosphere::density(altitude) * 2.5470e25 / number_density, 1, tolerance) << altitude;
  }
}

TEST(StandardAtmosphere, density_falls_without_steps) {
  // Nowhere does it fall faster than over 5 km by a factor e: 2e-4 a metre.
  for (double altitude = 0; altitude < 120'000; altitude += 50) {
    const double here = standard_atmosphere::density(altitude), above = standard_atmosphere::density(altitude + 50);
    EXPECT_LT(above, here) << altitude;
    EXPECT_GT(above, here * (1 - 50 * 2e-4)) << altitude;
  }
}

// The weight of the column is the pressure at the ground: integral of density * g = p / (density of one), in closed
// form.
TEST(StandardAtmosphere, column_weighs_what_the_ground_feels) {
  double weight = 0;
  for (double altitude = 0; altitude < 120'000; altitude += 100) {
    const double radius = 6'356'766, g = 9.80665 * std::pow(radius / (radius + altitude + 50), 2);
    weight += mean_density(StandardAtmosphereProfile{}, altitude, altitude + 100) * 1.2250 * g * 100;
  }
  EXPECT_NEAR(weight / 101'325, 1, 2e-5);  // 1.2250 has five digits
}

}  // namespace
}  // namespace airlight
