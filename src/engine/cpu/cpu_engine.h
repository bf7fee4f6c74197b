#pragma once
#include <memory>
#include <string_view>

#include "airlight/engine.h"

namespace airlight {

struct CpuTarget;

/// An engine that runs one compiled target, tile by tile over oneTBB. Results do not depend on the number of threads.
/// @param target  "double", or an instruction set; empty: AIRLIGHT_ISA, else the widest that this processor has
/// @throws InputError where it is unknown or this machine lacks it.
std::shared_ptr<Engine> make_cpu_engine(std::string_view target);
/// The same for a target that is not in the library (a benchmark's).
std::shared_ptr<Engine> make_cpu_engine(const CpuTarget& target);

}  // namespace airlight
