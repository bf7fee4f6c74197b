// The noise of the Jetlag intro: bytes of a linear congruential generator. Its integers run on the host; kernels get a table.
#pragma once
#include <cstdint>
#include <vector>

namespace airlight {

inline constexpr int jetlag_noise_size = 1024;  ///< texels a side, four bytes each

/// The byte of that number, from 0: row by row; red, green, blue, alpha.
std::uint8_t jetlag_noise_byte(std::uint32_t index);

/// The table: RGBA in 0..1.
std::vector<double> jetlag_noise_texels();

}  // namespace airlight
