// The sky colour table of RealWorldz: painted over the angle from the Sun and the air's transmittance, re-spaced for the shader.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "airlight/parameters.h"

namespace airlight {

/// Linear RGBA, colours multiplied by alpha. Row 0 is thick air, the last row no air; columns begin at the Sun.
struct SkyTable {
  int width = 0, height = 0;
  std::vector<double> rgba;

  double* texel(int column, int row) {
    return &rgba[4 * (std::size_t(row) * std::size_t(width) + std::size_t(column))];
  }
  const double* texel(int column, int row) const { return const_cast<SkyTable*>(this)->texel(column, row); }
};

/// An Earth-like sky: white at the Sun, blue away from it, red where air is thick near the Sun, black without air.
SkyTable realworldz_starter(int width = 256, int height = 256);

/// A painted picture: its rows begin at the top, where there is no air.
SkyTable table_of(const ParameterPicture& picture);
/// And back, its colours as they are.
ParameterPicture picture_of(const SkyTable& painted, std::string name);

/// A rainbow-coloured halo painted onto a table, between two angles from the Sun [degrees].
void paint_halo(SkyTable& table, double inner, double outer, double strength);

/// Column of the painted table, as a part of its width, that a column of the resampled one takes its colours from.
double realworldz_source_x(double column, double width);

/// The table over a quarter of |sun - view|^2 in place of the angle, twice as wide to lose less near the Sun.
SkyTable realworldz_resampled(const SkyTable& painted);

}  // namespace airlight
