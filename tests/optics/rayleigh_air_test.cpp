#include "optics/rayleigh_air.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/atmosphere.h"
#include "optics/coefficients.h"

namespace airlight {
namespace {

/// Bodhaine et al. 1999, eq. 29: their own fit to the cross-section of dry air with 360 ppm of carbon dioxide [m^2];
/// they state it to be good to 0.01 % from 250 to 850 nm. Another formula than ours, with other numbers.
double bodhaine_fit(double wavelength) {
  const double square = wavelength * wavelength * 1e-6, inverse = 1 / square;  // um^2
  return 1e-32 * (1.0455996 - 341.29061 * inverse - 0.90230850 * square) /
         (1 + 0.0027059889 * inverse - 85.968563 * square);
}

TEST(RayleighAir, cross_section_is_that_of_bodhaine_1999) {
  // 0.01 % for the fit, 0.005 % for 400 instead of 360 ppm.
  for (double nm = 250; nm <= 850; nm += 10) {
    EXPECT_NEAR(rayleigh_cross_section_of_air(nm) / bodhaine_fit(nm), 1, 2e-4) << nm;
  }
}

TEST(RayleighAir, king_factor_is_that_of_bates_1984) {
  // Bates 1984, table 1, mean of air; given to three decimals.
  EXPECT_NEAR(king_factor_of_air(400), 1.052, 1e-3);
  EXPECT_NEAR(king_factor_of_air(550), 1.049, 1e-3);
  EXPECT_NEAR(king_factor_of_air(1000), 1.047, 1e-3);
}

TEST(RayleighAir, depolarisation_inverts_the_king_factor) {
  for (const double king : {1.0, 1.0488, 1.15}) {
    const double d = depolarisation_from_king_factor(king);
    EXPECT_NEAR((6 + 3 * d) / (6 - 7 * d), king, 1e-14);
  }
  EXPECT_NEAR(depolarisation_from_king_factor(king_factor_of_air(550)), 0.0283, 1e-4);  // 0.0279 is Young's 1980 mean
}

// Bodhaine et al. 1999, eq. 30: optical depth of the standard atmosphere over 45 degrees north at sea level =
// 0.0021520e28 times the cross-section in m^2. Their column has the weight of 1013.25 hPa; ours is the integral of the
// standard's number density, with its own gravity: 0.1 % apart.
TEST(RayleighAir, optical_depth_of_the_column_is_that_of_bodhaine_1999) {
  const Atmosphere earth = built_in_atmosphere("earth");
  const Constituent& molecules = earth.constituents.at(0);
  const double path = path_length(molecules.profile, earth.planet.top_altitude);
  for (const double nm : {360.0, 400.0, 450.0, 500.0, 550.0, 600.0, 700.0, 830.0}) {
    EXPECT_NEAR(molecules.scattering.at(nm) * path / (0.0021520e32 * bodhaine_fit(nm)), 1, 1.5e-3) << nm;
  }
  EXPECT_NEAR(molecules.scattering.at(550) * path, 0.0971, 1e-4);
  EXPECT_NEAR(molecules.scattering.at(400) * path, 0.3603, 4e-4);
}

}  // namespace
}  // namespace airlight
