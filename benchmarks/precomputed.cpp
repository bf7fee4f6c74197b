#include <tbb/global_control.h>

#include <algorithm>
#include <numbers>

#include "benchmarks.h"
#include "clock.h"
#include "compare.h"
#include "optics/colour.h"
#include "ray_batches.h"
#include "sky/binder.h"

namespace airlight::bench {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// One engine's tables of an atmosphere, and rays asked of them without what Sky does around the kernel.
class Kernel {
 public:
  Kernel(std::string_view engine, const Atmosphere& atmosphere, const Parameters& parameters)
      : engine_(make_engine(engine)),
        model_(find_model("precomputed")),
        parameters_(model_parameters(model_, parameters, "")),
        binder_(*engine_, model_, {atmosphere.planet.ground_radius, atmosphere.planet.top_altitude, 0, &parameters_}) {
    const BakedAir air = bake(atmosphere, realtime_quad, 0, model_.air);
    binder_.set("air", air.numbers);
    for (const auto& [name, table] :
         {std::pair{"zones", &air.zones}, {"profile", &air.profile}, {"phases", &air.phases}})
      binder_.set(name, engine_->upload(table->shape, table->rgba));
  }

  /// Rows of 1024 rays.
  void set_rays(const std::vector<Ray>& rays) {
    shape_ = {1024, int(rays.size() / 1024), 1};
    std::vector<double> eyes, suns;
    for (const Ray& ray : rays) {
      eyes.insert(eyes.end(), {ray.altitude, ray.view[0], ray.view[1], ray.view[2]});
      suns.insert(suns.end(), {std::min(ray.distance, 1e15), ray.sun[0], ray.sun[1], ray.sun[2]});
    }
    binder_.set("eyes", engine_->lend(shape_, eyes));
    binder_.set("suns", engine_->lend(shape_, suns));
  }

  Table ask() const { return binder_.run_once(model_.rays, shape_).front(); }
  std::vector<double> answers() const {
    std::vector<double> values(4 * shape_.texels());
    engine_->read(ask(), values);
    return values;
  }

 private:
  std::shared_ptr<Engine> engine_;
  const Model& model_;
  Values parameters_;
  Binder binder_;
  Shape shape_;
};

}  // namespace

void precomputed(Report& report) {
  report.section("precomputed, the kernel alone: radiance of rays at four wavelengths, tables made, one thread");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Atmosphere earth = built_in_atmosphere("earth");
  const auto random = random_rays(1 << 16), picture = picture_rays(1024, 64, 30 * degree);
  const auto check = [&](const char* name, const Parameters& mode) {
    Kernel got("simd", earth, mode), truth("double", earth, mode);
    const std::vector<Ray> few(random.begin(), random.begin() + 2048);
    got.set_rays(few);
    truth.set_rays(few);
    report.check(name, difference(got.answers(), truth.answers(), 0.99), 1e-4);
  };
  check("marched, 99 % of values against double", {{"detail", "draft"}});
  check("tables, 99 % of values against double", {{"detail", "draft"}, {"first_order", "tables"}});
  if (!report.timing()) return;
  const auto measure = [&](Kernel& kernel, const char* name, const std::vector<Ray>& rays, double at_most) {
    kernel.set_rays(rays);
    report.add({name, 1e9 * best_time([&] { kernel.ask(); }) / double(rays.size()), "ns/ray", at_most});
  };
  Kernel marched("simd", earth, {}), looked_up("simd", earth, {{"first_order", "tables"}});
  measure(marched, "marched, random rays", random, 450);
  measure(marched, "marched, a picture's rays", picture, 450);
  measure(looked_up, "tables, random rays", random, 200);
  measure(looked_up, "tables, a picture's rays", picture, 80);
}

}  // namespace airlight::bench
