// Long work told about while it goes on, and ended by whoever is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "../scratch_folder.h"
#include "airlight/error.h"
#include "airlight/sky.h"

namespace airlight {
namespace {

struct Enough : std::runtime_error {
  Enough() : std::runtime_error("enough") {}
};

class Watch : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      engine_ = make_engine(GetParam());
    } catch (const WorkError& error) {
      GTEST_SKIP() << GetParam() << " is missing: " << error.what();
    }
    engine_->keep_on_disk(folder_ / "tables", {});
  }

  /// OpenGL in software is slow.
  int sets() const { return GetParam() == std::string("gl") ? 1 : 2; }

  /// The zenith at four or eight wavelengths: a set of tables for each four.
  std::vector<double> ask() const {
    const Sky sky(built_in_atmosphere("mars-clear"), "precomputed", engine_, {{"detail", "draft"}});
    const Ray zenith{.sun = direction(0, 0.5)};
    std::vector<double> wavelengths{400, 450, 500, 550, 600, 650, 700, 750};
    wavelengths.resize(std::size_t(4 * sets()));
    std::vector<double> values(wavelengths.size());
    sky.evaluate(Quantity::radiance, {&zenith, 1}, wavelengths, values);
    return values;
  }
  long files() const {
    const std::filesystem::path tables = folder_ / "tables";
    return std::filesystem::exists(tables) ? std::distance(std::filesystem::directory_iterator(tables), {}) : 0;
  }

  std::shared_ptr<Engine> engine_;
  Folder folder_;
};

TEST_P(Watch, is_told_of_rising_parts_up_to_the_whole) {
  std::vector<double> parts;
  engine_->watch([&](double done) { parts.push_back(done); });
  ask();
  ASSERT_GT(parts.size(), 15u) << "sums of several orders, two passes or more each";
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_GE(parts[i], parts[i - 1]);
  EXPECT_EQ(parts.front(), 0);
  EXPECT_EQ(parts.back(), 1);
  EXPECT_LT(parts[parts.size() - 2], 1) << "only the end is the whole";
  if (sets() == 2) {
    EXPECT_LE(*std::ranges::lower_bound(parts, 0.25), 0.5) << "the first tables are half of the work";
  }
}

TEST_P(Watch, ends_the_work_by_throwing_and_nothing_half_made_is_kept) {
  int calls = 0;
  engine_->watch([&](double) {
    if (++calls >= 12) throw Enough();
  });
  EXPECT_THROW(ask(), Enough);
  EXPECT_EQ(calls, 13) << "told once more, that it is over";
  EXPECT_EQ(files(), 0);
  engine_->watch({});
  const std::vector<double> after = ask();
  EXPECT_EQ(files(), 2 * sets()) << "orders, and what is seen along whole rays";
  const auto undisturbed = make_engine(GetParam());
  engine_ = undisturbed;
  EXPECT_EQ(ask(), after);
}

INSTANTIATE_TEST_SUITE_P(engines, Watch, testing::Values("double", "simd", "gl"));

/// Rows are computed in parts while somebody watches: the same numbers, whatever the parts.
TEST(WatchedTables, are_those_of_unwatched_work) {
  const auto ask = [](bool watched, const char* name) {
    const auto engine = make_engine(name);
    if (watched) engine->watch([](double) {});
    const Sky sky(built_in_atmosphere("earth"), "skyview", engine);
    std::vector<double> values(16 * 4);
    std::vector<Ray> rays;
    for (int i = 0; i < 16; ++i)
      rays.push_back({.altitude = 100.0 * i, .view = direction(0.3 * i, 0.1 * i), .sun = direction(0, 0.1)});
    sky.evaluate(Quantity::radiance, rays, sky.realtime_wavelengths(), values);
    return values;
  };
  for (const char* name : {"double", "simd"}) EXPECT_EQ(ask(true, name), ask(false, name)) << name;
}

}  // namespace
}  // namespace airlight
