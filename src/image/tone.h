// From absolute light to a display: exposure, tone curve, sRGB, dither.
#pragma once
#include <cstdint>
#include <span>

#include "image/picture_file.h"

namespace airlight {

/// The automatic exposure never lifts a picture by more than this [EV, from 1 cd/m^2 -> 1]: a scene of 0.001 cd/m^2 or
/// less, a night without stars, stays dark.
inline constexpr double automatic_exposure_limit = 5;

/// Exposure [EV] that suits a picture of linear sRGB [cd/m^2], `pixels` triples.
///
/// The key of a picture is the mean of its logarithmic luminance, each pixel weighted by the square root of its
/// luminance: the black of space or outside a fisheye has no say, dark ground has little, a sunset's glow has more than
/// the dusk around it. Pixels above 5e5 cd/m^2, the sun's disc, are left out unless there is nothing else. The key is
/// shown as 0.25 (key / (key + 10))^(1/4), so day is light whatever its brightness, and dusk (10 cd/m^2 and less)
/// darkens to the eye as it does outside, by a factor of 1.8 per power of ten.
double automatic_exposure(std::span<const float> rgb);

/// One row of a picture, linear sRGB [cd/m^2], as 8-bit sRGB.
///
/// Rounding is dithered by less than one step, the same for the three channels (greys stay grey) and for every run: a
/// smooth sky spans few of the 256 steps and would show their edges. Black and white stay exact.
/// @param y  which row of the picture; the dither depends on it
void encode_row(std::span<const float> rgb, int y, double exposure_ev, ToneCurve curve, std::span<std::uint8_t> out);

}  // namespace airlight
