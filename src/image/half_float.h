// Half floats (IEEE 754 binary16) from floats, in a form that compilers turn into SIMD on every processor.
#pragma once
#include <bit>
#include <cstdint>

namespace airlight {

inline constexpr float largest_half = 65504;

/// Nearest half (ties to even) of a finite x with |x| <= largest_half.
///
/// Both ways of rounding are computed and one is chosen, without a branch. Normal halves: move the exponent's bias from
/// 127 to 15 and round 13 bits of fraction away by an addition, whose carry goes into the exponent as it should.
/// Subnormal halves are multiples of 2^-24, which is the last bit of floats in [0.5, 1): adding 0.5 lets the float unit
/// do the rounding.
inline std::uint16_t half_bits(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  const std::uint32_t normal = (magnitude - (112u << 23) + 0x0fffu + ((magnitude >> 13) & 1u)) >> 13;
  const std::uint32_t tiny =
      std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - std::bit_cast<std::uint32_t>(0.5f);
  return std::uint16_t((magnitude < (113u << 23) ? tiny : normal) | (bits >> 16 & 0x8000u));
}

}  // namespace airlight
