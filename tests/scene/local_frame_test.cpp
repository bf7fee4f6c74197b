#include "scene/local_frame.h"

#include <gtest/gtest.h>

#include <random>

namespace airlight {
namespace {

TEST(LocalFrame, altitude_is_the_distance_to_the_centre_less_the_radius) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> far(-2e5, 2e5);
  for (const double radius : {1000.0, 3389500.0, 6371000.0}) {
    const LocalFrame frame(radius);
    for (int i = 0; i < 1000; ++i) {
      const Position p{far(random), far(random), far(random)};
      // In 80 bits, which keep a tenth of a micrometre of r - R.
      const long double x = p[0], y = p[1], z = p[2] + static_cast<long double>(radius);
      const double expected = double(std::sqrt(x * x + y * y + z * z) - static_cast<long double>(radius));
      // The sum of squares is 1e11 at most, its rounding 1e-5, halved and divided by the radius: nanometres on planets.
      EXPECT_NEAR(frame.altitude(p), expected, 1e-9 + 1e-14 * std::abs(expected) * 1e5 / radius * 1e3);
    }
  }
}

TEST(LocalFrame, ground_sinks_below_the_tangent_plane_by_the_square_of_the_distance) {
  const LocalFrame frame(6371000);
  for (const double d : {10.0, 1e3, 1e4, 1e5}) {
    const Position p = frame.position({d, 0, 0});
    // d^2/2R; the next term is d^4/24R^3: 1.6e-2 m at 100 km.
    EXPECT_NEAR(p[2], -d * d / (2 * 6371000.0), 1e-9 + std::pow(d / 1e5, 4) * 0.017);
    EXPECT_NEAR(frame.altitude(p), 0, 1e-8);
  }
}

TEST(LocalFrame, places_on_the_ground_come_back) {
  std::mt19937 random(2);
  for (const double radius : {1000.0, 6371000.0}) {
    const LocalFrame frame(radius);
    // Up to 1 rad, across the seam between series and closed form at 0.1.
    std::uniform_real_distribution<double> along(-0.7 * radius, 0.7 * radius), high(-0.01 * radius, 0.1 * radius);
    for (int i = 0; i < 1000; ++i) {
      const double shrink = i % 2 ? 0.14 : 1;
      const GroundPoint g{shrink * along(random), shrink * along(random), high(random)};
      const GroundPoint back = frame.ground(frame.position(g));
      EXPECT_NEAR(back.east, g.east, 1e-10 * radius);
      EXPECT_NEAR(back.north, g.north, 1e-10 * radius);
      EXPECT_NEAR(back.altitude, g.altitude, 1e-10 * radius);
      const Direction up = frame.up(frame.position(g));
      EXPECT_NEAR(up[0] * up[0] + up[1] * up[1] + up[2] * up[2], 1, 1e-14);
    }
  }
}

}  // namespace
}  // namespace airlight
