// A model's tables, read out for programs that have kernels of their own (docs/tables.md).
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/camera.h"
#include "airlight/engine.h"
#include "airlight/parameters.h"
#include "model/model.h"

namespace airlight {

struct ModelTables {
  struct Texels {
    Shape shape;
    std::vector<float> rgba;  ///< u fastest, then v, then w
  };
  std::map<std::string, Texels> tables;  ///< the baked air, and every table that the model's answers are looked up in
  std::map<std::string, Fields>
      structs;  ///< numbers of the kernels' parameter structs: air, observer, and the model's own
};

/// @param parameters  the model's own
/// @param altitude  of the observer whose tables they are [m], 0 to the top of the air
/// @param sun       unit, in the observer's frame
/// @throws InputError for an unknown model, and all that bake() refuses
ModelTables model_tables(const Atmosphere& atmosphere, std::string_view model, const Parameters& parameters,
                         Engine& engine, const std::array<double, 4>& wavelengths, double altitude,
                         const Direction& sun);

}  // namespace airlight
