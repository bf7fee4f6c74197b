// RealWorldz: small planets with strong art direction. Fog and sky are made to look right, without scattering;
// docs/models/realworldz.md says what that gets wrong.
#include "model/realworldz.h"

#include <cmath>

#include "airlight/error.h"
#include "model/realworldz_stars.h"
#include "model/realworldz_table.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;
using std::numbers::pi;

}  // namespace

Fields realworldz_fields(const RealworldzSettings& s) {
  const auto colour = [](const std::array<double, 3>& c) { return Numbers{c[0], c[1], c[2], 0}; };
  return {{"far_transmittance", colour(s.far_transmittance)},
          {"far_light", colour(s.far_light)},
          {"sun_light", colour(s.sun_light)},
          {"bounding_radius", {s.bounding_radius}},
          {"outer_radius", {s.outer_radius}},
          {"inner_radius", {s.inner_radius}},
          {"clear", {s.clear}},
          {"clear_falloff", {1 / (s.clear_width * s.clear_width)}},
          {"auto_clear", {s.auto_clear ? 1.0 : 0.0}},
          {"ground_radius", {s.ground_radius}},
          {"top_radius", {s.top_radius}},
          {"density", {s.density}},
          {"scale_height", {s.scale_height}},
          {"relief", {s.bounding_radius - s.ground_radius}},
          {"painted", {s.painted_density ? 1.0 : 0.0}}};
}

// ---- the model ----

namespace {

ParameterInfo number(std::string_view name, std::string_view unit, double low, double high, double otherwise,
                     std::string_view text) {
  return {.name = name, .unit = unit, .text = text, .low = low, .high = high, .otherwise = Numbers{otherwise}};
}
ParameterInfo colour(std::string_view name, double high, const std::array<double, 3>& otherwise,
                     std::string_view text) {
  return {.name = name,
          .kind = Kind::colour,
          .text = text,
          .low = 0,
          .high = high,
          .otherwise = Numbers(otherwise.begin(), otherwise.end())};
}
ParameterInfo flag(std::string_view name, double otherwise, std::string_view text) {
  return {.name = name, .kind = Kind::flag, .text = text, .low = 0, .high = 1, .otherwise = Numbers{otherwise}};
}

const std::vector<ParameterInfo>& parameters() {
  static const RealworldzSettings known;
  static const std::vector<ParameterInfo> keys{
      {.name = "preset",
       .kind = Kind::word,
       .text = "a planet; what is given beside it goes before",
       .words = {"default", "dragon_ridges", "snow"},
       .otherwise = "default"},
      number("Rg", "m", 1e3, 1e7, known.ground_radius, "radius of the lowest ground"),
      number("Rb", "m", 1e3, 1e7, known.bounding_radius, "radius of the highest"),
      number("ro", "m", 1e3, 1e7, known.outer_radius, "radius of the shell without fog"),
      number("ri", "m", 1, 1e7, known.inner_radius, "radius of the shell of full fog"),
      number("c", "1", 0, 2, known.clear, "strength of the clear zone around the viewer"),
      number("clear_width", "m", 1, 1e7, known.clear_width, "of that zone: the inverse root of d"),
      flag("autoC", 0, "that strength is the fog's at the viewer: none there"),
      colour("Tfar", 1, known.far_transmittance, "colour multiplier at full fog"),
      colour("Sfar", 1e3, known.far_light, "air light at full fog"),
      colour("sun_light", 1e3, known.sun_light, "on terrain"),
      number("k", "1/m", 0, 1, known.density, "optical depth of the sky's air per length at the ground"),
      number("H", "m", 1, 1e6, known.scale_height, "its scale height"),
      number("Rtop", "m", 1e3, 1e8, known.top_radius, "radius of its top"),
      {.name = "profile",
       .kind = Kind::picture,
       .text =
           "painted density of the sky's air, relative to k, from Rg at its left edge to Rtop at its right: mean over "
           "the rows of red in linear light; without it, exp(-height / H)",
       .optional = true},
      {.name = "fog",
       .kind = Kind::word,
       .text = "before land computed at its triangles' corners and interpolated, or at each pixel; the system's own "
               "mountains have no corners",
       .words = {"vertex", "pixel"},
       .otherwise = "vertex"},
      {.name = "table",
       .kind = Kind::picture,
       .text = "painted table of the sky's colours: angle from the Sun to the right, up to 180 degrees; exp(-optical "
               "depth) of the air upwards, 0 to 1; without it, one that is generated",
       .optional = true},
      number("halo", "1", 0, 10, 0, "strength of a rainbow halo 8 to 10 degrees from the Sun, painted on the table"),
      flag("terrain", 1, "mountains; 0: a smooth ball"),
      {.name = "terrain_steps",
       .kind = Kind::whole,
       .text = "along a ray",
       .low = 16,
       .high = 512,
       .otherwise = Numbers{192}},
      number("stars", "sr", 0, 1, 3e-5,
             "light of the stars: at 1 a star of magnitude 0 that fills a steradian is white"),
      {.name = "star_size",
       .kind = Kind::whole,
       .text = "texels of the star map's faces",
       .low = 16,
       .high = 1024,
       .otherwise = Numbers{512}},
      number("latitude", "degrees", -90, 90, 30, "place of the viewer, on the planet and under the stars"),
      number("longitude", "degrees", -360, 360, 20, "place of the viewer"),
      {.name = "show",
       .kind = Kind::word,
       .text = "what a picture shows",
       .words = {"picture", "fog"},
       .otherwise = "picture"},
      number("exposure", "1", 0, 1000, 1, "in pictures")};
  return keys;
}

std::vector<Preset> presets() {
  return {{"default", "subtle haze", {}},
          {"dragon_ridges",
           "white sun, blue sky, red sunset",
           {{"Sfar", Numbers{0.42, 0.52, 0.72}},
            {"Tfar", Numbers{0.30, 0.40, 0.58}},
            {"sun_light", Numbers{1.3, 1.25, 1.15}}}},
          {"snow",
           "low dense fog, clear around the viewer, a rainbow halo",
           {{"Rb", Numbers{61e3}},
            {"ro", Numbers{61.2e3}},
            {"ri", Numbers{60.6e3}},
            {"autoC", Numbers{1}},
            {"clear_width", Numbers{600}},
            {"Sfar", Numbers{0.75, 0.80, 0.88}},
            {"Tfar", Numbers{0.20, 0.22, 0.25}},
            {"halo", Numbers{0.35}}}}};
}

RealworldzSettings settings_of(const Values& v) {
  RealworldzSettings s;
  const auto colour = [&v](std::string_view name) {
    return std::array{v.numbers(name)[0], v.numbers(name)[1], v.numbers(name)[2]};
  };
  s.ground_radius = v.number("Rg");
  s.bounding_radius = v.number("Rb");
  s.outer_radius = v.number("ro");
  s.inner_radius = v.number("ri");
  s.clear = v.number("c");
  s.clear_width = v.number("clear_width");
  s.auto_clear = v.flag("autoC");
  s.far_transmittance = colour("Tfar");
  s.far_light = colour("Sfar");
  s.sun_light = colour("sun_light");
  s.density = v.number("k");
  s.scale_height = v.number("H");
  s.top_radius = v.number("Rtop");
  s.painted_density = v.has("profile");
  const auto at_least = [](const char* name, double value, const char* other, double bound) {
    if (!(value >= bound))
      throw InputError("realworldz." + std::string(name) + " = " + number_text(value) + ": expected at least " + other +
                       " = " + number_text(bound) + " m");
  };
  at_least("Rb", s.bounding_radius, "Rg", s.ground_radius);
  at_least("Rtop", s.top_radius, "Rg", s.ground_radius);
  if (!(s.inner_radius < s.outer_radius))
    throw InputError("realworldz.ri = " + number_text(s.inner_radius) +
                     ": expected less than ro = " + number_text(s.outer_radius) + " m");
  return s;
}

std::vector<std::string> warnings(const Values& v) {
  if (v.number("ro") >= v.number("Rb")) return {};
  return {"realworldz.ro = " + number_text(v.number("ro")) + ": less than Rb = " + number_text(v.number("Rb")) +
          " m: fog may fall with distance"};
}

Fields view_fields(const Values& v) {
  const double latitude = v.number("latitude") * pi / 180, longitude = v.number("longitude") * pi / 180;
  const double c = std::cos(latitude), s = std::sin(latitude), x = std::cos(longitude), y = std::sin(longitude);
  return {{"east", {-y, x, 0, 0}},
          {"north", {-s * x, -s * y, c, 0}},
          {"up", {c * x, c * y, s, 0}},
          {"star_gain", v.numbers("stars")},
          {"terrain", v.numbers("terrain")},
          {"steps", v.numbers("terrain_steps")},
          {"show", {v.word("show") == "fog" ? 1.0 : 0.0}}};
}

HostTable sky_colours(const Values& v) {
  // Two degrees of halo are a column or two of the re-spaced table of 256: its colours need more.
  SkyTable painted =
      v.has("table") ? table_of(v.picture("table")) : realworldz_starter(v.number("halo") > 0 ? 1024 : 256);
  if (v.number("halo") > 0) paint_halo(painted, 8, 10, v.number("halo"));
  SkyTable table = realworldz_resampled(painted);
  return {{table.width, table.height}, std::move(table.rgba)};
}

/// One row; two texels that nobody reads where air is exponential.
HostTable densities(const Values& v) {
  if (!v.has("profile")) return {{2, 1}, Numbers(8)};
  const ParameterPicture& painted = v.picture("profile");
  const std::size_t width = std::size_t(painted.width);
  Numbers rgba(4 * width);
  for (std::size_t i = 0; i < painted.rgba.size(); i += 4)
    rgba[i % (4 * width)] += double(painted.rgba[i]) / painted.height;
  return {{painted.width, 1}, std::move(rgba)};
}

}  // namespace

Model realworldz_model() {
  return {.name = "realworldz",
          .summary =
              "RealWorldz: small planets from the ground to orbit, fog of two shells, a painted sky over real stars; "
              "relative colours",
          .air = {},
          .tables = {{"realworldz.rings", {65, 1}}},
          .rays = "realworldz.rays",
          .sky_light = "",
          .picture = [](const Situation&) -> std::string_view { return "realworldz.picture"; },
          .haze = [](const Situation&) -> std::string_view { return ""; },
          .fields = [](std::string_view argument, const Situation& s) -> Fields {
            if (argument == "rw") return realworldz_fields(settings_of(*s.parameters));
            return argument == "view" ? view_fields(*s.parameters) : Fields{};
          },
          .sun = "",
          .surface = "realworldz.surface",
          .haze_at_corners = [](const Values& v) { return v.word("fog") == "vertex"; },
          .data = [](std::string_view argument, const Situation& s) -> HostTable {
            if (argument == "sky_colours") return sky_colours(*s.parameters);
            if (argument == "densities") return densities(*s.parameters);
            if (argument != "stars") return {};
            StarMap map = star_map(int(s.parameters->number("star_size")));
            return {map.shape, std::move(map.rgba)};
          },
          // Its display shows 1 as white; a day's sky is 1e3 .. 1e4 cd/m^2.
          .colours = ColourModel{.wavelengths = {}, .luminance = 1e4, .tone = "clip"},
          .warnings = warnings,
          .parameters = parameters(),
          .presets = presets()};
}

}  // namespace airlight
