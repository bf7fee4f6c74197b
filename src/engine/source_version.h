// What tells one version of what computes tables from another.
#pragma once
#include <cstdint>

namespace airlight {

/// A number made of the text of the kernels and of the sources that run them (src/engine, src/model, src/sky), as they were when this
/// program was built: what others computed is not theirs. tools/source_version.py makes it.
std::uint64_t source_version();

}  // namespace airlight
