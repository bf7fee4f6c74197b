#pragma once
#include "airlight/atmosphere.h"
#include "model/model.h"
#include "optics/bake.h"
#include "optics/colour.h"

namespace airlight::bench {

/// What must be done for one ray, whatever the arithmetic in between.
struct Work {
  double exps, texels;
};

/// One ray in sunlight that crosses every zone of the air once, as kernels/core/march.glsl gathers its light: at each of two Gauss
/// points a step two texels of extinction and two a phase class of scattering, four of sunlight and an exp of it and of what was
/// passed (four wavelengths each); with multiple scattering four more texels and one more exp.
inline Work ray_work(const Atmosphere& atmosphere, const Model& model, bool multiple) {
  const BakedAir air = bake(atmosphere, realtime_quad, 0, model.air);
  const double points = 2 * air.zones.shape.width * air.numbers.at("substeps")[0],
               classes = air.numbers.at("classes")[0];
  return {points * (multiple ? 12 : 8), points * (2 + 2 * classes + 4 + (multiple ? 4 : 0))};
}

}  // namespace airlight::bench
