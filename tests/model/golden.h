// Golden values of a published system: an adapter's answers against numbers that were computed without it, on all engines.
#pragma once
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "airlight/engine.h"
#include "model/adapter.h"
#include "sky/engine_caller.h"

namespace airlight::test {

struct Golden {
  std::string id, function;
  Parameters inputs;
  std::vector<double> expected;
  double scale = 1;  ///< |a - b| <= tolerance * max(|b|, scale); 0: relative
  double double_bound = 2e-6, float_bound = 3e-4;
};
inline void PrintTo(const Golden& g, std::ostream* out) { *out << g.id; }

/// Half a unit of the last of the six digits that golden values are printed with.
inline double print_rounding(double value) {
  return value == 0 ? 0 : 0.5 * std::pow(10, std::floor(std::log10(std::fabs(value))) - 5);
}

inline std::shared_ptr<Engine> engine_or_none(const std::string& name) {
  static std::map<std::string, std::shared_ptr<Engine>> engines;
  if (const auto found = engines.find(name); found != engines.end()) return found->second;
  std::shared_ptr<Engine> engine;
  try {
    engine = make_engine(name);
  } catch (const std::runtime_error&) {
  }
  return engines[name] = engine;
}

inline std::vector<double> answer(const std::string& function, const Parameters& inputs, Engine& engine) {
  const Adapter* adapter = find_adapter(all_adapters(), function);
  if (!adapter) throw std::logic_error("no adapter " + function);
  return evaluate(*adapter, check_parameters(adapter->inputs, inputs, "inputs."), engine);
}

inline void expect_golden(const Golden& g, const std::string& engine_name) {
  const auto engine = engine_or_none(engine_name);
  if (!engine) GTEST_SKIP() << "no engine " << engine_name << " on this machine";
  const Adapter* adapter = find_adapter(all_adapters(), g.function);
  ASSERT_TRUE(adapter) << g.function;
  if (adapter->double_only && engine_name != "double") return;  // answered with an error: tests/model/adapter_test.cpp
  const auto got = answer(g.function, g.inputs, *engine);
  ASSERT_EQ(got.size(), g.expected.size());
  const double bound = engine_name == "double" ? g.double_bound : g.float_bound;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double b = g.expected[i];
    EXPECT_LE(std::fabs(got[i] - b), bound * std::max(std::fabs(b), g.scale) + print_rounding(b))
        << g.id << " component " << i << " on " << engine_name << ": " << got[i] << " in place of " << b;
  }
}

using GoldenCase = std::tuple<Golden, const char*>;
inline std::string golden_name(const testing::TestParamInfo<GoldenCase>& info) {
  std::string name = std::get<0>(info.param).id + "_" + std::get<1>(info.param);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}
inline auto on_all_engines(const std::vector<Golden>& values) {
  return testing::Combine(testing::ValuesIn(values), testing::Values("double", "simd", "gl"));
}

}  // namespace airlight::test
