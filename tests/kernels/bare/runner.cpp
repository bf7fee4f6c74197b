// runner FILE SET: evaluates the vectors of FILE with one instruction set's kernels and nothing else of the library, so that it runs
// where the library does not: on emulated processors.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "bare/vectors.h"
#include "bare_targets.h"  // AIRLIGHT_TARGETS(X): X(set,group) for every kernel unit that is linked, groups in the order of the index
#include "engine/cpu/target.h"

namespace airlight {
#define AIRLIGHT_DECLARE(set, group) extern const KernelTarget target_##group##_##set;
AIRLIGHT_TARGETS(AIRLIGHT_DECLARE)
#undef AIRLIGHT_DECLARE
}  // namespace airlight

int main(int argc, char** argv) {
  using namespace airlight;
  if (argc != 3) return std::fprintf(stderr, "usage: runner FILE SET\n"), 2;
  std::vector<const KernelTarget*> groups;
#define AIRLIGHT_TAKE(set, group) \
  if (std::strcmp(argv[2], #set) == 0) groups.push_back(&target_##group##_##set);
  AIRLIGHT_TARGETS(AIRLIGHT_TAKE)
#undef AIRLIGHT_TAKE
  if (groups.empty()) return std::fprintf(stderr, "runner: no kernels of set '%s' are linked\n", argv[2]), 2;
  std::FILE* file = std::fopen(argv[1], "rb");
  if (!file) return std::perror(argv[1]), 2;

  int functions = 0, wrong = 0;
  double worst = 0;
  for (test::VectorHeader h; std::fread(&h, sizeof h, 1, file) == 1; ++functions) {
    const auto take = [&](int numbers) {
      std::vector<double> v(static_cast<std::size_t>(numbers));
      if (std::fread(v.data(), sizeof(double), v.size(), file) != v.size())
        std::fprintf(stderr, "%s: cut short\n", argv[1]), ++wrong;
      return v;
    };
    const auto uniforms = take(h.uniforms), varying = take(h.varying * h.count), expected = take(h.results * h.count);
    std::vector<double> got(expected.size());
    groups[static_cast<std::size_t>(h.group)]->evals[h.slot]({uniforms.data(), varying.data(), h.count, got.data()});
    double error = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double e =
          got[i] == expected[i] ? 0 : std::fabs(got[i] - expected[i]) / std::fmax(std::fabs(expected[i]), h.scale);
      if (!(e <= error)) error = e;  // a NaN stays
    }
    worst = std::fmax(worst, error / h.bound);
    if (!(error <= h.bound)) {
      std::printf("%s: error %.1e, bound %.1e\n", h.name, error, h.bound);
      ++wrong;
    }
  }
  std::printf("%s, %d lanes: %d sets of arguments, worst error %.2f of its bound\n", argv[2], groups[0]->lanes,
              functions, worst);
  return wrong || functions == 0;
}
