// Test vectors in a file: arguments of kernel functions and what double makes of them. Numbers as they lie in memory: all of
// our targets are little-endian.
#pragma once
#include <cstdint>

namespace airlight::test {

struct VectorHeader {
  char name[64];
  double bound, scale;
  std::int32_t group, slot;  // which unit's list, and the place in it
  std::int32_t uniforms, varying, results, count;
  // then the doubles: uniforms; varying components, each `count`; result components, each `count`
};

}  // namespace airlight::test
