// The sky of codeflow.org: a march through a unit sphere of constant density, tuned by eye. It knows no metres, no wavelengths and no
// planet; what it says is a colour of the sky in a direction. docs/models/codeflow.md says what it gets wrong.
#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "model/adapter.h"
#include "model/field_parameter.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;

// The published program and the article on it differ in these three.
struct Variant {
  double spot_g, spot_max, sun_margin;
};
constexpr Variant article{0.9995, 15, 0.35}, repository{0.995, 25, 0.15};

const std::vector<ParameterInfo>& parameters() {
  static const auto field = [](std::string_view name, double value) {
    return field_parameter("Codeflow", name, Numbers{value});
  };
  static const auto by_variant = [](std::string_view name) {
    ParameterInfo key = field(name, 0);
    key.otherwise.reset();
    key.optional = true;
    return key;
  };
  static const std::vector<ParameterInfo> keys = [] {
    ParameterInfo steps = field("steps", 16);
    steps.kind = Kind::whole;
    return std::vector<ParameterInfo>{
        {.name = "variant",
         .kind = Kind::word,
         .text = "sets spot_g, spot_max and sun_margin where they are not given: 0.9995, 15, 0.35 or 0.995, 25, 0.15",
         .words = {"article", "repository"},
         .otherwise = "article"},
        field_parameter("Codeflow", "kr", Numbers{0.18867780436772762, 0.4978442963618773, 0.6616065586417131}),
        field("intensity", 1.8),
        field("surface_height", 0.99),
        steps,
        field("scatter_strength", 0.028),
        field("rayleigh_strength", 0.239),
        field("mie_strength", 0.0264),
        field("rayleigh_power", 0.81),
        field("mie_power", 0.39),
        field("rayleigh_brightness", 6.4),
        field("mie_brightness", 0.2),
        field("mie_distribution", 0.63),
        field("spot_brightness", 10),
        by_variant("spot_g"),
        by_variant("spot_max"),
        field("eye_margin", 0.15),
        by_variant("sun_margin"),
        {.name = "show",
         .kind = Kind::word,
         .text = "the sky, or one of its parts, as the equations name them",
         .words = {"sky", "cR", "cM", "fR", "fM", "spot", "ee"},
         .otherwise = "sky"},
        {.name = "cube_size",
         .kind = Kind::whole,
         .unit = "pixels",
         .text = "side of a face of the cube map that the sky is drawn into",
         .low = 64,
         .high = 1024,
         .otherwise = Numbers{512}},
        {.name = "exposure", .text = "of pictures that are not linear", .low = 0, .high = 3, .otherwise = Numbers{1}},
    };
  }();
  return keys;
}

const ParameterInfo& show_key() { return *std::ranges::find(parameters(), "show", &ParameterInfo::name); }

Fields kernel_fields(const Values& values) {
  Fields fields = struct_fields("Codeflow", values);
  const Variant& variant = values.word("variant") == "article" ? article : repository;
  fields.try_emplace("spot_g", Numbers{variant.spot_g});
  fields.try_emplace("spot_max", Numbers{variant.spot_max});
  fields.try_emplace("sun_margin", Numbers{variant.sun_margin});
  const auto& parts = show_key().words;
  fields["show"] = {double(std::ranges::find(parts, values.word("show")) - parts.begin())};
  return fields;
}

// ---- the functions that the specification names; its y points up, the kernels' z ----

Numbers z_up(const Numbers& v) { return {v[0], -v[2], v[1]}; }

Numbers unit(const Values& in, std::string_view name) {
  const Numbers& v = in.numbers(name);
  const double n = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(std::abs(n - 1) < 1e-3))
    throw InputError("inputs." + std::string(name) + ": length " + number_text(n) + ": expected a unit vector");
  return z_up({v[0] / n, v[1] / n, v[2] / n});
}

const ParameterInfo position{.name = "position",
                             .kind = Kind::vector,
                             .unit = "1",
                             .text = "inside the unit sphere, y up",
                             .low = -1,
                             .high = 1};
ParameterInfo direction_key(std::string_view name) {
  return {.name = name, .kind = Kind::vector, .text = "unit vector, y up", .low = -1.001, .high = 1.001};
}

}  // namespace

Model codeflow_model() {
  Model model{.name = "codeflow",
              .summary =
                  "the tunable sky of codeflow.org: relative colours from a unit sphere of constant density, kept as a "
                  "cube map",
              .air = {},
              .tables = {{"codeflow.cube",
                          {},
                          [](const Situation& s) -> Shape {
                            const int side = int(s.parameters->number("cube_size")) + 2;  // a border of one texel
                            return {side, 6 * side, 1};
                          }}},
              .rays = "codeflow.rays",
              .sky_light = "",
              .picture = [](const Situation&) -> std::string_view { return "codeflow.picture"; },
              .haze = [](const Situation&) -> std::string_view { return ""; },
              .fields = [](std::string_view argument, const Situation& s) -> Fields {
                return argument == "codeflow" ? kernel_fields(*s.parameters) : Fields{};
              },
              .sun = "",
              .surface = "",
              .segments = false,
              // Its display shows 1 as white; a day's sky is 1e3 .. 1e4 cd/m^2.
              .colours = ColourModel{.wavelengths = {}, .luminance = 1e4, .tone = "codeflow"},
              .parameters = parameters()};
  return model;
}

std::vector<Adapter> codeflow_adapters() {
  std::vector<Adapter> list;
  list.push_back(
      {.name = "codeflow.phase",
       .text = "Phase function with mean 1 over the sphere",
       .inputs = {{.name = "alpha", .text = "cosine of the scattering angle", .low = -1, .high = 1},
                  {.name = "g", .low = -0.9999, .high = 0.9999}},
       .outputs = "phase",
       .unit = "1",
       .call = [](KernelCaller& kernels, const Values& in) {
         return kernels.call("codeflow.lobe", {{"g", in.numbers("g")}, {"one_minus_cos", {1 - in.number("alpha")}}});
       }});
  list.push_back({.name = "codeflow.atmospheric_depth",
                  .text = "Distance from a point in the unit sphere to its surface",
                  .inputs = {position, direction_key("dir")},
                  .outputs = "distance",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("codeflow.depth",
                                        {{"position", z_up(in.numbers("position"))}, {"direction", unit(in, "dir")}});
                  }});
  list.push_back(
      {.name = "codeflow.horizon_extinction",
       .text = "How free of the solid core a direction is",
       .inputs = {position, direction_key("dir"), {.name = "radius", .text = "of the core", .low = 0, .high = 1}},
       .outputs = "part",
       .unit = "1",
       .call = [](KernelCaller& kernels, const Values& in) {
         return kernels.call("codeflow.horizon", {{"position", z_up(in.numbers("position"))},
                                                  {"direction", unit(in, "dir")},
                                                  {"radius", in.numbers("radius")}});
       }});
  list.push_back({.name = "codeflow.absorb",
                  .text = "Light left after a distance in air",
                  .inputs = {{.name = "dist", .low = 0, .high = 1e6},
                             {.name = "color", .kind = Kind::colour, .low = 0, .high = 1e6},
                             {.name = "factor", .text = "strength", .low = 1e-4, .high = 1e3}},
                  .outputs = "red, green, blue",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const Fields air = kernel_fields(check_parameters(parameters(), {}, ""));
                    Numbers light = kernels.call("codeflow.absorb",
                                                 {{"strength", in.numbers("factor")}, {"distance", in.numbers("dist")}},
                                                 {{"codeflow", air}});
                    for (std::size_t c = 0; c < 3; ++c) light[c] *= in.numbers("color")[c];
                    return light;
                  }});
  list.push_back({.name = "codeflow.sky_pixel",
                  .text = "The sky in a direction, before exposure and tone curve",
                  .inputs = {parameters().front(), direction_key("view"), direction_key("sun")},
                  .outputs = "red, green, blue",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const Values values = check_parameters(parameters(), {{"variant", in.word("variant")}}, "");
                    return kernels.call("codeflow.sky", {{"view", unit(in, "view")}, {"sun", unit(in, "sun")}},
                                        {{"codeflow", kernel_fields(values)}});
                  }});
  return list;
}

}  // namespace airlight
