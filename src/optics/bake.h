// An atmosphere as the kernels see it: tables for four wavelengths, whatever its constituents. See kernels/core/air.glsl.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/engine.h"

namespace airlight {

struct BakeOptions {
  int zones = 24;    ///< at most, unless sharp edges need more
  int substeps = 1;  ///< Gauss steps a zone
  int cells = 1024;  ///< of the density tables, at least
};

struct BakedTable {
  Shape shape;
  std::vector<double> rgba;
};
struct BakedAir {
  std::map<std::string, std::vector<double>, std::less<>> numbers;  ///< the fields of the kernels' struct Air
  BakedTable zones, profile, phases;
};

using Quad = std::array<double, 4>;  ///< wavelengths [nm]

/// Vertical optical depth of the whole air at each of the four wavelengths.
Quad vertical_optical_depth(const BakedAir& air);

/// @param datum  altitude [m] <= 0 that the kernels take as 0: below the ground sphere the air of altitude 0 continues
/// @throws InputError for more than one smooth and three peaked phase functions, or wavelengths outside the data.
BakedAir bake(const Atmosphere& atmosphere, const Quad& wavelengths, double datum, const BakeOptions& options);

}  // namespace airlight
