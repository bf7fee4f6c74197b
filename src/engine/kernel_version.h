// What tells one version of the kernels from another.
#pragma once
#include <cstdint>

namespace airlight {

/// A number made of the kernels' text, as it stands in this program: what other kernels computed is not theirs.
std::uint64_t kernel_version();

}  // namespace airlight
