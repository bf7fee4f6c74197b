// The functions that Jetlag's specification names; y up.
#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "model/adapter.h"
#include "model/jetlag.h"
#include "model/jetlag_noise.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;

double wrapped(double x) { return x - jetlag_noise_size * std::floor(x / jetlag_noise_size); }

Numbers unit(const Values& in, std::string_view name) {
  Numbers v = in.numbers(name);
  const double n = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(std::abs(n - 1) < 1e-3))
    throw InputError("inputs." + std::string(name) + ": length " + number_text(n) + ": expected a unit vector");
  for (double& c : v) c /= n;
  return v;
}

// Gap and distance along a ray from the Earth's centre, as kernels/jetlag/jetlag.glsl defines them.
double gap_of(const Numbers& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + 2 * jetlag_ground_radius * p[1]; }
double along_of(const Numbers& p, const Numbers& d) {
  return p[0] * d[0] + p[1] * d[1] + p[2] * d[2] + jetlag_ground_radius * d[1];
}

const ParameterInfo length_key{.name = "L_m", .unit = "m", .text = "length of the ray", .low = 0, .high = 1e8};
ParameterInfo place_key(std::string_view name) {
  return {
      .name = name, .kind = Kind::vector, .unit = "m", .text = "y up, origin on the ground", .low = -1e7, .high = 1e7};
}
ParameterInfo direction_key(std::string_view name) {
  return {.name = name, .kind = Kind::vector, .text = "unit vector, y up", .low = -1.001, .high = 1.001};
}
ParameterInfo steps_key(std::string_view name, double otherwise) {
  return {.name = name, .kind = Kind::whole, .low = 1, .high = 1024, .otherwise = Numbers{otherwise}};
}
ParameterInfo number_key(std::string_view name, std::string_view unit, double low, double high, double otherwise) {
  return {.name = name, .unit = unit, .low = low, .high = high, .otherwise = Numbers{otherwise}};
}
ParameterInfo sun_key() {
  ParameterInfo key = direction_key("sun");
  const double n = std::sqrt(2.0001);  // where the demo begins
  key.otherwise = Numbers{1 / n, 0.01 / n, 1 / n};
  return key;
}
const ParameterInfo light_behind{.name = "Lo",
                                 .kind = Kind::colour,
                                 .text = "light at the ray's end",
                                 .low = 0,
                                 .high = 1e6,
                                 .otherwise = Numbers{0}};
const ParameterInfo phase_constants{
    .name = "phase_constants", .kind = Kind::word, .words = {"rounded", "exact"}, .otherwise = "rounded"};

Table upload_noise(KernelCaller& kernels) {
  static const std::vector<double> texels = jetlag_noise_texels();
  return kernels.upload({jetlag_noise_size, jetlag_noise_size}, texels);
}
Table upload_one(KernelCaller& kernels, double x, double y, double z, double w) {
  return kernels.upload({1, 1}, Numbers{x, y, z, w});
}
Table upload_place(KernelCaller& kernels, const Numbers& p, double w = 0) {
  return upload_one(kernels, p[0], p[1], p[2], w);
}

/// Light at the eye of light `Lo` behind a ray's length of air: the rays pass, whose world has z up.
Numbers scatter(KernelCaller& kernels, const Values& in, JetlagSettings settings, double time) {
  const Numbers o = in.numbers("o_m"), view = unit(in, "dir"), sun = unit(in, "sun");
  settings.east = o[0], settings.south = o[2];
  settings.ground_reach = 0;
  settings.exact_phase = in.word("phase_constants") == "exact";
  const auto answers = kernels.run("jetlag.rays", {{"jetlag", jetlag_fields(settings)}, {"drift", jetlag_drift(time)}},
                                   {{"noise", upload_noise(kernels)},
                                    {"eyes", upload_one(kernels, o[1], view[0], -view[2], view[1])},
                                    {"suns", upload_one(kernels, in.number("L_m"), sun[0], -sun[2], sun[1])}},
                                   {1, 1});
  Numbers light = kernels.read(answers[0]);
  const Numbers through = kernels.read(answers[1]);
  light.resize(3);
  for (std::size_t c = 0; c < 3; ++c) light[c] += in.numbers("Lo")[c] * through[c];
  return light;
}

}  // namespace

std::vector<Adapter> jetlag_adapters() {
  JetlagSettings clear;
  clear.clouds = false;
  const Fields clear_air = jetlag_fields(clear);
  std::vector<Adapter> list;
  list.push_back(
      {.name = "jetlag.density_clear",
       .text = "Densities of molecules and haze without clouds, relative to sea level",
       .inputs = {place_key("p_m")},
       .outputs = "molecules, haze",
       .unit = "1",
       .call = [clear_air](KernelCaller& kernels, const Values& in) {
         return kernels.call("jetlag.density", {{"gap", {gap_of(in.numbers("p_m"))}}}, {{"jetlag", clear_air}});
       }});
  list.push_back({.name = "jetlag.escape",
                  .text = "Distance to a sphere about the Earth's centre: where a ray enters it, else where it leaves; "
                          "-1 if it misses",
                  .inputs = {place_key("p_m"),
                             direction_key("dir"),
                             {.name = "R_m", .unit = "m", .text = "radius", .low = 1, .high = 1e8}},
                  .outputs = "distance",
                  .unit = "m",
                  .call = [](KernelCaller& kernels, const Values& in) {
                    const Numbers& p = in.numbers("p_m");
                    const double above = in.number("R_m") - jetlag_ground_radius;
                    return kernels.call("jetlag.escape", {{"gap", {gap_of(p)}},
                                                          {"along", {along_of(p, unit(in, "dir"))}},
                                                          {"shell", {above * (2 * jetlag_ground_radius + above)}}});
                  }});
  list.push_back({.name = "jetlag.depth_integral_clear",
                  .text = "Depths of molecules and haze along a ray, in equal steps from its beginning",
                  .inputs = {place_key("o_m"), direction_key("dir"), length_key, steps_key("steps", 16)},
                  .outputs = "molecules, haze",
                  .unit = "m",
                  .call = [clear](KernelCaller& kernels, const Values& in) {
                    JetlagSettings settings = clear;
                    settings.clear_light_steps = int(in.number("steps"));
                    Numbers depth = kernels.read(
                        kernels.run("jetlag.depth", {{"jetlag", jetlag_fields(settings)}, {"drift", jetlag_drift(0)}},
                                    {{"noise", upload_noise(kernels)},
                                     {"places", upload_place(kernels, in.numbers("o_m"), in.number("L_m"))},
                                     {"directions", upload_place(kernels, unit(in, "dir"))}},
                                    {1, 1})[0]);
                    depth.resize(2);
                    return depth;
                  }});
  list.push_back(
      {.name = "jetlag.noise31",
       .text = "The noise at three coordinates, in texels",
       .inputs = {{.name = "v", .kind = Kind::vector, .unit = "texel", .low = -1e9, .high = 1e9}},
       .outputs = "noise",
       .unit = "1",
       .call = [](KernelCaller& kernels, const Values& in) {
         Numbers v = in.numbers("v");
         for (double& c : v) c = wrapped(c);
         Numbers noise = kernels.read(kernels.run(
             "jetlag.noise", {}, {{"noise", upload_noise(kernels)}, {"places", upload_place(kernels, v)}}, {1, 1})[0]);
         noise.resize(1);
         return noise;
       }});
  list.push_back(
      {.name = "jetlag.noise_byte",
       .text = "A byte of the noise table: row by row; red, green, blue, alpha",
       .inputs =
           {{.name = "index", .kind = Kind::whole, .low = 0, .high = 4.0 * jetlag_noise_size * jetlag_noise_size - 1}},
       .outputs = "byte",
       .unit = "1",
       .call = [](KernelCaller&, const Values& in) {
         return Numbers{double(jetlag_noise_byte(static_cast<std::uint32_t>(in.number("index"))))};
       }});
  list.push_back(
      {.name = "jetlag.density_cloud",
       .text = "Densities of molecules and of haze with clouds, and the noise that shapes those",
       .inputs = {place_key("p_m"), number_key("t_s", "s", 0, 1e6, 0)},
       .outputs = "molecules, haze, noise",
       .unit = "1",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             Numbers density = kernels.read(kernels.run(
                 "jetlag.density", {{"jetlag", jetlag_fields({})}, {"drift", jetlag_drift(in.number("t_s"))}},
                 {{"noise", upload_noise(kernels)}, {"places", upload_place(kernels, in.numbers("p_m"))}}, {1, 1})[0]);
             density.resize(3);
             return density;
           },
       .bound = 2e-2});
  list.push_back({.name = "jetlag.scatter_clear",
                  .text = "Light of a ray through clear air, with what is behind it",
                  .inputs = {place_key("o_m"), direction_key("dir"), length_key, light_behind, sun_key(),
                             steps_key("steps", 16), steps_key("light_steps", 4), phase_constants},
                  .outputs = "red, green, blue",
                  .unit = "1",
                  .call = [clear](KernelCaller& kernels, const Values& in) {
                    JetlagSettings settings = clear;
                    settings.short_steps = int(in.number("steps"));
                    settings.clear_light_steps = int(in.number("light_steps"));
                    return scatter(kernels, in, settings, 0);
                  }});
  list.push_back(
      {.name = "jetlag.scatter_cloud",
       .text = "Light of a ray through air with clouds, with what is behind it",
       .inputs =
           {place_key("o_m"),
            direction_key("dir"),
            length_key,
            light_behind,
            sun_key(),
            number_key("t_s", "s", 0, 1e6, 0),
            number_key("jitter_view", "step", 0, 1, 0),
            number_key("jitter_light", "step", 0, 1, 0),
            {.name = "sun_top_length", .kind = Kind::word, .words = {"printed", "corrected"}, .otherwise = "printed"},
            phase_constants},
       .outputs = "red, green, blue",
       .unit = "1",
       .call =
           [](KernelCaller& kernels, const Values& in) {
             JetlagSettings settings;
             settings.corrected_top_length = in.word("sun_top_length") == "corrected";
             // A step less where the value is 1, as published: 1 counts as 0.999.
             settings.jitter_view = std::min(in.number("jitter_view"), 0.999);
             settings.jitter_light = std::min(in.number("jitter_light"), 0.999);
             return scatter(kernels, in, settings, in.number("t_s"));
           },
       .bound = 2e-2});
  return list;
}

}  // namespace airlight
