#include <tbb/global_control.h>

#include <numbers>

#include "airlight/sky.h"
#include "benchmarks.h"
#include "clock.h"
#include "compare.h"

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
