#include "validate/yardstick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "airlight/error.h"

namespace airlight::validation {
namespace {

const char* const folder = AIRLIGHT_DATA "/yardstick";

TEST(Yardstick, is_read_as_it_is_written) {
  const Yardstick yardstick = read_yardstick(folder);
  ASSERT_GE(yardstick.rays.size(), 110u);
  EXPECT_EQ(yardstick.wavelengths.size(), 8u);
  const auto found = std::ranges::find(yardstick.rays, "3", &YardstickRay::id);
  ASSERT_NE(found, yardstick.rays.end());
  EXPECT_EQ(found->quantity, Quantity::path_radiance);
  EXPECT_EQ(found->ray.distance, 100);
  EXPECT_NEAR(found->ray.view[2], std::cos(31.67 * 0.017453292519943295), 1e-12);
  EXPECT_NEAR(found->sun_elevation, 60, 1e-12);
}

TEST(Yardstick, holds_skylight_on_level_ground) {
  const Yardstick yardstick = read_yardstick(folder);
  ASSERT_EQ(yardstick.rays.size(), yardstick.solved + yardstick.irradiances);
  ASSERT_GT(yardstick.irradiances, 0u);
  for (std::size_t i = yardstick.solved; i < yardstick.rays.size(); ++i) {
    const YardstickRay& sky = yardstick.rays[i];
    EXPECT_EQ(sky.quantity, Quantity::sky_irradiance) << sky.id;
    EXPECT_GT(sky.value[3], 0) << sky.id;
  }
}

TEST(Yardstick, can_be_had_in_part) {
  const Yardstick whole = read_yardstick(folder), part = read_yardstick(folder, 50), few = at_wavelengths(part, {1, 6});
  ASSERT_EQ(part.solved, 50u);
  EXPECT_EQ(part.rays.size(), 50 + part.irradiances) << "skylight is there as a whole";
  EXPECT_EQ(part.rays[49].id, whole.rays[49].id);
  EXPECT_EQ(few.wavelengths, (std::vector{whole.wavelengths[1], whole.wavelengths[6]}));
  EXPECT_EQ(few.rays[7].value, (std::vector{whole.rays[7].value[1], whole.rays[7].value[6]}));
}

TEST(Yardstick, a_file_that_is_missing_is_named) {
  try {
    read_yardstick("no/such/folder");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/folder/rays.jsonl"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace airlight::validation
