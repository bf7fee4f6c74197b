// A model: a list of passes, and what each is for. Models know no engine; what a pass reads is bound by the names of its
// arguments (docs/architecture.md).
#pragma once
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/engine.h"
#include "airlight/model_info.h"
#include "model/parameters.h"
#include "optics/bake.h"

namespace airlight {

/// Values of a parameter struct's fields, by name.
using Fields = std::map<std::string, std::vector<double>, std::less<>>;

/// Who looks, for a model's own parameter structs.
struct Situation {
  double ground_radius;                ///< [m], of the datum that the kernels take as 0
  double top_altitude;                 ///< [m] above it
  double altitude;                     ///< [m] above it
  const Values* parameters = nullptr;  ///< the model's own, all of them
  int earlier = 0;                     ///< frames before the last of those that a picture gathers
};

struct TablePass {
  std::string_view pass;
  Shape shape;
  std::function<Shape(const Situation&)> sized = {};  ///< where parameters decide the shape
  bool on_disk = false;                               ///< takes long: kept there, too, where the engine keeps any

  Shape shape_for(const Situation& situation) const { return sized ? sized(situation) : shape; }
};

/// RGBA values that the host made; none: there is no such table.
struct HostTable {
  Shape shape;
  std::vector<double> rgba;
};

/// Light of all orders of scattering as passes: `light` that reaches the places of a lattice makes a `source` there and falls on the
/// ground (`ground_light`), and of these two comes the light of the next order. `next_source` makes the source between two orders; what
/// answers is `source` and `ground_light` of the sum.
struct OrderPasses {
  TablePass first_light, next_light, next_source, source, ground_light;
  std::string_view sum;     ///< of `light` and `others`
  std::string_view closed;  ///< `light_sum` with the orders still to come, as `light` and `light_before` let expect
};

/// How a picture is made of frames, each with other random numbers.
struct Gathering {
  int frames = 1;
  double weight = 0;     ///< of each new frame, the rest being what came before; 0: the mean of all, in linear light
  bool encoded = false;  ///< blended as encoded by a square root
};

struct Model {
  std::string_view name;
  std::string_view summary;
  BakeOptions air;
  std::vector<TablePass> tables;        ///< every table that its passes may name, besides the baked air
  std::string_view rays;                ///< answers radiance, transmittance, ground radiance for rays
  std::string_view transmittance = {};  ///< answers it instead, so that `rays` has two answers; empty: there is none
  std::string_view sky_light;  ///< light from 256 directions (u) for observers (v): what sky irradiance is summed from
  std::function<std::string_view(const Situation&)> picture;  ///< the pass that draws a picture, for an observer
  std::function<std::string_view(const Situation&)>
      haze;  ///< the pass for points in view, with shadows; empty: `rays`, without
  std::function<Fields(std::string_view argument, const Situation&)> fields;  ///< the model's own parameter structs
  std::optional<OrderPasses> orders = {};
  double greatest_optical_depth =
      std::numeric_limits<double>::infinity();  ///< vertical; beyond it the model refuses an air

  // ---- published systems ----
  std::string_view sun = "core.sun_irradiance";  ///< answers sunlight for rays; empty: the system does not say
  std::string_view surface = "core.surface";     ///< light that surfaces reflect; empty: the system does not say
  /// Set and true: the air before land is wanted at the corners of its triangles, and interpolated between them.
  std::function<bool(const Values& parameters)> haze_at_corners = {};
  std::function<HostTable(std::string_view argument, const Situation&)> data =
      {};                     ///< tables that no pass makes, of the parameters alone
  bool under_the_sun = true;  ///< false: another world's inside, not to be compared with skies
  bool segments = true;       ///< answers for rays that end in the air
  std::function<Gathering(const Values&)> gathering = {};  ///< empty: a picture is one frame
  std::optional<ColourModel> colours = {};                 ///< answers in red, green and blue, for no given air
  std::function<std::vector<std::string>(const Values&)> warnings = {};  ///< of legal parameters that break a promise
  std::vector<ParameterInfo> parameters = {};  ///< `preset`, a word, takes the values of that preset first
  std::vector<Preset> presets = {};
};

/// A model's parameters, all of them: those given, then those of the preset, then the defaults.
/// @param where  begins the names in messages, "codeflow." or ""
/// @throws InputError naming parameter, value and range
Values model_parameters(const Model& model, const Parameters& given, std::string_view where);

std::span<const Model> all_models();
/// @throws InputError with "did you mean".
const Model& find_model(std::string_view name);

Model codeflow_model();
Model hoffman_preetham_model();
Model jetlag_model();
Model precomputed_model();
Model rama_model();
Model realworldz_model();
Model single_model();
Model skyview_model();

}  // namespace airlight
