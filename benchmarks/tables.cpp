#include "airlight/sky.h"
#include "benchmarks.h"
#include "clock.h"
#include "compare.h"
#include "ray_work.h"
#include "sky/binder.h"

namespace airlight::bench {
namespace {

/// The model's tables that follow from the air alone, in an order in which each has what it reads.
std::vector<TablePass> air_tables(const Model& model) {
  std::vector<TablePass> tables;
  for (const TablePass& t : model.tables) {
    const auto parameters = kernel_pass(t.pass).parameters;
    if (std::ranges::find(parameters, "observer", &ArgumentInfo::name) == parameters.end()) tables.push_back(t);
  }
  return tables;
}

struct Build {
  std::vector<double> seconds;              ///< a table
  std::vector<std::vector<double>> texels;  ///< of each table's first output
};

Build build(Engine& engine, const Model& model, const BakedAir& air, bool read) {
  Binder binder(engine, model, {6'371'000, 120'000, 0});
  binder.set("air", air.numbers);
  binder.set("zones", engine.upload(air.zones.shape, air.zones.rgba));
  binder.set("profile", engine.upload(air.profile.shape, air.profile.rgba));
  binder.set("phases", engine.upload(air.phases.shape, air.phases.rgba));
  Build build;
  for (const TablePass& t : air_tables(model)) {
    const double begin = processor_time();
    const Table table = binder.run(t.pass, t.shape).front();
    build.seconds.push_back(processor_time() - begin);
    if (!read) continue;
    build.texels.emplace_back(4 * t.shape.texels());
    engine.read(table, build.texels.back());
  }
  return build;
}

}  // namespace

void tables(Report& report) {
  report.section("skyview's tables of an atmosphere, new engine; processor time of all threads");
  const Atmosphere earth = built_in_atmosphere("earth");
  const Model& model = find_model("skyview");
  const BakedAir air = bake(earth, realtime_quad, 0, model.air);
  const auto passes = air_tables(model);
  const Build got = build(*make_engine("simd"), model, air, true),
              truth = build(*make_engine("double"), model, air, true);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    // -ln of light, up to 69: compared relative to 1, that is as light itself.
    report.check(std::string(passes[i].pass) + ", 99 % of texels against double",
                 difference(got.texels[i], truth.texels[i], 0.99, 1), 5e-5);
  }
  if (!report.timing()) return;

  std::vector<double> best(passes.size(), 1e9);
  double whole = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double begin = processor_time();
    const Build one = build(*make_engine("simd"), model, air, false);
    whole = std::min(whole, processor_time() - begin);
    for (std::size_t i = 0; i < best.size(); ++i) best[i] = std::min(best[i], one.seconds[i]);
  }
  report.add({"all tables, with the engine and its uploads", 1e3 * whole, "CPU-ms", 60});
  for (std::size_t i = 0; i < best.size(); ++i) {
    const Shape shape = passes[i].shape;
    report.add(
        {"  " + std::string(passes[i].pass) + " " + std::to_string(shape.width) + "x" + std::to_string(shape.height),
         1e3 * best[i], "CPU-ms"});
  }
  report.add({"  before: air baked into profiles", 1e3 * best_time([&] { bake(earth, realtime_quad, 0, model.air); }),
              "CPU-ms"});
}

}  // namespace airlight::bench
