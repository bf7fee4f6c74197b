// Every kernel function on every engine, against the same function in double.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "arguments.h"
#include "engines.h"

namespace airlight::test {
namespace {

struct Case {
  const FunctionInfo* function;
  std::string engine;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.function->name << " on " << c.engine; }

/// @param least_bound  only functions that state at least this
std::vector<Case> cases(double least_bound = 0) {
  std::vector<Case> all;
  for (const FunctionInfo& f : kernel_functions()) {
    if (!f.evaluable || f.bound < least_bound) continue;
    for (const std::string& engine : engine_names()) all.push_back({&f, engine});
  }
  return all;
}
std::string case_name(const testing::TestParamInfo<Case>& info) {
  std::string name(info.param.function->name);
  std::ranges::replace(name, '.', '_');
  return name + "_" + info.param.engine;
}

/// Prints the worst errors at the end, functions down and engines across.
class ErrorTable : public testing::Environment {
 public:
  std::map<std::string_view, std::map<std::string, double>> worst;

  void TearDown() override {
    if (worst.empty()) return;
    const auto engines = engine_names();
    std::printf("\nWorst error against double, |a - b| / max(|b|, scale), seed %llu\n%-34s %8s %8s",
                static_cast<unsigned long long>(seed), "function", "scale", "bound");
    for (const std::string& e : engines) std::printf(" %8s", e.c_str());
    int above = 0;
    for (const auto& [name, errors] : worst) {
      const FunctionInfo& f = kernel_function(name);
      std::printf("\n%-34s %8.0e %8.0e", std::string(name).c_str(), f.scale, f.bound);
      for (const std::string& e : engines) {
        const auto found = errors.find(e);
        if (found == errors.end())
          std::printf(" %8s", "-");
        else
          std::printf(" %8.1e", found->second);
        above += found != errors.end() && !(found->second <= f.bound);
      }
    }
    std::printf("\n%zu functions, %d above their bounds\n", worst.size(), above);
  }
};
ErrorTable& table = *static_cast<ErrorTable*>(testing::AddGlobalTestEnvironment(new ErrorTable));

class Equivalence : public testing::TestWithParam<Case> {};

TEST_P(Equivalence, random_arguments_stay_within_the_stated_bound) {
  const FunctionInfo& f = *GetParam().function;
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam().engine);
  Engine& truth = *find_engine("double").engine;
  Random random;
  constexpr int draws = 12, count = 331;  // an odd count: the last batch of lanes is not full
  const int results = result_count(f);
  std::vector<double> expected(std::size_t(results) * count), got(expected.size());
  double worst = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Arguments a = draw_arguments(f, count, random);
    truth.evaluate(f, a.uniforms, a.varying, count, expected);
    engine.evaluate(f, a.uniforms, a.varying, count, got);
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_TRUE(std::isfinite(expected[i]))
          << "in double, result component " << i / count << ", set " << i % count << ", seed " << seed;
      const double error = error_of(got[i], expected[i], f.scale);
      if (error > worst) worst = error;
      ASSERT_LE(error, f.bound) << "result component " << i / count << ", draw " << draw << ", set " << i % count
                                << ": " << got[i] << " in place of " << expected[i] << ", seed " << seed << "; "
                                << f.file << ":" << f.line;
    }
  }
  table.worst[f.name][GetParam().engine] = worst;
  RecordProperty("worst_error", testing::PrintToString(worst));
}

INSTANTIATE_TEST_SUITE_P(functions, Equivalence, testing::ValuesIn(cases()), case_name);

class Decisions : public testing::TestWithParam<Case> {};

// Where a ray meets a sphere or a shadow begins is a decision: a few rays in a thousand graze, and there engines may differ by all there
// is. All others have to agree, to what float resolves of paths up to the planet's own size.
TEST_P(Decisions, differ_only_for_grazing_rays) {
  const FunctionInfo& f = *GetParam().function;
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam().engine);
  Random random;
  constexpr int draws = 20, count = 500;
  std::vector<double> expected(std::size_t(result_count(f)) * count), got(expected.size());
  int apart = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Arguments a = draw_arguments(f, count, random);
    find_engine("double").engine->evaluate(f, a.uniforms, a.varying, count, expected);
    engine.evaluate(f, a.uniforms, a.varying, count, got);
    for (int set = 0; set < count; ++set) {
      bool differs = false;
      for (std::size_t i = std::size_t(set); i < got.size(); i += count)
        differs = differs || error_of(got[i], expected[i], 1e6) > 1e-4;
      apart += differs;
    }
  }
  EXPECT_LT(apart, draws * count / 100);
  RecordProperty("apart", apart);
}

INSTANTIATE_TEST_SUITE_P(functions, Decisions, testing::ValuesIn(cases(1.0)), case_name);

// ---- edges ----

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr double strange[] = {nan, inf, -inf, 0.0, -0.0, 1e-40, -1e-40, 3e38, -3e38, 1e9, -1e9};

class Edges : public testing::TestWithParam<Case> {};

// Each component in turn takes each strange value, the others being ordinary; then all do at once.
TEST_P(Edges, strange_arguments_end_and_nan_gives_nan_or_a_bounded_value) {
  const FunctionInfo& f = *GetParam().function;
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam().engine);
  Random random;
  int components = 0;
  for_each_input(f, [&](const ArgumentInfo&, bool uniform) { components += !uniform; });
  const int kinds = int(std::size(strange)), count = kinds * (components + 1);
  Arguments a = draw_arguments(f, count, random);
  for (int set = 0; set < count; ++set) {
    for (int c = 0; c < components; ++c) {
      if (set / kinds == c || set / kinds == components) a.varying[std::size_t(c) * count + set] = strange[set % kinds];
    }
  }
  std::vector<double> got(std::size_t(result_count(f)) * count);
  engine.evaluate(f, a.uniforms, a.varying, count, got);  // comes back: that is half the test
  for (std::size_t i = 0; i < got.size(); ++i) {
    const int set = int(i % count);
    if (!std::isnan(strange[set % kinds])) continue;
    // Bounded: finite, in float.
    EXPECT_TRUE(!std::isinf(got[i])) << "result component " << i / count << ", NaN in component " << set / kinds << ": "
                                     << got[i] << "; " << f.file << ":" << f.line;
  }
}

// All corners of the documented ranges: each input at one of its two limits.
TEST_P(Edges, limits_of_the_ranges_stay_within_the_stated_bound) {
  const FunctionInfo& f = *GetParam().function;
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam().engine);
  Random random;
  constexpr int draws = 16, count = 67;
  const auto limit = [&](const ArgumentInfo& a) {
    return double(static_cast<float>(random.unit() < 0.5 ? a.low : a.high));
  };
  std::vector<double> expected(std::size_t(result_count(f)) * count), got(expected.size());
  for (int draw = 0; draw < draws; ++draw) {
    Arguments a{{}, {}, count};
    for_each_input(f, [&](const ArgumentInfo& input, bool uniform) {
      for (int i = 0; i < (uniform ? 1 : count); ++i) (uniform ? a.uniforms : a.varying).push_back(limit(input));
    });
    find_engine("double").engine->evaluate(f, a.uniforms, a.varying, count, expected);
    engine.evaluate(f, a.uniforms, a.varying, count, got);
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_TRUE(std::isfinite(expected[i]))
          << "in double, result component " << i / count << "; " << f.file << ":" << f.line;
      ASSERT_LE(error_of(got[i], expected[i], f.scale), f.bound)
          << "result component " << i / count << ", set " << i % count << ": " << got[i] << " in place of "
          << expected[i] << "; " << f.file << ":" << f.line;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(functions, Edges, testing::ValuesIn(cases()), case_name);

}  // namespace
}  // namespace airlight::test
