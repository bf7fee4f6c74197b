// From colours to spectra: what a surface of a given RGB may reflect at any wavelength.
#pragma once
#include <array>
#include <span>

namespace airlight {

/// Weights w such that albedo(wavelength) = w[0] red + w[1] green + w[2] blue: non-negative, smooth and of sum 1, so
/// that an RGB in [0, 1] makes an albedo in [0, 1], and gray a flat one.
std::array<double, 3> lift_weights(double wavelength);

/// @param rgb     linear sRGB reflectance; values outside [0, 1] are clamped
/// @param albedo  one value a wavelength [nm], in [0, 1]
void lift_rgb(const std::array<double, 3>& rgb, std::span<const double> wavelengths, std::span<double> albedo);

}  // namespace airlight
