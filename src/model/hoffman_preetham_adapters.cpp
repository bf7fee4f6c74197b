// The functions that the specification of Hoffman & Preetham's system names.
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "model/adapter.h"
#include "model/hoffman_preetham.h"
#include "model/virtual_dome.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using namespace hoffman_preetham;
using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;
using Structs = KernelCaller::Structs;

constexpr double degree = std::numbers::pi / 180;

// ---- inputs ----

ParameterInfo number(std::string_view name, std::string_view unit, double low, double high) {
  return {.name = name, .unit = unit, .low = low, .high = high};
}
ParameterInfo with_default(ParameterInfo key, ParameterValue value) {
  key.otherwise = std::move(value);
  return key;
}
ParameterInfo colour(std::string_view name, std::string_view unit, double high) {
  return {.name = name, .kind = Kind::colour, .unit = unit, .low = 0, .high = high, .optional = true};
}
ParameterInfo own(std::string_view name, std::string_view text) {
  return {.name = name, .unit = "1", .text = text, .low = -0.999, .high = 0.999, .optional = true};
}
ParameterInfo words(std::string_view name, std::vector<std::string_view> list) {
  return {.name = name, .kind = Kind::word, .words = std::move(list), .optional = true};
}
const ParameterInfo preset = with_default(words("preset", {"clear", "overcast", "sunset", "mars"}), "clear");
const ParameterInfo beta_rayleigh = colour("betaR_per_m", "1/m", 5e-4), beta_mie = colour("betaM_per_m", "1/m", 5e-3);
const ParameterInfo g = own("g", "negative is forward"), mode = words("mode", {"normalized", "printed"});
const ParameterInfo distance = number("s_m", "m", 0, 1e9), cosine = number("cos_view_sun", "1", -1, 1);
const ParameterInfo zenith = number("zenith_deg", "degrees", 0, 90);
const ParameterInfo sunlight = with_default(colour("E_sun", "1", 1e6), Numbers{1});

/// The air that an adapter's inputs speak of: a preset, with what is given beside it.
Structs air(const Values& in) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"preset", "preset"}, {"betaR_per_m", "beta_rayleigh"}, {"betaM_per_m", "beta_mie"}, {"g", "g"},
      {"mode", "mode"},     {"turbidity", "turbidity"},       {"E0", "solar_irradiance"},  {"sunlight", "sunlight"},
      {"ozone", "ozone"}};
  Parameters given;
  for (const auto& [input, parameter] : names)
    if (in.has(input)) given.emplace(parameter, in.all().find(input)->second);
  return {{"air", kernel_fields(model_parameters(find_model("hoffman_preetham"), given, ""))}};
}

Numbers unit(const Values& in, std::string_view name) {
  const Numbers& v = in.numbers(name);
  const double n = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(std::abs(n - 1) < 1e-3))
    throw InputError("inputs." + std::string(name) + ": length " + number_text(n) + ": expected a unit vector");
  return {v[0] / n, v[1] / n, v[2] / n};
}

/// 1 - cos of the scattering angle.
Numbers apart(const Values& in) { return {1 - in.number("cos_view_sun")}; }
Numbers zenith_cosine(double degrees) { return {std::cos(degrees * degree)}; }

/// Light added by a path and, after it, what the path leaves.
Numbers path(KernelCaller& kernels, const Values& in) {
  Numbers both = kernels.call("hoffman_preetham.terms",
                              {{"rayleigh_path", in.numbers("s_m")},
                               {"mie_path", in.numbers("s_m")},
                               {"one_minus_cos", in.has("cos_view_sun") ? apart(in) : Numbers{1}},
                               {"sunlight", in.has("E_sun") ? in.numbers("E_sun") : Numbers{1, 1, 1}}},
                              air(in));
  return both;
}

Numbers first(const Numbers& both) { return {both[0], both[1], both[2]}; }

// ---- the functions ----

Numbers each(const Values& in, std::string_view name, const auto& answer) {
  Numbers answers;
  for (std::size_t i = 0; i < in.numbers(name).size(); ++i) answers.push_back(answer(i));
  return answers;
}

Numbers beta_rayleigh_of(KernelCaller& kernels, const Values& in) {
  return each(in, "lambda_m", [&](std::size_t i) {
    return kernels.call("hoffman_preetham.beta_rayleigh", {{"wavelength", {1e6 * in.numbers("lambda_m")[i]}}})[0];
  });
}

Numbers beta_mie_thesis_of(KernelCaller& kernels, const Values& in) {
  const Numbers &lambda = in.numbers("lambda_m"), &k = in.numbers("K");
  if (k.size() != lambda.size() && k.size() != 1)
    throw InputError("inputs.K = " + std::to_string(k.size()) + " numbers: expected one, or as many as lambda_m");
  return each(in, "lambda_m", [&](std::size_t i) {
    return kernels.call("hoffman_preetham.beta_mie_thesis", {{"wavelength", {1e6 * lambda[i]}},
                                                             {"k", {k[k.size() == 1 ? 0 : i]}},
                                                             {"turbidity", in.numbers("turbidity")}})[0];
  });
}

Numbers phase_hg(KernelCaller& kernels, const Values& in) {
  const bool printed = in.has("mode") && in.word("mode") == "printed";
  const double asymmetry = in.has("g") ? in.number("g") : -0.75;
  return kernels.call("hoffman_preetham.phase",
                      {{"g", {asymmetry}}, {"printed", {printed ? 1.0 : 0.0}}, {"one_minus_cos", apart(in)}});
}

Numbers shade(KernelCaller& kernels, const Values& in) {
  const Numbers both = path(kernels, in);
  Numbers light;
  for (std::size_t c = 0; c < 3; ++c) light.push_back(in.numbers("L0")[c] * both[3 + c] + both[c]);
  return light;
}

Numbers dome_fit(KernelCaller& kernels, const Values& in) {
  const DomeFit fit = fit_dome({.height = in.word("species") == "rayleigh" ? 8000.0 : 1200.0});
  return kernels.call("hoffman_preetham.dome", {{"height", {fit.height}},
                                                {"a", {fit.a}},
                                                {"b", {fit.b}},
                                                {"c", {fit.c}},
                                                {"mu", zenith_cosine(in.number("zenith_deg"))}});
}

Numbers sky(KernelCaller& kernels, const Values& in) {
  const Structs structs = air(in);
  const Numbers view = unit(in, "view"), sun = unit(in, "sun");
  double squared = 0;
  for (std::size_t c = 0; c < 3; ++c) squared += (view[c] - sun[c]) * (view[c] - sun[c]);
  const Numbers light = kernels.call("hoffman_preetham.sunlight", {{"mu", {sun[2]}}}, structs);
  return first(kernels.call("hoffman_preetham.dome_light",
                            {{"mu", {view[2]}}, {"one_minus_cos", {squared / 2}}, {"sunlight", light}}, structs));
}

Numbers two_species(KernelCaller& kernels, const Values& in) {
  Structs structs = air(in);
  structs["air"]["per_species"] = {1};
  return first(kernels.call("hoffman_preetham.dome_light",
                            {{"mu", zenith_cosine(in.number("view_zenith_deg"))},
                             {"one_minus_cos", apart(in)},
                             {"sunlight", in.numbers("E_sun")}},
                            structs));
}

ParameterInfo direction(std::string_view name) {
  return {.name = name, .kind = Kind::vector, .text = "unit vector, z up", .low = -1.001, .high = 1.001};
}
ParameterInfo list(std::string_view name, std::string_view unit_of, double low, double high) {
  return {.name = name, .kind = Kind::list, .unit = unit_of, .low = low, .high = high, .size = 64};
}

}  // namespace

std::vector<Adapter> hoffman_preetham_adapters() {
  const ParameterInfo turbidity = with_default(number("turbidity", "1", 1, 20), Numbers{2});
  ParameterInfo own_turbidity = turbidity;
  own_turbidity.otherwise.reset();
  own_turbidity.optional = true;
  const ParameterInfo ozone{.name = "ozone", .kind = Kind::flag, .otherwise = Numbers{0}};
  const std::string_view rgb = "red, green, blue";
  return {
      {.name = "hoffman_preetham.beta_rayleigh",
       .text = "Rayleigh scattering coefficient of air",
       .inputs = {list("lambda_m", "m", 3e-7, 1e-6)},
       .outputs = "one for each wavelength",
       .unit = "1/m",
       .call = beta_rayleigh_of,
       .scale = 1e-6},
      {.name = "hoffman_preetham.beta_mie_thesis",
       .text = "Mie scattering coefficient in the form of the authors' theses",
       .inputs = {list("lambda_m", "m", 3e-7, 1e-6), list("K", "1", 0, 10), turbidity},
       .outputs = "one for each wavelength",
       .unit = "1/m",
       .call = beta_mie_thesis_of,
       .scale = 1e-3},
      {.name = "hoffman_preetham.phase_hg",
       .text = "Phase function of aerosols",
       .inputs = {g, cosine, mode},
       .outputs = "phase function",
       .unit = "1/sr",
       .call = phase_hg},
      {.name = "hoffman_preetham.phase_rayleigh",
       .text = "Phase function of molecules",
       .inputs = {cosine},
       .outputs = "phase function",
       .unit = "1/sr",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             return kernels.call("core.phase_rayleigh", {{"one_minus_cos", apart(in)}});
           }},
      {.name = "hoffman_preetham.extinction",
       .text = "What a path leaves of light",
       .inputs = {beta_rayleigh, beta_mie, distance},
       .outputs = rgb,
       .unit = "1",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             const Numbers both = path(kernels, in);
             return Numbers{both[3], both[4], both[5]};
           }},
      {.name = "hoffman_preetham.inscatter",
       .text = "Light that air adds to a path",
       .inputs = {beta_rayleigh, beta_mie, g, mode, cosine, distance, sunlight},
       .outputs = rgb,
       .unit = "1/sr",
       .call = [](KernelCaller& kernels, const Values& in) { return first(path(kernels, in)); },
       .scale = 0.01},
      {.name = "hoffman_preetham.shade",
       .text = "Light of a surface seen through air",
       .inputs = {preset,
                  beta_rayleigh,
                  beta_mie,
                  g,
                  {.name = "L0", .kind = Kind::colour, .unit = "1/sr", .low = 0, .high = 1e6, .otherwise = Numbers{0}},
                  distance,
                  cosine,
                  mode,
                  sunlight},
       .outputs = rgb,
       .unit = "1/sr",
       .call = shade,
       .scale = 0.1},
      {.name = "hoffman_preetham.dome_R_integral",
       .text = "Length through air of ground density that holds as much as a ray of the sky, by integration",
       .inputs = {zenith, with_default(number("H_m", "m", 100, 1e5), Numbers{8000}),
                  with_default(number("Re_m", "m", 1e5, 1e9), Numbers{6.360e6}),
                  with_default(number("top_m", "m", 1e3, 1e6), Numbers{1e5})},
       .outputs = "length",
       .unit = "m",
       .call =
           [](KernelCaller&, const Values& in) {
             const DomeAir of{in.number("H_m"), in.number("Re_m"), in.number("top_m")};
             return Numbers{dome_path(of, in.number("zenith_deg") * degree)};
           },
       .double_only = true,
       .scale = 1e4},
      {.name = "hoffman_preetham.dome_R_fit",
       .text = "The same from the fitted surface",
       .inputs = {zenith, with_default(words("species", {"rayleigh", "mie"}), "rayleigh")},
       .outputs = "length",
       .unit = "m",
       .call = dome_fit,
       .scale = 1e4},
      {.name = "hoffman_preetham.air_mass",
       .text = "Relative air mass",
       .inputs = {zenith},
       .outputs = "air mass",
       .unit = "1",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             return kernels.call("hoffman_preetham.air_mass", {{"mu", zenith_cosine(in.number("zenith_deg"))}});
           }},
      {.name = "hoffman_preetham.sun_attenuation_rgb",
       .text = "What clear air leaves of sunlight at 650, 570 and 475 nm",
       .inputs = {zenith, turbidity, ozone},
       .outputs = rgb,
       .unit = "1",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             return kernels.call("hoffman_preetham.clear_sky", {{"mu", zenith_cosine(in.number("zenith_deg"))},
                                                                {"turbidity", in.numbers("turbidity")},
                                                                {"ozone", in.numbers("ozone")}});
           }},
      {.name = "hoffman_preetham.sky",
       .text = "The sky in a direction, without the sun's disc",
       .inputs = {preset, beta_rayleigh, beta_mie, g, own_turbidity, direction("view"), direction("sun"), mode,
                  words("sunlight", {"accurate", "dome"}), with_default(colour("E0", "1", 1e3), Numbers{1})},
       .outputs = rgb,
       .unit = "1/sr",
       .call = sky,
       .scale = 0.01},
      {.name = "hoffman_preetham.inscatter_two_species",
       .text = "The sky where molecules and aerosols have a dome each",
       .inputs = {preset, beta_rayleigh, beta_mie, g, number("view_zenith_deg", "degrees", 0, 90), cosine, mode,
                  sunlight},
       .outputs = rgb,
       .unit = "1/sr",
       .call = two_species,
       .scale = 0.01},
  };
}

}  // namespace airlight
