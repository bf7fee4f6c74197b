// From spectral radiance at a few wavelengths to the CIE 1931 observer and linear sRGB.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "airlight/atmosphere.h"
#include "optics/response.h"

namespace airlight {

/// Weights [cd m^-2 / (W m^-2 sr^-1 nm^-1)] W x (X, Y, Z) such that the sum of weight times spectral radiance at the wavelengths is
/// the colour, for light that passed this atmosphere.
///
/// Eight and more wavelengths: radiance relative to the sun's spectrum is taken as linear between them. Four: the least-squares fit
/// over a family of spectra that sunlight takes on its ways through this air (direct through 0 to 40 air masses, scattered by
/// each constituent, reflected by the ground), which the absorption bands and the sun's own lines make better than any fixed rule.
std::vector<Xyz> colour_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths);

/// The same for a sensor in place of the eye: its three channels [W m^-2 sr^-1 times the response's unit]. Radiance relative to the sun's
/// spectrum is taken as linear between the wavelengths, however many.
std::vector<Xyz> response_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths,
                                  const Response& response);

/// Linear sRGB (IEC 61966-2-1 primaries, D65) of XYZ.
std::array<double, 3> xyz_to_srgb(const Xyz& xyz);
Xyz srgb_to_xyz(const std::array<double, 3>& rgb);
/// Y of linear sRGB.
inline double luminance(const std::array<double, 3>& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// The four wavelengths [nm] of real time: of all quads on a 10 nm grid the one whose colour differs least from that of 40 wavelengths
/// over skies of clear and hazy air with the sun from 60 degrees down to -9 (root mean square 0.001, worst 0.003 in CIE u'v').
inline constexpr std::array<double, 4> realtime_quad{445, 515, 565, 635};

}  // namespace airlight
