// Densities against their definitions, means against brute force, kinks against the second derivative.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "airlight/atmosphere.h"

namespace airlight {
namespace {

struct Named {
  const char* name;
  Profile profile;
};

std::vector<Named> profiles() {
  return {{"exponential", ExponentialProfile{8000}},
          {"thin exponential", ExponentialProfile{500}},
          {"tent", TentProfile{25'000, 15'000}},
          {"tent cut by the ground", TentProfile{1000, 5000}},
          {"layers", LayersProfile{{{0, 1000, 0.5}, {1000, 1500, 2}, {3000, 9000, 1}}}},
          {"linear table", TableProfile{{500, 2000, 2500, 30'000}, {1, 3, 0, 2}, false}},
          {"logarithmic table", TableProfile{{0, 2000, 10'000, 20'000}, {1, 0.3, 1e-6, 0}, true}},
          {"flat table", TableProfile{{0, 2000}, {0.7, 0.7}, true}},
          {"standard atmosphere", StandardAtmosphereProfile{}}};
}

/// Mean by the midpoint rule on `cells` cells of each kink-free piece: an error that falls with the square of their
/// size.
double brute_force_mean(const Profile& profile, double from, double to, int cells) {
  std::vector<double> ends = kinks(profile, 1e9);
  ends.push_back(0);
  std::erase_if(ends, [&](double end) { return end <= from || end >= to; });
  ends.push_back(to);
  std::sort(ends.begin(), ends.end());
  double sum = 0, below = from;
  for (const double end : ends) {
    const double step = (end - below) / cells;
    for (int i = 0; i < cells; ++i) sum += density(profile, below + (i + 0.5) * step) * step;
    below = end;
  }
  return sum / (to - from);
}

TEST(Profile, mean_density_is_the_integral_on_random_intervals) {
  std::mt19937 random(20260621);
  std::uniform_real_distribution<double> altitude(-2000, 130'000), logarithm(0, 4.6);
  for (const auto& [name, profile] : profiles()) {
    for (int trial = 0; trial < 40; ++trial) {
      const double from = altitude(random), to = from + std::pow(10, logarithm(random));
      // The thinnest, 500 m, meets cells of at most 20 m: the midpoint rule errs by (20 / 500)^2 / 24 = 7e-5, and by
      // 1e-9 after Richardson's extrapolation has taken the leading term away.
      const double coarse = brute_force_mean(profile, from, to, 1000), fine = brute_force_mean(profile, from, to, 2000);
      const double expected = fine + (fine - coarse) / 3;
      EXPECT_NEAR(mean_density(profile, from, to), expected, 1e-8 * expected + 1e-300)
          << name << " from " << from << " to " << to;
    }
  }
}

TEST(Profile, mean_density_is_additive_over_any_split) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> altitude(-500, 125'000);
  for (const auto& [name, profile] : profiles()) {
    for (int trial = 0; trial < 200; ++trial) {
      std::array<double, 3> at{altitude(random), altitude(random), altitude(random)};
      std::sort(at.begin(), at.end());
      const double whole = mean_density(profile, at[0], at[2]) * (at[2] - at[0]);
      const double parts =
          mean_density(profile, at[0], at[1]) * (at[1] - at[0]) + mean_density(profile, at[1], at[2]) * (at[2] - at[1]);
      EXPECT_NEAR(parts, whole, 1e-13 * whole + 1e-300) << name << " " << at[0] << " " << at[1] << " " << at[2];
    }
  }
}

TEST(Profile, mean_density_of_a_point_is_the_density) {
  for (const auto& [name, profile] : profiles()) {
    for (const double altitude : {0.0, 1.0, 750.0, 12'345.6, 90'000.0}) {
      const double here = density(profile, altitude);
      EXPECT_EQ(mean_density(profile, altitude, altitude), here) << name;
      EXPECT_NEAR(mean_density(profile, altitude, altitude + 1e-6), here, 1e-7 * here) << name << altitude;
      EXPECT_EQ(mean_density(profile, altitude + 50, altitude), mean_density(profile, altitude, altitude + 50)) << name;
    }
  }
}

TEST(Profile, closed_forms) {
  EXPECT_DOUBLE_EQ(mean_density(ExponentialProfile{8000}, 0, 8000), 1 - std::exp(-1));
  EXPECT_NEAR(mean_density(ExponentialProfile{1200}, 0, 1e6) * 1e6, 1200, 1e-9);
  EXPECT_DOUBLE_EQ(mean_density(TentProfile{25'000, 15'000}, 0, 60'000) * 60'000, 15'000);
  EXPECT_DOUBLE_EQ(mean_density(LayersProfile{{{0, 100, 2}, {200, 300, 4}}}, 0, 300), 2);
  // Logarithmic between d1 and d2: the logarithmic mean (d1 - d2) / ln(d1 / d2).
  EXPECT_DOUBLE_EQ(mean_density(TableProfile{{0, 10}, {1, 0.1}, true}, 0, 10), 0.9 / std::log(10));
  EXPECT_DOUBLE_EQ(mean_density(TableProfile{{0, 10}, {1, 0.1}, false}, 0, 10), 0.55);
}

TEST(Profile, below_the_ground_the_air_of_the_ground_continues) {
  for (const auto& [name, profile] : profiles()) {
    EXPECT_EQ(density(profile, -430), density(profile, 0)) << name;
    EXPECT_DOUBLE_EQ(mean_density(profile, -430, -10), density(profile, 0)) << name;
  }
}

TEST(Profile, edges_of_layers_and_tables) {
  const Profile layers = LayersProfile{{{0, 100, 2}, {100, 300, 4}}};
  EXPECT_EQ(density(layers, 99.9), 2);
  EXPECT_EQ(density(layers, 100), 4);
  EXPECT_EQ(density(layers, 300), 0);
  const Profile table = TableProfile{{100, 300}, {1, 3}, false};
  EXPECT_EQ(density(table, 50), 1) << "first value below";
  EXPECT_EQ(density(table, 200), 2);
  EXPECT_EQ(density(table, 300), 3);
  EXPECT_EQ(density(table, 300.1), 0) << "nothing above";
}

TEST(Profile, kinks_are_increasing_and_inside) {
  EXPECT_EQ(kinks(TentProfile{25'000, 15'000}, 60'000), (std::vector<double>{10'000, 25'000, 40'000}));
  EXPECT_EQ(kinks(TentProfile{1000, 5000}, 60'000), (std::vector<double>{1000, 6000}));
  EXPECT_EQ(kinks(TentProfile{25'000, 15'000}, 30'000), (std::vector<double>{10'000, 25'000}));
  EXPECT_EQ(kinks(LayersProfile{{{0, 100, 2}, {100, 300, 4}}}, 1000), (std::vector<double>{100, 300}));
  EXPECT_TRUE(kinks(ExponentialProfile{8000}, 60'000).empty());
  const auto standard = kinks(StandardAtmosphereProfile{}, 200'000);
  EXPECT_TRUE(std::is_sorted(standard.begin(), standard.end()));
  EXPECT_EQ(standard.back(), 120'000) << "where the air ends";
}

// Where no kink is told, the density is smooth: its second difference falls with the square of the step.
TEST(Profile, no_kink_goes_untold) {
  for (const auto& [name, profile] : profiles()) {
    const auto told = kinks(profile, 130'000);
    for (double altitude = 37; altitude < 130'000; altitude += 113) {
      const auto near_kink = [&](double kink) { return std::abs(kink - altitude) < 0.3; };
      if (std::any_of(told.begin(), told.end(), near_kink)) continue;
      const double here = density(profile, altitude);
      const double bend = density(profile, altitude - 0.25) - 2 * here + density(profile, altitude + 0.25);
      // exp(-h / 500 m), the most curved of the list, bends by (0.25 / 500)^2 = 2.5e-7 of itself.
      EXPECT_LE(std::abs(bend), 3e-7 * here) << name << " at " << altitude;
    }
  }
}

}  // namespace
}  // namespace airlight
