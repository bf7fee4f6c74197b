#include <tbb/global_control.h>

#include <numbers>

#include "airlight/sky.h"
#include "benchmarks.h"
#include "clock.h"
#include "compare.h"
#include "model/model.h"
#include "sky/binder.h"

namespace airlight::bench {
namespace {

constexpr double degree = std::numbers::pi / 180;

Direction moving_sun(int n) { return direction((10 + 0.01 * n) * degree, (25 + 0.01 * n) * degree); }

std::vector<float> draw(const Sky& sky, const Camera& camera, const Direction& sun) {
  std::vector<float> pixels;
  sky.render(camera, sun, {.sun_disc = false, .wavelengths = {}}, [&](int, int, std::span<const float> rgba) {
    pixels.insert(pixels.end(), rgba.begin(), rgba.end());
    return true;
  });
  return pixels;
}

// The air's light between places on two sides of Rama: a ray a texel, 30 samples each.
struct RamaRays {
  static constexpr Shape shape{512, 256};
  const Model& model = find_model("rama");
  Values values = model_parameters(model, {}, "");
  Situation situation{};
  std::vector<double> places, ends;

  RamaRays() {
    situation.parameters = &values;
    for (int y = 0; y < shape.height; ++y) {
      for (int x = 0; x < shape.width; ++x) {
        const double u = (x + 0.5) / shape.width, angle = 2 * std::numbers::pi * (y + 0.5) / shape.height;
        places.insert(places.end(), {-5, 7, 1, 0});
        ends.insert(ends.end(), {-16 + 32 * u, 7.4 * std::cos(angle), 7.4 * std::sin(angle), 0});
      }
    }
  }
  Binder on(Engine& engine) const {
    Binder b(engine, model, situation);
    b.set("places", engine.upload(shape, places));
    b.set("ends", engine.upload(shape, ends));
    return b;
  }
  std::vector<float> read(Engine& engine) const {
    std::vector<double> light(4 * shape.texels());
    engine.read(on(engine).run_once("rama.between", shape)[0], light);
    return {light.begin(), light.end()};
  }
};

void jetlag(Report& report, const std::shared_ptr<Engine>& engine, const std::shared_ptr<Engine>& yardstick,
            const MachineLimits& machine) {
  const Parameters clear{{"mode", "clear"}, {"jitter", std::vector{0.0}}, {"ground_reach", std::vector{0.0}}};
  const auto camera = [](int width, int height) {
    return Camera{.projection = Projection::perspective, .width = width, .height = height, .elevation = 0.6};
  };
  const Atmosphere earth = built_in_atmosphere("earth");
  const Sky sky(earth, "jetlag", engine, clear), truth(earth, "jetlag", yardstick, clear);
  report.check("jetlag, clear, all values against double",
               difference(draw(sky, camera(120, 68), moving_sun(0)), draw(truth, camera(120, 68), moving_sun(0))),
               3e-4);
  if (!report.timing()) return;
  const Limits& limits = machine.at(set_of(*engine));
  draw(sky, camera(16, 9), moving_sun(0));  // its noise is made and uploaded once
  // Of each of 16 steps: three exps of transmittance; densities are polynomials.
  int n = 1;
  report.add({"jetlag 960x540, clear, 16 x 4 steps",
              1e9 * best_time([&] {
                sky.render(camera(960, 540), moving_sun(n++), {.sun_disc = false, .wavelengths = {}},
                           [](int, int, std::span<const float>) { return true; });
              }) / (960.0 * 540),
              "ns/pixel",
              210.0,
              {},
              limits.pixel(16 * 3, 0)});
}

void rama(Report& report, Engine& engine, Engine& yardstick, const MachineLimits& machine) {
  const RamaRays rays;
  report.check("rama, the air's light against double", difference(rays.read(engine), rays.read(yardstick)), 3e-4);
  if (!report.timing()) return;
  const Limits& limits = machine.at(set_of(engine));
  const Binder binder = rays.on(engine);
  // Three exps and the eight texels of a lookup in three dimensions each of 30 samples.
  report.add(
      {"rama, the air's light along a ray, 30 samples",
       1e9 * best_time([&] { binder.run_once("rama.between", RamaRays::shape); }) / double(RamaRays::shape.texels()),
       "ns/pixel",
       450.0,
       {},
       limits.pixel(30 * 3, 30 * 8)});
  report.add({"rama, its table of 49 x 33 x 33, from nothing", best_time([&] {
                const auto fresh = make_engine("simd");
                Binder(*fresh, rays.model, rays.situation).run("rama.source", {49, 33, 33});
              }),
              "CPU-s", 4.0});
}

}  // namespace

void published(Report& report, const MachineLimits& limits) {
  report.section("Published systems, one thread");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto engine = make_engine("simd"), yardstick = make_engine("double");
  const Atmosphere earth = built_in_atmosphere("earth");
  const Camera small{.projection = Projection::perspective, .width = 120, .height = 68, .elevation = 0.6};
  const Camera large{.projection = Projection::perspective, .width = 1920, .height = 1080, .elevation = 0.6};
  const auto check = [&](const char* model, const Parameters& parameters) {
    const Sky sky(earth, model, engine, parameters), truth(earth, model, yardstick, parameters);
    report.check(std::string(model) + ", all values against double",
                 difference(draw(sky, small, moving_sun(0)), draw(truth, small, moving_sun(0))), 3e-4);
  };
  const auto exps_of = [&](double exps) { return limits.at(set_of(*engine)).pixel(exps, 0); };
  int n = 1;

  for (const char* renderer : {"pixel", "texture", "vertex"}) {
    const Parameters parameters{{"renderer", renderer}};
    check("hoffman_preetham", parameters);
    if (!report.timing()) continue;
    const Sky sky(earth, "hoffman_preetham", engine, parameters);
    // Of the formula: the dome's power (an exp), and three of extinction.
    report.add({std::string("hoffman_preetham 1920x1080, renderer ") + renderer,
                1e9 * best_time([&] {
                  sky.render(large, moving_sun(0), {.sun_disc = false, .wavelengths = {}},
                             [](int, int, std::span<const float>) { return true; });
                }) / (1920.0 * 1080),
                "ns/pixel",
                renderer == std::string("pixel") ? std::optional(15.0) : std::nullopt,
                {},
                exps_of(renderer == std::string("pixel") ? 4 : 0)});
  }

  jetlag(report, engine, yardstick, limits);
  rama(report, *engine, *yardstick, limits);
  check("codeflow", {});
  if (!report.timing()) return;
  const Sky sky(earth, "codeflow", engine);
  const double texels = 6.0 * 514 * 514;
  const Camera tiny{.projection = Projection::perspective, .width = 16, .height = 9, .elevation = 0.6};
  // Sixteen samples of nine exps each, two powers.
  report.add({"codeflow, a texel of its cube map of 6 x 512 x 512",
              1e9 * best_time([&] { draw(sky, tiny, moving_sun(n++)); }) / texels,
              "ns/pixel",
              190.0,
              {},
              exps_of(16 * 9 + 2)});
  report.add({"codeflow 1920x1080, from its kept cube map",
              1e9 * best_time([&] {
                sky.render(large, moving_sun(0), {.sun_disc = false, .wavelengths = {}},
                           [](int, int, std::span<const float>) { return true; });
              }) / (1920.0 * 1080),
              "ns/pixel"});
}

}  // namespace airlight::bench
