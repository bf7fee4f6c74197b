#include "optics/colour_difference.h"

#include <gtest/gtest.h>

namespace airlight {
namespace {

/// Pairs of Sharma, Wu & Dalal 2005 (table 1), which meet every branch of the formula; they state four digits.
TEST(ColourDifference, is_that_of_published_pairs) {
  struct Pair {
    Lab a, b;
    double difference;
  };
  const Pair pairs[] = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                        {{50, 0, 0}, {50, -1, 2}, 2.3669},
                        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                        {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                        {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  for (const Pair& pair : pairs) {
    EXPECT_NEAR(ciede2000(pair.a, pair.b), pair.difference, 5e-5);
    EXPECT_NEAR(ciede2000(pair.b, pair.a), pair.difference, 5e-5);
  }
}

TEST(ColourDifference, white_is_white_and_exposure_does_not_matter) {
  const Lab white = lab_of({0.95047, 1, 1.08883});
  EXPECT_NEAR(white[0], 100, 1e-9);
  EXPECT_NEAR(white[1], 0, 1e-9);
  EXPECT_NEAR(white[2], 0, 1e-9);
  const Xyz day{4000, 4200, 6000}, other{4100, 4200, 5500};
  const auto dimmed = [](Xyz colour) {
    for (double& c : colour) c *= 1e-7;
    return colour;
  };
  EXPECT_GT(colour_difference(day, other), 1);
  EXPECT_NEAR(colour_difference(dimmed(day), dimmed(other)), colour_difference(day, other), 1e-6);
  EXPECT_EQ(colour_difference({0, 0, 0}, other), 0);
}

}  // namespace
}  // namespace airlight
