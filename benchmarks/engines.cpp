#include "engines.h"

#include <algorithm>
#include <stdexcept>

#include "engine/cpu/cpu_engine.h"
#include "engine/cpu/cpu_targets.h"

namespace airlight {

std::span<const PassInfo> bench_passes();
#define AIRLIGHT_SET(set) extern const KernelTarget target_bench_##set;
AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET

namespace bench {
namespace {

// Groups count from core, which has no passes of its own here.
#define AIRLIGHT_SET(set) const KernelTarget* const groups_##set[] = {&target_bench_##set, &target_bench_##set};
AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET

const CpuTarget targets[] = {
#define AIRLIGHT_SET(set) {#set, groups_##set},
    AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET
};

}  // namespace

std::vector<std::string> sets() {
  std::vector<std::string> names{"f32"};
  const auto of_library = instruction_sets();
  for (auto set = of_library.rbegin(); set != of_library.rend(); ++set) {
    if (set->available) names.emplace_back(set->name);
  }
  return names;
}

std::shared_ptr<Engine> bench_engine(std::string_view set) {
  const auto found = std::ranges::find(targets, set, &CpuTarget::name);
  if (found == std::end(targets)) throw std::logic_error("no benchmark kernels for " + std::string(set));
  return make_cpu_engine(*found);
}

const PassInfo& bench_pass(std::string_view name) {
  const auto found = std::ranges::find(bench_passes(), name, &PassInfo::name);
  if (found == bench_passes().end()) throw std::logic_error("no pass " + std::string(name));
  return *found;
}

std::string set_of(const Engine& engine) { return engine.device().substr(0, engine.device().find(',')); }

}  // namespace bench
}  // namespace airlight
