#pragma once
#include <ctime>

namespace airlight {

/// Processor time [s] that this process has used, user and system, all threads.
inline double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}  // namespace airlight
