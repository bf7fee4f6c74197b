// The functions that RealWorldz' specification names.
#include <cmath>
#include <numbers>

#include "model/adapter.h"
#include "model/realworldz.h"
#include "model/realworldz_table.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;
using std::numbers::pi;

ParameterInfo number_key(std::string_view name, std::string_view unit, double low, double high, double otherwise) {
  return {.name = name, .unit = unit, .low = low, .high = high, .otherwise = Numbers{otherwise}};
}
ParameterInfo place_key(std::string_view name) {
  return {.name = name, .kind = Kind::vector, .unit = "m", .low = -1e9, .high = 1e9};
}
ParameterInfo place_key(std::string_view name, Numbers otherwise) {
  ParameterInfo key = place_key(name);
  key.otherwise = std::move(otherwise);
  return key;
}
ParameterInfo colour_key(std::string_view name, double high, double otherwise) {
  return {.name = name, .kind = Kind::colour, .low = 0, .high = high, .otherwise = Numbers{otherwise}};
}
ParameterInfo rgba_key(std::string_view name) {
  return {.name = name, .kind = Kind::vector, .low = 0, .high = 1e6, .size = 4};
}
const ParameterInfo viewer = place_key("viewer", {0, 60e3, 0}), centre = place_key("p", {0, 0, 0}),
                    bounding = number_key("Rb", "m", 1, 1e9, 63e3), outer = number_key("ro", "m", 1, 1e9, 66e3),
                    inner = number_key("ri", "m", 1, 1e9, 58e3);

Numbers from_centre(const Values& in, std::string_view name) {
  Numbers v = in.numbers(name);
  for (std::size_t c = 0; c < 3; ++c) v[c] -= in.numbers("p")[c];
  return v;
}
Numbers with_centre(const Values& in, Numbers v) {
  for (std::size_t c = 0; c < 3; ++c) v[c] += in.numbers("p")[c];
  return v;
}
/// The kernels' struct, with what was given in place of the default planet's.
KernelCaller::Structs planet(const Values& in) {
  RealworldzSettings settings;
  const auto take = [&in](std::string_view name, double& value) {
    if (in.has(name)) value = in.number(name);
  };
  take("Rb", settings.bounding_radius);
  take("ro", settings.outer_radius);
  take("ri", settings.inner_radius);
  take("c", settings.clear);
  take("Rg_m", settings.ground_radius);
  take("Rtop_m", settings.top_radius);
  take("k_per_m", settings.density);
  take("H_m", settings.scale_height);
  Fields fields = realworldz_fields(settings);
  if (in.has("d")) fields["clear_falloff"] = in.numbers("d");
  return {{"rw", fields}};
}

}  // namespace

std::vector<Adapter> realworldz_adapters() {
  std::vector<Adapter> list;
  list.push_back({.name = "realworldz.shell_a_b",
                  .text = "Numbers of the shell function a r^2 + b: 0 on the outer shell, 1 on the inner",
                  .inputs = {outer, inner},
                  .outputs = "a [m^-2], b [1]",
                  .unit = "",
                  .call = [](KernelCaller&, const Values& in) {
                    const double ro = in.number("ro"), ri = in.number("ri"), apart = (ro - ri) * (ro + ri);
                    return Numbers{-1 / apart, ro * ro / apart};
                  }});
  list.push_back({.name = "realworldz.shell_center_q",
                  .text = "Centre of the shells, on the far side of the planet's from the viewer",
                  .inputs = {viewer, centre, bounding, outer, inner},
                  .outputs = "x, y, z",
                  .unit = "m",
                  .call =
                      [](KernelCaller& kernels, const Values& in) {
                        return with_centre(
                            in, kernels.call("realworldz.centre", {{"viewer", from_centre(in, "viewer")}}, planet(in)));
                      },
                  .scale = 6e4});
  list.push_back({.name = "realworldz.fog_F1_F2_Ffinal",
                  .text = "Fog at a place: shell function, what the clear zone takes off, the fog; places outside the "
                          "bounding sphere are "
                          "moved as project_outside_point does",
                  .inputs = {place_key("x"), viewer, centre, bounding, outer, inner, number_key("c", "1", 0, 2, 0.39),
                             number_key("d", "m^-2", 1e-12, 1, 1.5625e-8)},
                  .outputs = "F1, F2, F",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("realworldz.fog_anywhere",
                                        {{"x", from_centre(in, "x")}, {"viewer", from_centre(in, "viewer")}},
                                        planet(in));
                  }});
  list.push_back(
      {.name = "realworldz.project_outside_point",
       .text = "Place at which fog is taken for one outside the bounding sphere",
       .inputs = {place_key("x"), viewer, number_key("eps", "m", 0, 1e9, 630), centre, bounding},
       .outputs = "x, y, z",
       .unit = "m",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             const Numbers x = from_centre(in, "x");
             const double rb = in.number("Rb");
             if (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] <= rb * rb) return in.numbers("x");  // never moved
             return with_centre(
                 in, kernels.call("realworldz.project",
                                  {{"x", x}, {"viewer", from_centre(in, "viewer")}, {"least", in.numbers("eps")}},
                                  planet(in)));
           },
       .scale = 6e4});
  list.push_back({.name = "realworldz.sky_u",
                  .text = "Horizontal coordinate of the colour table at an angle from the Sun; printed: four times too "
                          "large, as the source has it",
                  .inputs = {number_key("angle_deg", "degrees", 0, 180, 0),
                             {.name = "form",
                              .kind = Kind::word,
                              .words = {"corrected", "quarter", "printed", "unscaled"},
                              .otherwise = "corrected"}},
                  .outputs = "u",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const double s = std::sin(in.number("angle_deg") * pi / 360);
                    Numbers u = kernels.call("realworldz.sky_u", {{"one_minus_cos", {2 * s * s}}});
                    const std::string& form = in.word("form");
                    if (form == "printed" || form == "unscaled") u[0] *= 4;
                    return u;
                  }});
  list.push_back(
      {.name = "realworldz.resampled_source_x",
       .text = "Where in the painted table's row a column of the resampled one comes from",
       .inputs = {{.name = "dest_column", .kind = Kind::whole, .low = 0, .high = 1e6},
                  {.name = "dest_width", .kind = Kind::whole, .low = 1, .high = 1e6, .otherwise = Numbers{512}}},
       .outputs = "x",
       .unit = "1",
       .call = [](KernelCaller&, const Values& in) {
         return Numbers{realworldz_source_x(in.number("dest_column"), in.number("dest_width"))};
       }});
  list.push_back(
      {.name = "realworldz.optical_depth_ring",
       .text = "Optical depth of the sky's air on a ring of equal elevation, and exp(-depth)",
       .inputs = {number_key("viewer_height_m", "m", 0, 1e7, 2), number_key("elevation_deg", "degrees", -90, 90, 90),
                  number_key("k_per_m", "1/m", 0, 1, 2e-4), number_key("H_m", "m", 1, 1e6, 1500),
                  number_key("Rg_m", "m", 1e3, 1e8, 60e3), number_key("Rtop_m", "m", 1e3, 1e8, 75e3)},
       .outputs = "depth, exp(-depth)",
       .unit = "1",
       .call = [](KernelCaller& kernels, const Values& in) {
         const Numbers eye{in.number("viewer_height_m"), 0, 0, std::sin(in.number("elevation_deg") * pi / 180)};
         const auto answers = kernels.run(
             "realworldz.depth", planet(in),
             {{"densities", kernels.upload({2, 1}, Numbers(8))}, {"eyes", kernels.upload({1, 1}, eye)}}, {1, 1});
         const double depth = kernels.read(answers[0])[0];
         return Numbers{depth, std::exp(-depth)};
       }});
  list.push_back(
      {.name = "realworldz.sky_fragment",
       .text = "Sky of the colour table over stars, through fog",
       .inputs = {rgba_key("atmos_rgba"), rgba_key("star_rgba"), colour_key("ext", 1, 1), colour_key("ins", 1e6, 0)},
       .outputs = "red, green, blue",
       .unit = "1",
       .call = [](KernelCaller& kernels, const Values& in) {
         Numbers colour = kernels.call("realworldz.fragment", {{"air", in.numbers("atmos_rgba")},
                                                               {"stars", in.numbers("star_rgba")},
                                                               {"extinction", in.numbers("ext")},
                                                               {"inscatter", in.numbers("ins")}});
         colour.resize(3);
         return colour;
       }});
  return list;
}

}  // namespace airlight
