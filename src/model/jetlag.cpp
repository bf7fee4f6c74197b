// The sky of the 4-kilobyte intro "Appear" by Jetlag: single scattering marched by brute force, with clouds as dense haze. Light of
// higher orders, and with it twilight, is left out; docs/models/jetlag.md says what else.
#include "model/jetlag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/field_parameter.h"
#include "model/jetlag_noise.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;

constexpr double noise_scale = 0.0015;  // [texel/m], of the first octave

double wrapped(double x) { return x - jetlag_noise_size * std::floor(x / jetlag_noise_size); }

}  // namespace

Fields jetlag_fields(const JetlagSettings& s) {
  constexpr double g = 0.76, pi = std::numbers::pi;
  const double peak = s.exact_phase ? (1 - g) * (1 - g) : 1.58 - 1.52;
  return {{"rayleigh", {5.8e-6, 13.5e-6, 33.1e-6, 0}},
          {"cloud_base", {1000, 1100, 0, 0}},
          {"cloud_top", {2500, 1500, 0, 0}},
          {"eye", {s.east, 0, s.south, 0}},
          {"jitter", {s.jitter_light, s.jitter_view, s.random_jitter ? 1.0 : 0.0, 0}},
          {"mie_scattering", {2e-5}},
          {"mie_extinction", {2.2e-5}},
          {"haze", {s.clouds ? 8.0 : 1.0}},
          {"per_height", {1 / 96000.0}},
          {"ground_radius", {jetlag_ground_radius}},
          {"top", {jetlag_top}},
          {"sun_intensity", {s.sun_intensity}},
          {"clouds", {s.clouds ? 1.0 : 0.0}},
          {"near", {s.near}},
          {"short_steps", {double(s.short_steps)}},
          {"near_steps", {double(s.near_steps)}},
          {"far_steps", {double(s.far_steps)}},
          {"light_steps", {double(s.clouds ? s.cloud_light_steps : s.clear_light_steps)}},
          {"top_light_steps", {double(s.top_light_steps)}},
          {"keep_top_length", {s.corrected_top_length ? 0.0 : 1.0}},
          {"midpoint", {s.midpoint ? 1.0 : 0.0}},
          {"rayleigh_phase",
           {!s.molecules_shine ? 0
            : s.exact_phase    ? 3 / (16 * pi)
                               : 0.0597}},
          {"mie_phase",
           {!s.haze_shines  ? 0
            : s.exact_phase ? 3 * (1 - g * g) / (8 * pi * (2 + g * g))
                            : 0.0196}},
          {"mie_peak", {peak}},
          {"mie_slope", {2 * g}},
          {"albedo", {s.albedo}},
          {"ground_reach", {s.ground_reach}}};
}

Fields jetlag_drift(double t) {
  const auto octave = [t](double frequency, double offset) {
    const double k = noise_scale * frequency * t;
    return Numbers{wrapped(-90 * k + offset), wrapped(offset), wrapped(80 * k + offset), 0};
  };
  Fields drift{
      {"first", octave(1, 0)}, {"fourth", octave(4, t)}, {"ninth", octave(9, 0)}, {"seventeenth", octave(17, 0)}};
  // The published test is on the first octave's coordinate: at most 38 texels south.
  drift["first"][3] = 38 / noise_scale - 80 * t;
  return drift;
}

// ---- the model ----

namespace {

ParameterInfo number(std::string_view name, std::string_view unit, double low, double high, double otherwise,
                     std::string_view text) {
  return {.name = name, .unit = unit, .text = text, .low = low, .high = high, .otherwise = Numbers{otherwise}};
}
ParameterInfo whole(std::string_view name, double low, double high, double otherwise, std::string_view text) {
  ParameterInfo key = number(name, "1", low, high, otherwise, text);
  key.kind = Kind::whole;
  return key;
}
ParameterInfo flag(std::string_view name, double otherwise, std::string_view text) {
  ParameterInfo key = number(name, "1", 0, 1, otherwise, text);
  key.kind = Kind::flag;
  return key;
}
ParameterInfo word(std::string_view name, std::vector<std::string_view> words, std::string_view text) {
  ParameterInfo key{.name = name, .kind = Kind::word, .text = text, .words = std::move(words)};
  key.otherwise = std::string(key.words.front());
  return key;
}

const std::vector<ParameterInfo>& parameters() {
  static const std::vector<ParameterInfo> keys{
      word("mode", {"cloud", "clear"}, "the final program, with clouds and eightfold haze, or the first, without"),
      number("time", "s", 0, 1e6, 20, "moves the clouds"),
      flag("jitter", 1, "begins each pixel's steps at random: grain in place of bands"),
      word("phase_constants", {"rounded", "exact"}, "of the phase functions"),
      word("sun_top_length", {"printed", "corrected"}, "of the way to the Sun above the clouds' top"),
      word("sampling", {"printed", "midpoint"},
           "left ends of steps dimmed by the whole step, or their middles by half"),
      number("sun_intensity", "1", 0, 1000, 10, "sunlight above the air"),
      number("albedo", "1", 0, 1, 0.3, "of the ground"),
      number("ground_reach", "m", 0, 1e7, 10000, "ground farther away is not seen"),
      number("near", "m", 100, 1e5, 10000, "first zone of a long ray, with clouds"),
      number("east", "m", -1e5, 1e5, 0, "place of the eye"),
      number("south", "m", -1e5, 1e5, 0, "place of the eye; clouds end 25 km south"),
      whole("short_steps", 1, 64, 16, "of rays without clouds, or shorter than the first zone"),
      whole("near_steps", 1, 64, 32, "in the first zone"),
      whole("far_steps", 1, 64, 8, "beyond it"),
      whole("cloud_light_steps", 1, 64, 16, "towards the Sun, below the clouds' top"),
      whole("top_light_steps", 1, 64, 4, "above it"),
      whole("clear_light_steps", 1, 64, 4, "without clouds"),
      whole("frames", 1, 65536, 1, "that make up a picture, each with other random numbers"),
      number("blend", "1", 0, 1, 0.3,
             "weight of each new frame among those before it; 0: mean of all, in linear light"),
      word("blend_in", {"encoded", "linear"}, "frames are blended as encoded by a square root, or in linear light"),
      whole("frame", -1e6, 1e6, 0, "number of the (last) frame: its random numbers; clouds drift on with it"),
      number("frame_rate", "1/s", 1e-3, 1e3, 30, "of frames"),
      flag("still", 0, "clouds stand still while frames gather"),
      flag("fade_in", 0, "pictures brighten over the first 32 s, as the intro's do"),
      word(
          "show", {"picture", "transmittance", "molecules", "haze", "clouds", "light_depth"},
          "what a picture shows: light, or what the air leaves of it; light of one species alone; density of clouds at "
          "the height slice, or the optical depth from there to the Sun"),
      number("slice", "m", 0, 15000, 1600, "height of that"),
      number("exposure", "1", 0, 1000, 1, "in pictures")};
  return keys;
}

JetlagSettings settings_of(const Values& v) {
  JetlagSettings s;
  s.clouds = v.word("mode") == "cloud";
  s.exact_phase = v.word("phase_constants") == "exact";
  s.corrected_top_length = v.word("sun_top_length") == "corrected";
  s.midpoint = v.word("sampling") == "midpoint";
  if (s.midpoint) s.jitter_view = s.jitter_light = 0.5;
  s.random_jitter = v.flag("jitter") && !s.midpoint;
  s.sun_intensity = v.number("sun_intensity");
  s.albedo = v.number("albedo");
  s.near = v.number("near");
  s.ground_reach = v.number("ground_reach");
  s.east = v.number("east");
  s.south = v.number("south");
  const auto steps = [&v](std::string_view name) { return int(v.number(name)); };
  s.short_steps = steps("short_steps");
  s.near_steps = steps("near_steps");
  s.far_steps = steps("far_steps");
  s.cloud_light_steps = steps("cloud_light_steps");
  s.top_light_steps = steps("top_light_steps");
  s.clear_light_steps = steps("clear_light_steps");
  const std::string& show = v.word("show");
  s.molecules_shine = show != "haze";
  s.haze_shines = show != "molecules";
  if (!s.molecules_shine || !s.haze_shines) s.albedo = 0;
  return s;
}

Gathering gathering_of(const Values& v) {
  return {int(v.number("frames")), v.number("blend"), v.word("blend_in") == "encoded"};
}

// Seconds since the intro's frame 0, of one of the frames that a picture gathers.
double since_first(const Values& v, int earlier) { return (v.number("frame") - earlier) / v.number("frame_rate"); }

double cloud_time(const Values& v, int earlier) {
  return v.number("time") + since_first(v, v.flag("still") ? 0 : earlier);
}

Fields frame_fields(const Values& v, int earlier) {
  Numbers random(4);
  if (v.number("blend") > 0) {
    random[0] = random[1] = wrapped(1e5 * (v.number("time") + since_first(v, earlier)));
  } else {
    // At 30 frames a second the published places repeat after 192, and lie between texels, where noise is half averaged. A mean of many
    // takes whole texels spread evenly instead: powers of the plastic number (Roberts 2018, "R2").
    const double frames = v.number("frames"), nth = v.number("frame") * frames + frames - 1 - earlier;
    random[0] = std::floor(wrapped(nth * 0.7548776662466927 * jetlag_noise_size));
    random[1] = std::floor(wrapped(nth * 0.5698402909980532 * jetlag_noise_size));
  }
  const std::string& show = v.word("show");
  const double what = show == "transmittance" ? 1 : show == "clouds" ? 2 : show == "light_depth" ? 3 : 0;
  const double gain = v.flag("fade_in") ? std::clamp(cloud_time(v, earlier) / 32, 0.0, 1.0) : 1;
  return {{"random", random}, {"show", {what}}, {"slice", v.numbers("slice")}, {"gain", {gain}}};
}

}  // namespace

Model jetlag_model() {
  return {.name = "jetlag",
          .summary = "the marched sky of the intro \"Appear\": clouds as dense haze, shafts of light; relative colours",
          .air = {},
          .tables = {},
          .rays = "jetlag.rays",
          .sky_light = "jetlag.sky_light",
          .picture = [](const Situation&) -> std::string_view { return "jetlag.picture"; },
          .haze = [](const Situation&) -> std::string_view { return ""; },
          .fields = [](std::string_view argument, const Situation& s) -> Fields {
            const Values& v = *s.parameters;
            if (argument == "jetlag") return jetlag_fields(settings_of(v));
            if (argument == "drift") return jetlag_drift(cloud_time(v, s.earlier));
            if (argument == "frame") return frame_fields(v, s.earlier);
            return argument == "air" ? unit_air() : Fields{};
          },
          .sun = "jetlag.sun_irradiance",
          .surface = "jetlag.surface",
          .data = [](std::string_view argument, const Situation&) -> HostTable {
            if (argument != "noise") return {};
            return {{jetlag_noise_size, jetlag_noise_size}, jetlag_noise_texels()};
          },
          .gathering = gathering_of,
          // Its sunlight of 10 stands for 1.33e5 lx (data/solar_irradiance.csv).
          .colours = ColourModel{.wavelengths = {}, .luminance = 1.33e4, .tone = "sqrt"},
          .parameters = parameters()};
}

}  // namespace airlight
