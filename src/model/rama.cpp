// E. Bruneton's Rama: air inside a spinning cylinder lit by six strips. Lights do not move, so the light scattered at every place is
// kept in a table, as if scattered equally to all sides; docs/models/rama.md says what that gets wrong.
#include "model/rama.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;
using std::numbers::pi;

constexpr double north_radius = 8, south_radius = 7.5, strip_width = 0.1;   // [km]
constexpr double north_ends[] = {5.1, 15.9}, south_ends[] = {-16.4, -5.1};  // [km]

}  // namespace

double rama_kappa(const RamaSettings& s) {
  constexpr double molar_mass = 0.0289644, gas_constant = 8.314462618;  // [kg/mol], [J/(mol K)]
  return molar_mass * s.spin * s.spin / (2 * gas_constant * s.temperature) * 1e6;
}

std::array<double, 2> rama_strip_radiance(const RamaSettings& s) {
  // A strip of width w and length l radiates pi L w l; the southern ones shine on a narrower plain.
  const double north_length = 1e3 * (north_ends[1] - north_ends[0]),
               south_length = 1e3 * (south_ends[1] - south_ends[0]);
  const double share = south_radius / north_radius;
  const double north = s.power / (3 * 1e3 * strip_width * pi * (north_length + south_length * share));
  return {north, north * share};
}

std::array<double, 2> rama_density_line(double kappa) {
  const double k = north_radius * north_radius * kappa;
  if (k < 1e-6) return {1 - k, k};
  const double b = -std::expm1(-k), touch = 1 + std::log(b / k) / k;
  return {(std::exp(-k) + std::exp(-k * (1 - touch)) - b * touch) / 2, b};
}

Fields rama_fields(const RamaSettings& s) {
  const double kappa = rama_kappa(s);
  const auto [a, b] = rama_density_line(kappa);
  return {{"scattering", {s.scattering[0], s.scattering[1], s.scattering[2], 0}},
          {"albedo", {s.albedo, 0, 0, 0}},
          {"kappa", {kappa}},
          {"line_start", {a}},
          {"line_rise", {b}},
          {"fast", {s.fast ? 1.0 : 0.0}},
          {"samples", {double(s.samples)}},
          {"exact", {double(s.source)}},
          {"air", {s.air ? 1.0 : 0.0}}};
}

std::vector<double> rama_lights(const RamaSettings& s) {
  const auto radiance = rama_strip_radiance(s);
  std::vector<double> texels(2 * 6 * 4);
  for (std::size_t l = 0; l < 6; ++l) {
    const bool north = l < 3;
    const double angle = 2 * pi / 3 * (double(l % 3) - 1);
    const bool on = s.single_light == 0 || s.single_light == int(l) + 1;
    const double* const ends = north ? north_ends : south_ends;
    const double rows[2][4] = {
        {north ? north_radius : south_radius, std::cos(angle), std::sin(angle), on ? radiance[north ? 0 : 1] : 0},
        {ends[0], ends[1], strip_width, 0}};
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t c = 0; c < 4; ++c) texels[4 * (6 * row + l) + c] = rows[row][c];
  }
  return texels;
}

// ---- the model ----

namespace {

const std::vector<ParameterInfo>& parameters() {
  static const RamaSettings known;
  static const std::vector<ParameterInfo> keys{
      {.name = "omega", .unit = "rad/s", .text = "spin", .low = 0, .high = 0.06, .otherwise = Numbers{known.spin}},
      {.name = "temperature",
       .unit = "K",
       .text = "of the air",
       .low = 200,
       .high = 350,
       .otherwise = Numbers{known.temperature}},
      {.name = "beta",
       .kind = Kind::colour,
       .unit = "1/km",
       .text = "scattering 8 km from the axis, at 680, 550 and 440 nm",
       .low = 0,
       .high = 0.4,
       .otherwise = Numbers(known.scattering.begin(), known.scattering.end())},
      {.name = "power",
       .unit = "W",
       .text = "of all strips of light",
       .low = 0,
       .high = 1e15,
       .otherwise = Numbers{known.power}},
      {.name = "albedo", .text = "mean of the ground", .low = 0, .high = 1, .otherwise = Numbers{known.albedo}},
      {.name = "samples", .kind = Kind::whole, .text = "along a ray", .low = 4, .high = 128, .otherwise = Numbers{30}},
      {.name = "source",
       .kind = Kind::word,
       .text = "light of a sample: from the table; its own; its own with Rayleigh's phase",
       .words = {"texture", "own", "own_rayleigh"},
       .otherwise = "texture"},
      {.name = "transmittance",
       .kind = Kind::word,
       .text = "along rays: the density a straight line in the squared radius, or as it is",
       .words = {"fast", "reference"},
       .otherwise = "fast"},
      {.name = "air", .kind = Kind::flag, .low = 0, .high = 1, .otherwise = Numbers{1}},
      {.name = "light",
       .kind = Kind::whole,
       .text = "one strip alone: 1 to 3 in the north, 4 to 6 in the south; 0: all",
       .low = 0,
       .high = 6,
       .otherwise = Numbers{0}},
      {.name = "x",
       .unit = "km",
       .text = "place of the eye along the axis, north positive, 0 amid the sea",
       .low = -24,
       .high = 24,
       .otherwise = Numbers{-5.5}},
      {.name = "phi",
       .unit = "degrees",
       .text = "its angle about the axis; strips are at 0 and 120 to both sides",
       .low = -360,
       .high = 360,
       .otherwise = Numbers{60}},
      {.name = "show",
       .kind = Kind::word,
       .text =
           "what a picture shows: the view; or the light that air scatters, J, in the plane through the axis and the "
           "eye, or in the one across it",
       .words = {"picture", "slice_along", "slice_across"},
       .otherwise = "picture"},
      {.name = "exposure", .text = "in pictures", .low = 0, .high = 1000, .otherwise = Numbers{0.1}}};
  return keys;
}

RamaSettings settings_of(const Values& v) {
  RamaSettings s;
  s.spin = v.number("omega");
  s.temperature = v.number("temperature");
  std::ranges::copy(v.numbers("beta"), s.scattering.begin());
  s.power = v.number("power");
  s.albedo = v.number("albedo");
  s.samples = int(v.number("samples"));
  s.fast = v.word("transmittance") == "fast";
  s.air = v.flag("air");
  s.single_light = int(v.number("light"));
  using Source = RamaSettings::Source;
  s.source = v.word("source") == "texture" ? Source::texture
             : v.word("source") == "own"   ? Source::own
                                           : Source::own_rayleigh;
  return s;
}

Fields eye_fields(const Values& v) {
  const double angle = v.number("phi") * pi / 180, x = v.number("x");
  return {{"x", {x}},
          {"c", {std::cos(angle)}},
          {"s", {std::sin(angle)}},
          {"radius", {x < -5 ? south_radius : north_radius}},
          {"show",
           {v.word("show") == "picture"       ? 0.0
            : v.word("show") == "slice_along" ? 1.0
                                              : 2.0}}};
}

}  // namespace

Model rama_model() {
  return {.name = "rama",
          .summary = "E. Bruneton's Rama: inside a spinning cylinder lit by six strips, at 680, 550 and 440 nm",
          .air = {},
          .tables = {{"rama.source", rama_texture}},
          .rays = "rama.rays",
          .sky_light = "",
          .picture = [](const Situation&) -> std::string_view { return "rama.picture"; },
          .haze = [](const Situation&) -> std::string_view { return ""; },
          .fields = [](std::string_view argument, const Situation& s) -> Fields {
            if (argument == "rama") return rama_fields(settings_of(*s.parameters));
            if (argument == "air_of_table") {
              // What rays alone need is left at its default: the table is made anew only for another air or light.
              RamaSettings air = settings_of(*s.parameters);
              const RamaSettings known;
              air.albedo = known.albedo, air.samples = known.samples, air.fast = known.fast, air.air = known.air,
              air.source = known.source;
              return rama_fields(air);
            }
            return argument == "eye" ? eye_fields(*s.parameters) : Fields{};
          },
          .sun = "",
          .surface = "",
          .data = [](std::string_view argument, const Situation& s) -> HostTable {
            if (argument == "lights") return {{6, 2}, rama_lights(settings_of(*s.parameters))};
            return {};
          },
          .under_the_sun = false,
          // 133 W/m^2 are 35000 lx of its white light.
          .colours = ColourModel{.wavelengths = {680, 550, 440}, .luminance = 35000.0 / 133, .tone = "exponential"},
          .parameters = parameters()};
}

}  // namespace airlight
