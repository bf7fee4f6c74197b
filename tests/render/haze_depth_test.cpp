// Every convention of depth leads back to the distance it was made from.
#include "render/haze_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace airlight {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

/// d of OpenGL's projection matrix with depth range 0 .. 1: -z is multiplied and divided as the matrix does.
double z_buffer(double z, double near, double far) {
  const double clip_z = (far + near) / (far - near) * z - 2 * far * near / (far - near), clip_w = z;
  return 0.5 * clip_z / clip_w + 0.5;
}

TEST(HazeDepth, a_depth_buffer_leads_back_to_z) {
  for (const double z : {0.2, 1.0, 30.0, 4999.0}) {
    DepthMeaning meaning{.kind = DepthKind::buffer, .near = 0.1, .far = 5000, .unit = 1000};
    EXPECT_NEAR(distance(meaning, z_buffer(z, 0.1, 5000), 0.5), 1000 * z / 0.5,
                1e-6 * z * 1000);  // doubles cancel here
    meaning.kind = DepthKind::reversed;
    EXPECT_NEAR(distance(meaning, 1 - z_buffer(z, 0.1, 5000), 1), 1000 * z, 1e-6 * z * 1000);
    meaning.far = infinite;
    EXPECT_NEAR(distance(meaning, 0.1 / z, 1), 1000 * z, 1e-9 * z * 1000);
    meaning.kind = DepthKind::buffer;
    EXPECT_NEAR(distance(meaning, 1 - 0.1 / z, 1), 1000 * z, 1e-6 * z * 1000);
  }
}

TEST(HazeDepth, a_logarithmic_depth_leads_back_to_z) {
  for (const double z : {0.2, 1.0, 30.0, 4999.0}) {
    DepthMeaning meaning{.kind = DepthKind::logarithmic, .near = 0.1, .far = 5000};
    EXPECT_NEAR(distance(meaning, std::log(z / 0.1) / std::log(5000 / 0.1), 0.8), z / 0.8, 1e-9 * z);
    meaning.near = 0;
    meaning.constant = 0.01;
    EXPECT_NEAR(distance(meaning, std::log2(0.01 * z + 1) / std::log2(0.01 * 5000 + 1), 1), z, 1e-9 * z);
  }
}

TEST(HazeDepth, distance_does_not_ask_for_the_axis_and_z_does) {
  EXPECT_EQ(distance({.kind = DepthKind::distance, .far = 1e9, .unit = 0.3048}, 100, 0.5), 30.48);
  EXPECT_EQ(distance({.kind = DepthKind::z, .far = 1e9, .unit = 0.3048}, 100, 0.5), 60.96);
  EXPECT_EQ(distance({.kind = DepthKind::position, .far = 1e9, .unit = 1000, .eye = {1, 2, 3}}, {1, 5, -1}), 5000);
}

TEST(HazeDepth, the_far_end_is_the_sky) {
  for (const DepthKind kind : {DepthKind::z, DepthKind::distance}) {
    EXPECT_EQ(distance({.kind = kind, .far = 1e9}, 1e10, 1), infinite);
    EXPECT_EQ(distance({.kind = kind, .far = 1e9}, infinite, 1), infinite);
    EXPECT_EQ(distance({.kind = kind, .far = 1e9}, 0, 1), 0);
  }
  for (const double far : {5000.0, infinite}) {
    EXPECT_EQ(distance({.kind = DepthKind::buffer, .near = 0.1, .far = far}, 1, 1), infinite);
    EXPECT_EQ(distance({.kind = DepthKind::reversed, .near = 0.1, .far = far}, 0, 1), infinite);
    EXPECT_NEAR(distance({.kind = DepthKind::reversed, .near = 0.1, .far = far}, 1, 1), 0.1, 1e-12);
  }
  EXPECT_EQ(distance({.kind = DepthKind::logarithmic, .near = 0.1, .far = 5000}, 1, 1), infinite);
  const DepthMeaning position{.kind = DepthKind::position, .far = 1e9, .eye = {1, 2, 3}};
  EXPECT_EQ(distance(position, {0, 0, 0}), infinite);
  EXPECT_EQ(distance(position, {infinite, 0, 0}), infinite);
}

TEST(HazeDepth, what_is_no_depth_is_told) {
  for (const DepthKind kind :
       {DepthKind::z, DepthKind::distance, DepthKind::buffer, DepthKind::reversed, DepthKind::logarithmic}) {
    const DepthMeaning meaning{.kind = kind, .near = 0.1, .far = 5000};
    EXPECT_TRUE(std::isnan(distance(meaning, nan, 1)));
    EXPECT_TRUE(std::isnan(distance(meaning, -0.001, 1)));
    EXPECT_TRUE(std::isnan(distance(meaning, -infinite, 1)));
    EXPECT_EQ(std::isnan(distance(meaning, 1.001, 1)), kind > DepthKind::position);
  }
  EXPECT_TRUE(std::isnan(distance({.kind = DepthKind::position}, {1, nan, 1})));
}

}  // namespace
}  // namespace airlight
