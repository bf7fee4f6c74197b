#include <tbb/global_control.h>

#include <numbers>

#include "benchmarks.h"
#include "clock.h"
#include "compare.h"

namespace airlight::bench {
namespace {

constexpr double exps = 16 * (2 + 4 * 2 + 4);

// Hillaire's Earth (2020) at four wavelengths, the Sun 20 degrees up; in the order of struct March.
std::vector<double> air() {
  const double up = 20 * std::numbers::pi / 180;
  return {5.802e-6,     9.6e-6, 13.558e-6, 33.1e-6, 3.996e-6,   3.996e-6,   3.996e-6, 3.996e-6, 0,   std::cos(up),
          std::sin(up), 0,      6.36e6,    1e5,     1 / 8000.0, 1 / 1200.0, 1.11,     0.8,      500, 0};
}

// Of 16 and 8 lanes, the rest goes to what is not arithmetic, and to a float's exp, which has a table that lanes cannot share.
std::optional<double> required(const std::string& set) {
  if (set == "avx512") return 7;
  if (set == "avx2") return 4.5;
  return {};
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

void march(Report& report, const MachineLimits& limits) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  report.section("March of 16 x 4 steps, four wavelengths, 224 exps a pixel, one thread");
  const PassInfo& pass = bench_pass("bench.march");
  const std::vector<double> parameters = air();
  const Shape shape = report.timing() ? Shape{256, 128, 1} : Shape{64, 32, 1};
  const auto draw = [&](Engine& engine) {
    std::vector<float> rgba(4 * shape.texels());
    engine.draw(pass, parameters, {}, shape, 0, shape.height, rgba);
    return rgba;
  };
  const auto truth = draw(*bench_engine("double"));
  const auto time = [&](Engine& engine) {
    const double begin = processor_time();
    draw(engine);
    return 1e9 * (processor_time() - begin) / double(shape.texels());
  };
  const auto scalar = bench_engine("f32");
  for (const std::string& set : sets()) {
    const auto engine = bench_engine(set);
    // 1e-5: a level view ends 1100 km away, where float knows the altitude to a few centimetres of a scale height of 1200 m.
    report.check(set + " against double", difference(draw(*engine), truth), 1e-5);
    if (!report.timing()) continue;
    std::vector<double> ratios, times;
    for (int pair = 0; pair < 5; ++pair) {
      const double slow = time(*scalar), fast = time(*engine);
      times.push_back(fast);
      ratios.push_back(slow / fast);
    }
    report.add({set, std::ranges::min(times), "ns/pixel", {}, {}, limits.at(set).pixel(exps, 0)});
    if (set != "f32")
      report.add({"f32 / " + set + ", median of five interleaved pairs", median(ratios), "x", {}, required(set)});
  }
  if (report.timing()) report.add({"double", time(*bench_engine("double")), "ns/pixel"});
}

}  // namespace airlight::bench
