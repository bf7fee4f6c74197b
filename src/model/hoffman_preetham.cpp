// Hoffman & Preetham 2002: light lost and gained in air of constant density, in closed form, and a virtual dome for the sky. Single
// scattering of one sunlight for all heights; docs/models/hoffman_preetham.md says what that gets wrong.
#include "model/hoffman_preetham.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numbers>

#include "airlight/error.h"
#include "model/field_parameter.h"
#include "model/virtual_dome.h"

namespace airlight {
namespace hoffman_preetham {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;

const Numbers air_of_earth{6.95265e-6, 1.17572e-5, 2.43797e-5};  // 8 pi^3 (n^2 - 1)^2 / ..., as beta_rayleigh has it

ParameterInfo field(std::string_view name, Numbers value) {
  return field_parameter("HoffmanPreetham", name, std::move(value));
}
ParameterInfo word(std::string_view name, std::string_view text, std::vector<std::string_view> words) {
  ParameterInfo key{.name = name, .kind = Kind::word, .text = text, .words = std::move(words)};
  key.otherwise = std::string(key.words.front());
  return key;
}
ParameterInfo flag(std::string_view name, std::string_view text) {
  return {.name = name, .kind = Kind::flag, .text = text, .low = 0, .high = 1, .otherwise = Numbers{0}};
}

constexpr std::string_view shown[] = {"all", "L0", "F_ex", "L0_F_ex", "L_in", "fog", "wireframe"};

// The search for another planet's surface takes milliseconds, and a frame asks again and again.
DomeFit dome(double height, double radius) {
  static std::mutex mutex;
  static std::map<std::pair<double, double>, DomeFit> known;
  const std::lock_guard lock(mutex);
  if (known.size() > 1000) known.clear();
  const auto found = known.find({height, radius});
  if (found != known.end()) return found->second;
  return known[{height, radius}] = fit_dome({.height = height, .radius = radius});
}

// The textures know one length for both species, and no diagnostic views.
const std::string& checked_renderer(const Values& values) {
  const std::string& renderer = values.word("renderer");
  for (const auto& [key, value] : {std::pair{"dome", "single"}, {"show", "all"}}) {
    if (renderer == "texture" && values.word(key) != value)
      throw InputError("hoffman_preetham.renderer = \"texture\": expected vertex or pixel where " + std::string(key) +
                       " = \"" + values.word(key) + '"');
  }
  return renderer;
}

}  // namespace

const std::vector<ParameterInfo>& parameters() {
  static const std::vector<ParameterInfo> keys{
      word("preset", "air, light and exposure that belong together; what is given beside it goes before",
           {"clear", "overcast", "sunset", "mars"}),
      field("beta_rayleigh", air_of_earth),
      field("beta_mie", {2e-6}),
      field("beta_absorption", {0}),
      field("g", {-0.75}),
      word("mode", "Henyey and Greenstein's numerator: 1 - g^2, or (1 - g)^2 as it is printed",
           {"normalized", "printed"}),
      field("solar_irradiance", {1}),
      word("sunlight", "at the ground: by the clear-sky attenuation, or through the dome", {"accurate", "dome"}),
      field("turbidity", {2}),
      flag("ozone", "0.35 cm of ozone in the clear-sky attenuation"),
      word("dome", "one dome for all, or one for aerosols of their own height", {"single", "per_species"}),
      field("rayleigh_height", {8000}),
      field("mie_height", {1200}),
      {.name = "planet_radius",
       .unit = "m",
       .text = "that the domes are fitted for",
       .low = 2e6,
       .high = 1e8,
       .otherwise = Numbers{6.360e6}},
      field("inscatter_scale", {1}),
      field("extinction_scale", {1}),
      word("renderer", "of the sky: at the dome's corners, from textures, or at each pixel",
           {"vertex", "texture", "pixel"}),
      {.name = "dome_columns",
       .kind = Kind::whole,
       .text = "of the dome's mesh",
       .low = 8,
       .high = 256,
       .otherwise = Numbers{64}},
      {.name = "dome_rings",
       .kind = Kind::whole,
       .text = "of corners, from the zenith to the horizon",
       .low = 9,
       .high = 129,
       .otherwise = Numbers{33}},
      word("show", "all, a term of L = L0 F_ex + L_in, fog in its place, or the dome's mesh as wires",
           {std::begin(shown), std::end(shown)}),
      field("fog_colour", {0.03}),
      field("fog_density", {5e-5}),
      flag("clamp8bit", "both terms as 8-bit colours"),
      field("exposure", {20}),
      field("ambient", {0})};
  return keys;
}

const std::vector<Preset>& presets() {
  const auto scaled = [](double factor) {
    Numbers beta = air_of_earth;
    for (double& b : beta) b *= factor;
    return beta;
  };
  // The slides give no numbers: these are the specification's.
  static const std::vector<Preset> list{
      {"clear", "much Rayleigh, little Mie, a high sun", {}, 60},
      {"overcast",
       "little Rayleigh, much Mie, a high sun: grey",
       {{"beta_rayleigh", scaled(0.2)}, {"beta_mie", Numbers{2e-4}}, {"g", Numbers{-0.3}}, {"sunlight", "dome"}},
       60},
      {"sunset",
       "a low sun, strong yellow forward scattering",
       {{"beta_mie", Numbers{4e-6}}, {"g", Numbers{-0.85}}, {"exposure", Numbers{60}}},
       6},
      {"mars",
       "a pinkish sky from other coefficients",
       {{"beta_rayleigh", Numbers{2.0e-5, 1.35e-5, 5.75e-6}},
        {"beta_mie", Numbers{1e-5}},
        {"g", Numbers{-0.7}},
        {"sunlight", "dome"},
        {"exposure", Numbers{12}}},
       30}};
  return list;
}

Fields kernel_fields(const Values& values) {
  Fields fields = struct_fields("HoffmanPreetham", values);
  const auto is = [&](std::string_view name, std::string_view other) {
    return Numbers{values.word(name) == other ? 1.0 : 0.0};
  };
  fields["printed"] = is("mode", "printed");
  fields["dome_sunlight"] = is("sunlight", "dome");
  fields["per_species"] = is("dome", "per_species");
  const auto view = std::ranges::find(shown, values.word("show")) - std::begin(shown);
  fields["show"] = {*(std::begin(shown) + view) == "wireframe" ? 0.0 : double(view)};
  const double radius = values.number("planet_radius");
  const DomeFit rayleigh = dome(values.number("rayleigh_height"), radius);
  const DomeFit mie = dome(values.number("mie_height"), radius);
  fields["rayleigh_a"] = {rayleigh.a};
  fields["rayleigh_b"] = {rayleigh.b};
  fields["rayleigh_c"] = {rayleigh.c};
  fields["mie_a"] = {mie.a};
  fields["mie_b"] = {mie.b};
  fields["mie_c"] = {mie.c};
  return fields;
}

}  // namespace hoffman_preetham

Model hoffman_preetham_model() {
  using namespace hoffman_preetham;
  return {
      .name = "hoffman_preetham",
      .summary = "Hoffman & Preetham 2002: closed-form haze and a virtual dome, at 650, 570 and 475 nm",
      .air = {},
      .tables = {{"hoffman_preetham.sunlight", {1, 1, 1}},
                 {"hoffman_preetham.extinction_texture", {256, 1, 1}},
                 {"hoffman_preetham.inscatter_texture", {256, 128, 1}},
                 {"hoffman_preetham.corners",
                  {},
                  [](const Situation& s) -> Shape {
                    return {int(s.parameters->number("dome_columns")) + 1, int(s.parameters->number("dome_rings")), 1};
                  }}},
      .rays = "hoffman_preetham.rays",
      .sky_light = "hoffman_preetham.sky_light",
      .picture = [](const Situation& s) -> std::string_view {
        const std::string& renderer = checked_renderer(*s.parameters);
        if (s.parameters->word("show") == "wireframe") return "hoffman_preetham.wire_picture";
        return renderer == "vertex"    ? "hoffman_preetham.vertex_picture"
               : renderer == "texture" ? "hoffman_preetham.texture_picture"
                                       : "hoffman_preetham.picture";
      },
      .haze = [](const Situation& s) -> std::string_view {
        const std::string& renderer = checked_renderer(*s.parameters);
        if (s.parameters->word("show") == "wireframe")
          throw InputError("hoffman_preetham.show = \"wireframe\": expected a picture of the sky alone, without land");
        return renderer == "vertex"    ? "hoffman_preetham.vertex_haze"
               : renderer == "texture" ? "hoffman_preetham.texture_haze"
                                       : "hoffman_preetham.haze";
      },
      .fields = [](std::string_view argument, const Situation& s) -> Fields {
        if (argument == "mesh")
          return {{"columns", s.parameters->numbers("dome_columns")}, {"rings", s.parameters->numbers("dome_rings")}};
        if (argument == "air") return unit_air();
        return argument == "hoffman_preetham" ? kernel_fields(*s.parameters) : Fields{};
      },
      .sun = "hoffman_preetham.sun_irradiance",
      .surface = "hoffman_preetham.surface",
      .haze_at_corners = [](const Values& parameters) { return parameters.word("renderer") == "vertex"; },
      // A unit is the sunlight outside the air, whose illuminance is 1.33e5 lx by data/solar_irradiance.csv.
      .colours = ColourModel{.wavelengths = {650, 570, 475},
                             .luminance = 1.33e5,
                             .tone = "clip",
                             .sun_radius = 0.2665 * std::numbers::pi / 180},
      .parameters = parameters(),
      .presets = presets()};
}

}  // namespace airlight
