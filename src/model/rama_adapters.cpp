// The functions that Rama's specification names.
#include <cmath>
#include <numbers>
#include <optional>

#include "model/adapter.h"
#include "model/rama.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;
using std::numbers::pi;

ParameterInfo place_key(std::string_view name) {
  return {.name = name,
          .kind = Kind::vector,
          .unit = "km",
          .text = "x along the spin axis, north positive",
          .low = -50,
          .high = 50};
}
ParameterInfo number_key(std::string_view name, std::string_view unit, double low, double high,
                         std::optional<double> otherwise = {}) {
  ParameterInfo key{.name = name, .unit = unit, .low = low, .high = high};
  if (otherwise) key.otherwise = Numbers{*otherwise};
  return key;
}
ParameterInfo texel_key(std::string_view name, double last) {
  return {.name = name, .kind = Kind::whole, .low = 0, .high = last};
}

Table upload_place(KernelCaller& kernels, const Numbers& p) {
  return kernels.upload({1, 1}, Numbers{p[0], p[1], p[2], 0});
}
Table upload_lights(KernelCaller& kernels, const RamaSettings& settings) {
  return kernels.upload({6, 2}, rama_lights(settings));
}
Numbers colour(Numbers rgba) {
  rgba.resize(3);
  return rgba;
}

Numbers source_at(KernelCaller& kernels, const Numbers& q) {
  return colour(kernels.read(kernels.run("rama.places", {{"rama", rama_fields({})}},
                                         {{"lights", upload_lights(kernels, {})}, {"places", upload_place(kernels, q)}},
                                         {1, 1})[0]));
}

Numbers gathered(KernelCaller& kernels, const Values& in, RamaSettings::Source source) {
  RamaSettings settings;
  settings.source = source;
  const Numbers p = in.numbers("p_km"), d = in.numbers("d_km");
  const Table lights = upload_lights(kernels, settings);
  KernelCaller::Structs rama{{"rama", rama_fields(settings)}};
  // A texel stands for the table where that is not asked.
  const Table table =
      source == RamaSettings::Source::texture
          ? kernels.run("rama.source", {{"air_of_table", rama_fields({})}}, {{"lights", lights}}, rama_texture)[0]
          : kernels.upload({2, 2, 2}, Numbers(32, 0.0));
  return colour(kernels.read(kernels.run("rama.between", rama,
                                         {{"lights", lights},
                                          {"source", table},
                                          {"places", upload_place(kernels, p)},
                                          {"ends", upload_place(kernels, {p[0] + d[0], p[1] + d[1], p[2] + d[2]})}},
                                         {1, 1})[0]));
}

Adapter transmittance(std::string_view name, std::string_view kernel, std::string_view text) {
  return {.name = name,
          .text = text,
          .inputs = {place_key("p_km"), place_key("q_km")},
          .outputs = "red, green, blue",
          .unit = "1",
          .call = [kernel](KernelCaller& kernels, const Values& in) {
            return colour(kernels.call(kernel, {{"p", in.numbers("p_km")}, {"q", in.numbers("q_km")}},
                                       {{"rama", rama_fields({})}}));
          }};
}

}  // namespace

std::vector<Adapter> rama_adapters() {
  std::vector<Adapter> list;
  list.push_back({.name = "rama.kappa_per_km2",
                  .text = "Factor of the squared radii in the density's exponent",
                  .inputs = {},
                  .outputs = "kappa",
                  .unit = "km^-2",
                  .call = [](KernelCaller&, const Values&) { return Numbers{rama_kappa({})}; }});
  list.push_back({.name = "rama.L0_north_south",
                  .text = "Radiance of the northern and of the southern strips",
                  .inputs = {},
                  .outputs = "north, south",
                  .unit = "W m^-2 sr^-1",
                  .call = [](KernelCaller&, const Values&) {
                    const auto radiance = rama_strip_radiance({});
                    return Numbers{radiance[0], radiance[1]};
                  }});
  list.push_back({.name = "rama.density_ratio",
                  .text = "Density of the air relative to that 8 km from the axis",
                  .inputs = {number_key("r_km", "km", 0, 8)},
                  .outputs = "density",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const double r = in.number("r_km");
                    return kernels.call("rama.density", {{"square", {r * r}}}, {{"rama", rama_fields({})}});
                  }});
  list.push_back({.name = "rama.x_warp",
                  .text = "Place along the axis as the texture has it",
                  .inputs = {number_key("x_km", "km", -24.75, 24)},
                  .outputs = "warped",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("rama.x_warp", {{"x", in.numbers("x_km")}});
                  }});
  list.push_back({.name = "rama.texel_world_point",
                  .text = "Place of a texel of the source texture",
                  .inputs = {texel_key("i", 48), texel_key("j", 32), texel_key("k", 32)},
                  .outputs = "x, y, z",
                  .unit = "km",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("rama.texel_point",
                                        {{"i", in.numbers("i")}, {"j", in.numbers("j")}, {"k", in.numbers("k")}});
                  }});
  list.push_back({.name = "rama.texture_coordinate",
                  .text = "Where the source texture keeps a place",
                  .inputs = {place_key("p_km")},
                  .outputs = "u, v, w",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("rama.texture_coordinate", {{"p", in.numbers("p_km")}});
                  }});
  list.push_back(
      transmittance("rama.transmittance", "rama.transmittance", "Transmittance of the air between two places"));
  list.push_back(
      transmittance("rama.transmittance_fast", "rama.transmittance_fast",
                    "Transmittance between two places, the density being a straight line in the squared radius"));
  list.push_back({.name = "rama.solid_angle_line",
                  .text = "Solid angle of a strip of light as a line, nothing before it",
                  // Unless others are named, that of the northern strip at 0 degrees.
                  .inputs = {number_key("light_radius_km", "km", 0.1, 50, 8),
                             number_key("light_angle_deg", "degrees", -360, 360, 0),
                             number_key("x1_km", "km", -50, 50, 5.1), number_key("x2_km", "km", -50, 50, 15.9),
                             number_key("width_km", "km", 0, 10, 0.1), place_key("q_km")},
                  .outputs = "solid angle",
                  .unit = "sr",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const double angle = in.number("light_angle_deg") * pi / 180;
                    return kernels.call("rama.solid_angle", {{"q", in.numbers("q_km")},
                                                             {"radius", in.numbers("light_radius_km")},
                                                             {"c", {std::cos(angle)}},
                                                             {"s", {std::sin(angle)}},
                                                             {"x1", in.numbers("x1_km")},
                                                             {"x2", in.numbers("x2_km")},
                                                             {"width", in.numbers("width_km")}});
                  }});
  list.push_back({.name = "rama.visibility",
                  .text = "1 where nothing stands between a place on a strip and another, 0 where the cliff does",
                  .inputs = {place_key("s_km"), place_key("q_km")},
                  .outputs = "visibility",
                  .unit = "1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return kernels.call("rama.sees", {{"a", in.numbers("s_km")}, {"b", in.numbers("q_km")}});
                  }});
  list.push_back(
      {.name = "rama.J",
       .text = "Light that the air scatters, a kilometre of it, equally to all sides",
       .inputs = {place_key("q_km")},
       .outputs = "red, green, blue",
       .unit = "W m^-2 sr^-1 km^-1",
       .call = [](KernelCaller& kernels, const Values& in) { return source_at(kernels, in.numbers("q_km")); }});
  list.push_back(
      {.name = "rama.scattering_midpoint30",
       .text = "Light that the air adds along p .. p + d, of 30 samples",
       .inputs = {place_key("p_km"),
                  place_key("d_km"),
                  {.name = "source", .kind = Kind::word, .words = {"exact", "texture"}, .otherwise = "texture"}},
       .outputs = "red, green, blue",
       .unit = "W m^-2 sr^-1",
       .call = [](KernelCaller& kernels, const Values& in) {
         return gathered(kernels, in,
                         in.word("source") == "exact" ? RamaSettings::Source::own : RamaSettings::Source::texture);
       }});
  list.push_back({.name = "rama.scattering_exact_rayleigh30",
                  .text = "Light that the air adds along p .. p + d, of 30 samples with Rayleigh's phase",
                  .inputs = {place_key("p_km"), place_key("d_km")},
                  .outputs = "red, green, blue",
                  .unit = "W m^-2 sr^-1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return gathered(kernels, in, RamaSettings::Source::own_rayleigh);
                  }});
  list.push_back({.name = "rama.texel_value",
                  .text = "A texel of the source texture",
                  .inputs = {texel_key("i", 48), texel_key("j", 32), texel_key("k", 32)},
                  .outputs = "red, green, blue",
                  .unit = "W m^-2 sr^-1 km^-1",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    return source_at(kernels, kernels.call("rama.texel_point", {{"i", in.numbers("i")},
                                                                                {"j", in.numbers("j")},
                                                                                {"k", in.numbers("k")}}));
                  }});
  return list;
}

}  // namespace airlight
