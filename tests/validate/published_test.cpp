// Published values as they are written here, by what is known of them beside the formulae; and our air against them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "validate/air_mass.h"
#include "validate/direct_spectrum.h"
#include "validate/illuminance.h"
#include "validate/measured_sky.h"

namespace airlight::validation {
namespace {

/// Neighbouring polynomials were fitted to meet: a wrong digit in any of them shows as a step.
TEST(PublishedIlluminance, has_no_steps) {
  for (const double joint : {20.0, 5.0, -0.8, -5.0, -12.0})
    EXPECT_NEAR(published_illuminance(joint - 1e-6) / published_illuminance(joint), 1, 0.02) << joint;
  EXPECT_NEAR(published_illuminance(-6), 3.4, 0.05);  // the end of civil twilight, as commonly told
}

/// Both formulae are fits of one table, for elevations with and without refraction, which is below 0.1 degrees from 10 degrees on.
TEST(PublishedAirMass, formulae_agree_where_refraction_is_small) {
  EXPECT_NEAR(air_mass_kasten_young(90), 1, 3e-4);
  EXPECT_NEAR(air_mass_young(90), 1, 3e-4);
  for (const double elevation : {60.0, 30.0, 15.0, 10.0})
    EXPECT_NEAR(air_mass_kasten_young(elevation) / air_mass_young(elevation), 1, 0.01) << elevation;
  EXPECT_NEAR(air_mass_kasten_young(0), 38, 0.2);
}

TEST(AirMass, is_the_published_one_but_for_refraction) {
  for (const AirMass& mass : air_masses()) {
    // Straight rays cross less air than those that bend with the ground, more than those that come in flatter for being bent.
    EXPECT_LT(mass.here, mass.kasten_young * (1 + 5e-4)) << mass.elevation;  // at the zenith the fit is off by 3e-4
    EXPECT_GT(mass.here, mass.young * (1 - 5e-4)) << mass.elevation;
    if (mass.elevation >= 20) {
      EXPECT_NEAR(mass.here / mass.kasten_young, 1, 0.002) << mass.elevation;
    }
  }
}

TEST(DirectSpectrum, is_that_of_the_standard) {
  const DirectSpectrumError error = compare_with_g173(AIRLIGHT_DATA "/measured/astm_g173.csv");
  EXPECT_EQ(error.count, 281u - 16 - 11);  // every nanometre of 400 to 680 but the bands'
  EXPECT_LT(error.rms, 0.025);             // the project's bound
}

TEST(MeasuredSky, error_is_relative_to_what_was_measured) {
  const MeasuredSky sky = read_measured_sky(AIRLIGHT_DATA "/measured/measured_sky_20130527.json");
  ASSERT_EQ(sky.scans.size(), 5u);
  EXPECT_EQ(sky.wavelengths.size(), 37u);
  std::size_t scan = 0;
  for (const auto& one : sky.scans) EXPECT_EQ(one.rays.size(), 80u) << "81 directions, one of them wrong";
  const auto brighter = [&](std::span<const Ray>, const std::vector<double>&) {
    std::vector<double> values = sky.scans[scan++].values;
    for (double& value : values) value *= 1.1;
    return values;
  };
  const MeasuredSkyError error = compare_with_measured_sky(sky, brighter);
  EXPECT_NEAR(error.all, 0.1, 1e-12);
  EXPECT_NEAR(error.bias, 0.1, 1e-12);
  EXPECT_NEAR(error.scans[2], 0.1, 1e-12);

  const MeasuredSky part = at_every(sky, 4);
  ASSERT_EQ(part.wavelengths.size(), 10u);
  EXPECT_EQ(part.wavelengths[3], sky.wavelengths[12]);
  EXPECT_EQ(part.scans[1].values.size(), 10u * 80);
  EXPECT_EQ(part.scans[1].values[23], sky.scans[1].values[2 * 37 + 12]);
}

/// Sunlight's lines are in the sky's light, too: what sky and sunlight have to each other is smooth, if both are taken in the same boxes.
TEST(MeasuredSky, boxes_have_the_stated_wavelengths_in_their_middles) {
  const MeasuredSky sky = read_measured_sky(AIRLIGHT_DATA "/measured/measured_sky_20130527.json");
  const StandardSpectrum standard = read_standard_spectrum(AIRLIGHT_DATA "/measured/astm_g173.csv");
  const std::size_t count = sky.wavelengths.size();
  std::vector<double> measured(count, 0.0);
  for (const auto& scan : sky.scans)
    for (std::size_t i = 0; i < scan.values.size(); ++i) measured[i % count] += scan.values[i];
  const auto roughness = [&](double shift) {
    std::vector<double> ratio;  // up to 480 nm, where the air has no bands
    for (std::size_t w = 0; sky.wavelengths[w] <= 480; ++w) {
      const double middle = sky.wavelengths[w] + shift;
      ratio.push_back(std::log(measured[w] / standard.above_in_box(middle - 5, middle + 5)));
    }
    double sum = 0;
    for (std::size_t i = 3; i < ratio.size(); ++i)
      sum += std::pow(ratio[i] - 3 * ratio[i - 1] + 3 * ratio[i - 2] - ratio[i - 3], 2);
    return std::sqrt(sum);
  };
  // Two nanometres tell; half of a box, by which bins that begin at the stated wavelength would be off, is far.
  EXPECT_LT(roughness(0), 0.7 * roughness(-2));
  EXPECT_LT(roughness(0), 0.7 * roughness(2));
  EXPECT_LT(roughness(0), 0.5 * roughness(5));
}

}  // namespace
}  // namespace airlight::validation
