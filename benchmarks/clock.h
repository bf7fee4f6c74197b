#pragma once
#include <functional>

namespace airlight::bench {

/// Processor time [s] that this process has used, user and system, all threads.
double processor_time();

/// Processor time [s] of one call: the best of five, each over as many calls as fill a hundredth of a second. The best, because other
/// work on the machine can only add.
double best_time(const std::function<void()>& work);

}  // namespace airlight::bench
