#include <tbb/global_control.h>

#include "benchmarks.h"
#include "clock.h"
#include "compare.h"

namespace airlight::bench {
namespace {

constexpr Shape shape{512, 16, 1};
constexpr Shape table_shape{256, 64, 1};  // 256 KB: the size of skyview's tables, in the second cache

struct Operation {
  std::string pass, name;
  int count;  ///< a pixel
  bool reads_table;
  double bound;  ///< float against double, relative; 64 terms are summed, each with an ulp (1.2e-7)
  double Limits::*limit;
};
const Operation operations[] = {
    {"bench.exp", "exp", 256, false, 2e-6, &Limits::exp},
    {"bench.division", "division", 256, false, 2e-6, &Limits::division},
    {"bench.fetch", "texel, fetched alone", 64, true, 2e-6, nullptr},
    {"bench.lookup", "texel, in a bilinear lookup", 256, true, 1e-5, &Limits::texel}};  // its coordinates are rounded

std::vector<double> table_texels() {
  std::vector<double> texels(4 * table_shape.texels());
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = 1 + 0.5 * std::sin(0.001 * double(i));
  return texels;
}

std::vector<float> draw(Engine& engine, const Operation& operation, const std::vector<double>& texels) {
  std::vector<float> rgba(4 * shape.texels());
  std::vector<Table> inputs;
  if (operation.reads_table) inputs.push_back(engine.upload(table_shape, texels));
  engine.draw(bench_pass(operation.pass), {}, inputs, shape, 0, shape.height, rgba);
  return rgba;
}

}  // namespace

MachineLimits measure_limits(Report& report) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::vector<double> texels = table_texels();
  MachineLimits limits;
  report.section("Limits of this machine: one operation of one lane (texel: four channels), one thread");
  for (const std::string& set : sets()) {
    const auto engine = bench_engine(set), truth = bench_engine("double");
    for (const Operation& operation : operations) {
      const std::string name = operation.name + ", " + set;
      const double d = difference(draw(*engine, operation, texels), draw(*truth, operation, texels));
      if (!report.timing() || d > operation.bound) report.check(name, d, operation.bound);
      if (!report.timing()) continue;
      std::vector<Table> inputs;
      if (operation.reads_table) inputs.push_back(engine->upload(table_shape, texels));
      std::vector<float> rgba(4 * shape.texels());
      const double time =
          best_time([&] { engine->draw(bench_pass(operation.pass), {}, inputs, shape, 0, shape.height, rgba); });
      const double one = 1e9 * time / double(shape.texels()) / operation.count;
      if (operation.limit) limits[set].*operation.limit = one;
      report.add({name, one, "ns"});
    }
  }
  return limits;
}

}  // namespace airlight::bench
