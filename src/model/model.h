// A model: a list of passes, and what each is for. Models know no engine; what a pass reads is bound by the names of its
// arguments (docs/architecture.md).
#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/engine.h"
#include "optics/bake.h"

namespace airlight {

/// Values of a parameter struct's fields, by name.
using Fields = std::map<std::string, std::vector<double>, std::less<>>;

/// Who looks, for a model's own parameter structs.
struct Situation {
  double ground_radius;  ///< [m], of the datum that the kernels take as 0
  double top_altitude;   ///< [m] above it
  double altitude;       ///< [m] above it
};

struct TablePass {
  std::string_view pass;
  Shape shape;
};

struct Model {
  std::string_view name;
  std::string_view summary;
  BakeOptions air;
  std::vector<TablePass> tables;  ///< every table that its passes may name, besides the baked air
  std::string_view rays;          ///< answers radiance, transmittance, ground radiance for rays
  std::string_view sky_light;  ///< light from 256 directions (u) for observers (v): what sky irradiance is summed from
  std::function<std::string_view(const Situation&)> picture;  ///< the pass that draws a picture, for an observer
  std::function<std::string_view(const Situation&)>
      haze;  ///< the pass for points in view, with shadows; empty: `rays`, without
  std::function<Fields(std::string_view argument, const Situation&)> fields;  ///< the model's own parameter structs
};

std::span<const Model> all_models();
/// @throws InputError with "did you mean".
const Model& find_model(std::string_view name);

Model single_model();
Model skyview_model();

}  // namespace airlight
