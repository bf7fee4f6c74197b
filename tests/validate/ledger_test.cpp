// The ledger's arithmetic, with a model whose errors are made up.
#include "validate/ledger.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "validate/ledger_text.h"

namespace airlight::validation {
namespace {

/// Two rays under one sun, the second a millionth as bright.
Yardstick two_rays() {
  Yardstick yardstick{{440, 520, 560, 670}, {}};
  YardstickRay bright;
  bright.id = "1";
  bright.atmosphere = "earth";
  bright.sun_elevation = 10;
  bright.ray = {.altitude = 0, .view = direction(0, 1), .sun = direction(0, 0.2)};
  bright.value = {0.1, 0.1, 0.1, 0.1};
  bright.standard_error = {0.001, 0.001, 0.001, 0.001};
  YardstickRay dim = bright;
  dim.id = "2";
  for (double& value : dim.value) value *= 1e-6;
  dim.standard_error = {0, 0, 0, 0};
  yardstick.rays = {bright, dim};
  return yardstick;
}

ModelAnswers answers_of(std::vector<double> bright, std::vector<double> dim) {
  return {"single", "earth", false, {{0, std::move(bright), {}}, {1, std::move(dim), {}}}, {}};
}

TEST(Ledger, counts_neither_noise_nor_darkness) {
  const Yardstick yardstick = two_rays();
  Ledger ledger;
  // Off by two standard errors, by three, by thirty; and the dim ray altogether.
  add_rows(ledger, yardstick, answers_of({0.102, 0.103, 0.1, 0.13}, {1, 1, 1, 1}), 1);
  const LedgerRow* all = find_row(ledger, "single", "earth", "radiance", "all");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->rays, 2u);
  EXPECT_EQ(all->figure.count, 4u);
  EXPECT_NEAR(all->figure.worst, 0.3, 1e-12);
  EXPECT_NEAR(all->figure.bias, (0.02 + 0.03 + 0.3) / 4, 1e-12);
  EXPECT_EQ(all->figure.median, 0) << "0, 0, 0.03, 0.3";
  EXPECT_NE(all->figure.where.find("670 nm"), std::string::npos) << all->figure.where;
  EXPECT_FALSE(find_row(ledger, "single", "earth", "radiance", "sun 60"));
}

TEST(Ledger, colour_errors_do_not_know_brightness) {
  const Yardstick yardstick = two_rays();
  Ledger ledger;
  add_rows(ledger, yardstick, answers_of({0.2, 0.2, 0.2, 0.2}, {0, 0, 0, 0}), 1);
  const LedgerRow* row = find_row(ledger, "single", "earth", "radiance", "all");
  ASSERT_TRUE(row);
  EXPECT_NEAR(row->figure.median, 1, 1e-12);
  EXPECT_NEAR(row->colour_p90, 0, 1e-9);
}

TEST(Ledger, unanswered_rays_are_told) {
  Ledger ledger;
  add_rows(ledger, two_rays(), answers_of({0.1, 0.1, 0.1, 0.1}, {}), 1);
  EXPECT_EQ(find_row(ledger, "single", "earth", "radiance", "all")->unanswered, 1u);
}

TEST(Ledger, low_views_have_rows_of_their_own) {
  Yardstick yardstick = two_rays();                    // both look up
  for (const double elevation : {-0.8, -0.5, -0.1}) {  // from 300 m the horizon is 0.56 degrees below level
    YardstickRay low = yardstick.rays[0];
    low.ray.altitude = 300;
    low.ray.view = direction(0, elevation * 0.017453292519943295);
    yardstick.rays.push_back(low);
  }
  ModelAnswers answers = answers_of({0.1, 0.1, 0.1, 0.1}, {});
  for (const auto& [place, value] : std::vector<std::pair<std::size_t, double>>{{2, 0.2}, {3, 0.15}, {4, 0.1}})
    answers.rays.push_back({place, std::vector(4, value), {}});
  Ledger ledger;
  add_rows(ledger, yardstick, answers, 1);
  const LedgerRow* ground = find_row(ledger, "single", "earth", "radiance", "just below the horizon");
  const LedgerRow* limb = find_row(ledger, "single", "earth", "radiance", "past a low limb");
  ASSERT_TRUE(ground && limb);
  EXPECT_EQ(ground->rays, 1u);
  EXPECT_NEAR(ground->figure.median, 1, 1e-12);
  EXPECT_EQ(limb->rays, 2u);
  EXPECT_NEAR(limb->figure.worst, 0.5, 1e-12);
  EXPECT_NEAR(limb->figure.bias, 0.25, 1e-12);
}

TEST(Ledger, what_became_worse_is_named_and_nothing_else) {
  Ledger good, bad;
  add_rows(good, two_rays(), answers_of({0.1, 0.1, 0.1, 0.11}, {0, 0, 0, 0}), 1);
  add_rows(bad, two_rays(), answers_of({0.1, 0.1, 0.1, 0.12}, {0, 0, 0, 0}), 1);
  EXPECT_TRUE(worse_than(good, good).empty());
  EXPECT_TRUE(worse_than(good, bad).empty()) << "better is not worse";
  const auto lines = worse_than(bad, good);
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines[0].find("single, earth, radiance, all"), std::string::npos) << lines[0];
  // Through the file that is kept, too.
  EXPECT_EQ(worse_than(bad, ledger_from(as_json(good))), lines);
}

}  // namespace
}  // namespace airlight::validation
