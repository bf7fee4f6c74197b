#include "image/half_float.h"

#include <gtest/gtest.h>

#include <cmath>

namespace airlight {
namespace {

/// The value of a half, from the definition in IEEE 754.
float value(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const float magnitude =
      exponent ? std::ldexp(float(1024 + fraction), exponent - 25) : std::ldexp(float(fraction), -24);
  return bits & 0x8000 ? -magnitude : magnitude;
}

TEST(HalfFloat, every_half_survives) {
  for (std::uint32_t bits = 0; bits <= 0xffff; ++bits) {
    if ((bits & 0x7fff) > 0x7bff) continue;  // infinity and NaN
    ASSERT_EQ(half_bits(value(std::uint16_t(bits))), bits);
  }
}

TEST(HalfFloat, rounds_to_nearest_and_ties_to_even) {
  for (std::uint16_t bits = 0; bits < 0x7bff; ++bits) {
    const std::uint16_t next = std::uint16_t(bits + 1);
    const float middle = 0.5f * (value(bits) + value(next));  // exact: one bit more than a half holds
    ASSERT_EQ(half_bits(middle), bits % 2 == 0 ? bits : next) << middle;
    ASSERT_EQ(half_bits(std::nextafter(middle, 0.0f)), bits) << middle;
    ASSERT_EQ(half_bits(std::nextafter(middle, 1e9f)), next) << middle;
    ASSERT_EQ(half_bits(-middle), half_bits(middle) | 0x8000) << middle;
  }
}

TEST(HalfFloat, largest_half_is_what_the_format_says) { EXPECT_EQ(value(0x7bff), largest_half); }

}  // namespace
}  // namespace airlight
