#include "validate/figure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace airlight::validation {
namespace {

TEST(Figure, percentiles_are_values_that_so_many_are_not_above) {
  std::vector<Deviation> deviations;
  for (int i = 100; i >= 1; --i)
    deviations.push_back({i % 2 ? 0.01 * i : -0.01 * i, 0.01 * i, "ray " + std::to_string(i)});
  const Figure figure = figure_of(deviations);
  EXPECT_EQ(figure.count, 100u);
  EXPECT_DOUBLE_EQ(figure.median, 0.50);
  EXPECT_DOUBLE_EQ(figure.p90, 0.90);
  EXPECT_DOUBLE_EQ(figure.p99, 0.99);
  EXPECT_DOUBLE_EQ(figure.worst, 1);
  EXPECT_EQ(figure.where, "ray 100");
  // Odd ones count up, even ones down: (1 - 2 + 3 - ... - 100) / 100 hundredths.
  EXPECT_NEAR(figure.bias, -0.005, 1e-12);
}

TEST(Figure, no_number_is_worse_than_any) {
  const Figure figure = figure_of({{0.5, 0.5, "a"}, {NAN, NAN, "b"}, {0.1, 0.1, "c"}});
  EXPECT_TRUE(std::isinf(figure.worst));
  EXPECT_EQ(figure.where, "b");
  EXPECT_DOUBLE_EQ(figure.median, 0.5);
}

TEST(Figure, of_nothing_is_nothing) {
  EXPECT_EQ(figure_of({}).count, 0u);
  EXPECT_EQ(percentile({}, 0.5), 0);
}

}  // namespace
}  // namespace airlight::validation
