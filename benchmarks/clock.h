#pragma once
#include <functional>

#include "processor_time.h"

namespace airlight::bench {

/// Processor time [s] of one call: the best of five, each over as many calls as fill a hundredth of a second. The best, because other
/// work on the machine can only add.
double best_time(const std::function<void()>& work);

}  // namespace airlight::bench
