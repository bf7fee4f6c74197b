// What the four channels that kernels answer in are as colours.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "airlight/atmosphere.h"

namespace airlight {

/// What a unit of each channel adds to linear sRGB [cd/m^2].
using ChannelColours = std::vector<std::array<double, 3>>;

/// Of radiances [W m^-2 sr^-1 nm^-1] at wavelengths [nm].
ChannelColours srgb_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths);
/// Of red, green and blue, and a fourth that is nothing. @param luminance  [cd/m^2] of a radiance of 1
ChannelColours primaries(double luminance);

}  // namespace airlight
