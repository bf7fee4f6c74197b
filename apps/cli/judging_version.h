// What tells one version of what judges models from another.
#pragma once
#include <cstdint>

namespace airlight::cli {

/// As airlight::source_version() is made, of air's optics, of the solvers that models are judged by, and of what asks both.
std::uint64_t judging_version();

}  // namespace airlight::cli
