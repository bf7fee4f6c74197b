#include <tbb/global_control.h>

#include "airlight/sky.h"
#include "benchmarks.h"
#include "clock.h"
#include "compare.h"
#include "ray_batches.h"
#include "ray_work.h"

namespace airlight::bench {

void rays(Report& report, const MachineLimits& limits) {
  report.section("Batch of random rays, radiance at four wavelengths, tables kept, one thread");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Atmosphere earth = built_in_atmosphere("earth");
  const auto engine = make_engine("simd"), yardstick = make_engine("double");
  const auto few = random_rays(2000);
  auto random = random_rays(1 << 16), sorted = random;
  // Lanes that cross different zones wait for each other: what a caller gains who keeps like rays together.
  std::ranges::sort(sorted, [](const Ray& a, const Ray& b) { return a.view[2] > b.view[2]; });
  const auto answer = [](const Sky& sky, const std::vector<Ray>& asked) {
    const auto wavelengths = sky.realtime_wavelengths();
    std::vector<double> out(asked.size() * wavelengths.size());
    sky.evaluate(Quantity::radiance, asked, wavelengths, out);
    return out;
  };
  for (const char* model : {"single", "skyview"}) {
    const Sky sky(earth, model, engine), truth(earth, model, yardstick);
    const auto got = answer(sky, few), expected = answer(truth, few);
    report.check(std::string(model) + ", 99 % of values against double", difference(got, expected, 0.99), 2e-5);
    if (!report.timing()) continue;
    const Work work = ray_work(earth, find_model(model), sky.model() == "skyview");
    const auto measure = [&](const char* name, std::vector<Ray>& asked) {
      const double time = best_time([&] {
        for (Ray& ray : asked) ray.altitude += 1;  // the engine keeps the answers to the same rays
        answer(sky, asked);
      });
      report.add({std::string(model) + name,
                  1e9 * time / double(asked.size()),
                  "ns/ray",
                  {},
                  {},
                  limits.at(set_of(*engine)).pixel(work.exps, work.texels)});
    };
    measure(", batch of 65536", random);
    measure(", the same rays from zenith to nadir", sorted);
  }
}

}  // namespace airlight::bench
