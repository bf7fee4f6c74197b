// Engines for the kernels of benchmarks/kernels, and the machine's limits as these measured them.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/engine.h"
#include "engine/kernel_index.h"

namespace airlight::bench {

/// What this processor runs: f32 (one float at a time), then its instruction sets, narrowest first.
std::vector<std::string> sets();
/// @param set  one of sets(), or "double"
std::shared_ptr<Engine> bench_engine(std::string_view set);
const PassInfo& bench_pass(std::string_view name);
/// The instruction set of an engine of the library.
std::string set_of(const Engine& engine);

/// Time of one operation of one lane [ns].
struct Limits {
  double exp, division, texel;
  /// What a pixel cannot be faster than by much [ns]. Everything else (roots, divisions, addresses) comes on top.
  double pixel(double exps, double texels) const { return exps * exp + texels * texel; }
};
using MachineLimits = std::map<std::string, Limits, std::less<>>;

}  // namespace airlight::bench
