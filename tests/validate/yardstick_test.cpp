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

/// A view that grazes 1 km above the ground, seen from 2 km: dip = acos((R + 1 km) / (R + 2 km)).
TEST(LowView, is_told_by_where_the_line_of_sight_goes) {
  constexpr double R = 6360e3, altitude = 2e3, degree = 0.017453292519943295;
  const auto view = [&](double elevation, double distance) {
    const Ray ray{.altitude = altitude, .view = direction(0.5, elevation), .distance = distance};
    return low_view(ray, R);
  };
  const double horizon = -std::acos(R / (R + altitude)), past = -std::acos((R + 1e3) / (R + altitude));
  EXPECT_EQ(view(past, INFINITY), LowView::limb);
  const double there = std::sqrt((R + altitude) * (R + altitude) - (R + 1e3) * (R + 1e3));  // Pythagoras
  EXPECT_EQ(view(past, 1.001 * there), LowView::limb);
  EXPECT_EQ(view(past, 0.999 * there), LowView::none);
  EXPECT_EQ(view(horizon + 1e-4 * degree, INFINITY), LowView::limb);
  EXPECT_EQ(view(horizon - 1e-4 * degree, INFINITY), LowView::ground);
  EXPECT_EQ(view(horizon - 0.999 * degree, 100), LowView::ground);
  EXPECT_EQ(view(horizon - 1.001 * degree, INFINITY), LowView::none);
  EXPECT_EQ(view(-90 * degree, INFINITY), LowView::none);
  EXPECT_EQ(view(0, INFINITY), LowView::none);
  const auto from_above = [&](double lowest) {
    const Ray ray{.altitude = 1e4, .view = direction(2, -std::acos((R + lowest) / (R + 1e4)))};
    return low_view(ray, R);
  };
  EXPECT_EQ(from_above(2990), LowView::limb);
  EXPECT_EQ(from_above(3010), LowView::none);
}

/// Tables of `precomputed` once were wrong there, and nobody saw it.
TEST(Yardstick, looks_low_under_every_sun) {
  const Yardstick yardstick = read_yardstick(folder);
  for (const char* name : {"earth", "earth-hazy"}) {
    const double radius = built_in_atmosphere(name).planet.ground_radius;
    for (const double sun : {60, 10, 2, -2, -6, -12}) {
      const auto count = [&](LowView where) {
        return std::ranges::count_if(yardstick.rays, [&](const YardstickRay& ray) {
          return ray.atmosphere == name && ray.sun_elevation == sun && ray.ray.altitude <= 3000 &&
                 low_view(ray.ray, radius) == where;
        });
      };
      EXPECT_EQ(count(LowView::ground), 4) << name << ", sun " << sun;
      EXPECT_EQ(count(LowView::limb), 3) << name << ", sun " << sun;
    }
  }
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
