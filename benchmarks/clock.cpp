#include "clock.h"

#include <algorithm>

namespace airlight::bench {

double best_time(const std::function<void()>& work) {
  double best = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double begin = processor_time();
    double used = 0;
    int calls = 0;
    do {
      work();
      ++calls;
      used = processor_time() - begin;
    } while (used < 0.01);
    best = std::min(best, used / calls);
  }
  return best;
}

}  // namespace airlight::bench
