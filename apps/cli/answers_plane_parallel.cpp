// `plane-parallel`: all orders of scattering in flat layers, by adding and doubling.
#include <tbb/parallel_for.h>

#include <algorithm>

#include "airlight/error.h"
#include "answers.h"
#include "batch_plane_parallel.h"
#include "interrupt.h"
#include "reference/adding_doubling.h"

namespace airlight::cli {
namespace {

using reference::AddingDoubling;

struct LayeredAir {
  AddingDoubling solver;
  reference::Level level;
};

class PlaneParallelAnswerer : public Answerer {
 public:
  bool has(const Asked& asked) const override { return asked.name == "radiance" || asked.name == "sky_irradiance"; }

  std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays) override {
    const LayeredAir& air = of(topic.own);
    const bool irradiance = topic.asked->spectral == Quantity::sky_irradiance;
    if (irradiance && air.level == reference::Level::space)
      throw InputError("observer = space: sky_irradiance is that of the ground");

    // Rays of one sun share a solution; parts of some hundred of them share the processor.
    std::map<Direction, std::vector<std::size_t>> suns;
    for (std::size_t i = 0; i < rays.size(); ++i) suns[rays[i].sun].push_back(i);
    constexpr std::size_t part = 256;
    std::vector<std::span<const std::size_t>> parts;
    for (const auto& [sun, indices] : suns)
      for (std::size_t begin = 0; begin < indices.size(); begin += part)
        parts.push_back(std::span(indices).subspan(begin, std::min(part, indices.size() - begin)));

    std::vector<Answer> answers(rays.size());
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t p) {
      check_interrupt();
      const Direction& sun = rays[parts[p].front()].sun;
      std::vector<Direction> views;
      for (const std::size_t i : parts[p]) views.push_back(rays[i].view);
      const std::vector<double> values = irradiance
                                             ? std::vector<double>(views.size(), air.solver.fluxes(sun[2]).diffuse)
                                             : air.solver.radiance(air.level, views, sun);
      for (std::size_t i = 0; i < views.size(); ++i) {
        Answer& answer = answers[parts[p][i]];
        answer.value = {values[i]};
        if (air.solver.truncated() > 1e-6) answer.more["truncated"] = air.solver.truncated();
      }
    });
    return answers;
  }

  std::string engine() const override { return "adding and doubling (double)"; }

 private:
  const LayeredAir& of(const std::string& own) {
    if (const auto found = airs_.find(own); found != airs_.end()) return found->second;
    if (airs_.size() >= 64) airs_.clear();  // a batch may hold any number of airs
    const auto [air, from_space] = parse_plane_parallel(own);
    const auto level = from_space ? reference::Level::space : reference::Level::ground;
    return airs_.emplace(own, LayeredAir{AddingDoubling(air), level}).first->second;
  }

  std::map<std::string, LayeredAir> airs_;
};

}  // namespace

std::unique_ptr<Answerer> make_plane_parallel_answerer(const Workshop&) {
  return std::make_unique<PlaneParallelAnswerer>();
}

}  // namespace airlight::cli
