#include "validate/spectral_colour.h"

#include <gtest/gtest.h>

#include "airlight/sky.h"

namespace airlight::validation {
namespace {

TEST(SpectralColour, more_wavelengths_are_nearer_to_forty) {
  const ColourErrors three = colour_errors("skyview", wavelengths_of(3)),
                     sixteen = colour_errors("skyview", wavelengths_of(16)),
                     forty = colour_errors("skyview", photometric_wavelengths());
  EXPECT_EQ(forty.day.worst, 0);
  EXPECT_EQ(forty.twilight.worst, 0);
  EXPECT_GT(three.day.median, 1) << "three wavelengths are known not to do";
  // 1 is what an eye can just tell apart; the deepest twilight, seen by few wavelengths of ozone's bands, is at 1.1.
  EXPECT_LT(sixteen.day.worst, 1);
  EXPECT_LT(sixteen.twilight.p90, 1);
  EXPECT_LT(sixteen.twilight.worst, 1.5);
}

TEST(SpectralColour, a_fit_is_no_worse_than_the_matrix_that_made_the_skies) {
  // Skies that are grey: any four wavelengths give their colour exactly.
  std::vector<SkySpectrum> skies;
  for (const double brightness : {1e-6, 0.1})
    skies.push_back({"grey", "earth", 30, std::vector<double>(40, brightness)});
  const FittedQuad fit = fit_matrix(skies, {445, 515, 565, 635});
  EXPECT_EQ(fit.wavelengths, (std::array<double, 4>{445, 515, 565, 635}));
  EXPECT_LT(fit.errors.day.worst, 1e-3);
  Xyz sum{};
  for (const Xyz& row : fit.matrix)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += row[c];
  EXPECT_NEAR(sum[1], 683 * 106.857,
              0.02 * 683 * 106.857);  // luminance of 1 at all wavelengths: 683 lm/W times the integral of V
}

}  // namespace
}  // namespace airlight::validation
