// The sky of the 4-kilobyte intro "Appear" by Jetlag: single scattering marched by brute force, with clouds as dense haze. Light of
// higher orders, and with it twilight, is left out; docs/models/jetlag.md says what else.
#include "model/jetlag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "model/field_parameter.h"
#include "model/jetlag_noise.h"
#include "optics/number_text.h"

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
          {"per_rayleigh_height", {1 / 8000.0}},
          {"per_mie_height", {1 / 1200.0}},
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
          {"rayleigh_phase", {s.exact_phase ? 3 / (16 * pi) : 0.0597}},
          {"mie_phase", {s.exact_phase ? 3 * (1 - g * g) / (8 * pi * (2 + g * g)) : 0.0196}},
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

std::vector<double> jetlag_frames(const std::vector<JetlagFrame>& frames) {
  std::vector<double> texels(5 * 4 * frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Fields drift = jetlag_drift(frames[k].clouds);
    const double at = wrapped(1e5 * frames[k].noise);
    const Numbers rows[] = {drift["first"], drift["fourth"], drift["ninth"], drift["seventeenth"], {at, at, 0, 0}};
    for (std::size_t row = 0; row < 5; ++row)
      for (std::size_t c = 0; c < 4; ++c) texels[4 * (row * frames.size() + k) + c] = rows[row][c];
  }
  return texels;
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
      whole("frames", 1, 256, 1, "that make up a picture"),
      number("blend", "1", 0, 1, 0.3, "weight of each new frame, blended as encoded by a square root; 0: mean of all"),
      number("frame_rate", "1/s", 1, 240, 30, "of frames that are blended"),
      flag("still", 0, "clouds stand still while frames gather"),
      word("show", {"picture", "transmittance"}, "what a picture shows"),
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
  return s;
}

// No texel may turn its loops oftener (docs/architecture.md).
constexpr double most_turns = 60000;

int checked_frames(const Values& v) {
  const JetlagSettings s = settings_of(v);
  const double view = s.clouds ? std::max(s.short_steps, s.near_steps + s.far_steps) : s.short_steps;
  const double light = s.clouds ? s.cloud_light_steps + s.top_light_steps : s.clear_light_steps;
  const double turns = view * (1 + light) + 32, most = std::floor(most_turns / turns);
  if (v.number("frames") > most || most < 1) {
    throw InputError("jetlag.frames = " + number_text(v.number("frames")) + ": expected 1 .. " + number_text(most) +
                     " with these numbers of steps: a pixel turns its loops " + number_text(most_turns) +
                     " times at most");
  }
  return int(v.number("frames"));
}

HostTable frames_table(const Values& v) {
  const int count = checked_frames(v);
  std::vector<JetlagFrame> frames;
  for (int k = 0; k < count; ++k) {
    const double time = v.number("time") - (count - 1 - k) / v.number("frame_rate");
    frames.push_back({v.flag("still") ? v.number("time") : time, time});
  }
  return {{count, 5}, jetlag_frames(frames)};
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
            if (argument == "drift") return jetlag_drift(v.number("time"));
            if (argument == "air") return unit_air();
            if (argument == "frames")
              return {{"count", v.numbers("frames")},
                      {"blend", v.numbers("blend")},
                      {"show", {v.word("show") == "picture" ? 0.0 : 1.0}}};
            return {};
          },
          .sun = "jetlag.sun_irradiance",
          .surface = "jetlag.surface",
          .data = [](std::string_view argument, const Situation& s) -> HostTable {
            if (argument == "noise") return {{jetlag_noise_size, jetlag_noise_size}, jetlag_noise_texels()};
            if (argument == "drifts") return frames_table(*s.parameters);
            return {};
          },
          // Its sunlight of 10 stands for 1.33e5 lx (data/solar_irradiance.csv).
          .colours = ColourModel{.wavelengths = {}, .luminance = 1.33e4, .tone = "clip"},
          .parameters = parameters()};
}

}  // namespace airlight
