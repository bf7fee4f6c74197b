// Arguments of kernel functions, drawn from the ranges that their documentation states, and how results are compared.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "engine/kernel_index.h"

namespace airlight::test {

inline constexpr std::uint64_t seed = 20260621;

struct Arguments {
  std::vector<double> uniforms, varying;  // as Engine::evaluate takes them
  int count;
};

inline bool is_uniform(KernelType type) {
  return type == KernelType::Scalar || type == KernelType::Scalar4 || type == KernelType::Int ||
         type == KernelType::Struct;
}

class Random {
 public:
  double unit() { return double(bits_() >> 11) * 0x1p-53; }  // the same on every C++ library

  /// One component, rounded to float, so that every engine gets the same number.
  double component(const ArgumentInfo& a) {
    if (a.type == KernelType::Int) return std::floor(a.low + unit() * (a.high - a.low + 1.0));
    if (a.type == KernelType::Bool) return unit() < 0.5 ? 0.0 : 1.0;
    const double x = unit();
    return static_cast<float>(a.logarithmic ? a.low * std::pow(a.high / a.low, x) : a.low + x * (a.high - a.low));
  }

 private:
  std::mt19937_64 bits_{seed};
};

/// Calls per_component(argument or field, uniform) for each input component, in the order of Engine::evaluate's spans.
template <class PerComponent>
void for_each_input(const FunctionInfo& function, const PerComponent& per_component) {
  for (const ArgumentInfo& a : function.arguments) {
    if (a.out) continue;
    if (a.type == KernelType::Struct) {
      for (const ArgumentInfo& field : kernel_struct(a.struct_name).fields) {
        for (int i = 0; i < components(field.type); ++i) per_component(field, true);
      }
    } else {
      for (int i = 0; i < components(a.type); ++i) per_component(a, is_uniform(a.type));
    }
  }
}

inline Arguments draw_arguments(const FunctionInfo& function, int count, Random& random) {
  Arguments drawn{{}, {}, count};
  for_each_input(function, [&](const ArgumentInfo& a, bool uniform) {
    if (uniform)
      drawn.uniforms.push_back(random.component(a));
    else
      for (int i = 0; i < count; ++i) drawn.varying.push_back(random.component(a));
  });
  return drawn;
}

inline int result_count(const FunctionInfo& function) {
  int sum = function.returns_nothing ? 0 : components(function.result);
  for (const ArgumentInfo& a : function.arguments) sum += a.out ? components(a.type) : 0;
  return sum;
}

/// |a - b| / max(|b|, scale), the error that a function's bound is about; infinite where only one is a number.
inline double error_of(double value, double reference, double scale) {
  if (std::isnan(value) && std::isnan(reference)) return 0;
  if (value == reference) return 0;  // also equal infinities
  const double error = std::fabs(value - reference) / std::max(std::fabs(reference), scale);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace airlight::test
