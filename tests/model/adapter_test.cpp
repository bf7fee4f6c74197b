// Adapters: what may be asked, and how questions that may not are refused.
#include <set>

#include "airlight/error.h"
#include "golden.h"

namespace airlight::test {
namespace {

using Kind = ParameterInfo::Kind;
using Numbers = std::vector<double>;

const std::vector<ParameterInfo> keys{
    {.name = "g", .unit = "1", .low = -1, .high = 1},
    {.name = "count", .kind = Kind::whole, .low = 0, .high = 9, .otherwise = Numbers{3}},
    {.name = "light", .kind = Kind::colour, .low = 0, .high = 10, .otherwise = Numbers{1}},
    {.name = "mode", .kind = Kind::word, .words = {"normalized", "printed"}, .otherwise = "normalized"},
    {.name = "top", .unit = "m", .low = 0, .high = 1e5, .optional = true}};

std::string complaint(const Parameters& given) {
  try {
    check_parameters(keys, given, "inputs.");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, that_are_not_given_have_their_defaults) {
  const Values values = check_parameters(keys, {{"g", Numbers{0.5}}}, "");
  EXPECT_EQ(values.number("g"), 0.5);
  EXPECT_EQ(values.number("count"), 3);
  EXPECT_EQ(values.numbers("light"), (Numbers{1, 1, 1})) << "one number is a grey";
  EXPECT_EQ(values.word("mode"), "normalized");
  EXPECT_FALSE(values.has("top"));
}

TEST(Parameters, out_of_their_range_are_named_with_value_and_range) {
  EXPECT_EQ(complaint({}), "inputs.g: missing");
  EXPECT_EQ(complaint({{"g", Numbers{2}}}), "inputs.g = 2: expected -1 .. 1");
  EXPECT_EQ(complaint({{"g", Numbers{std::nan("")}}}), "inputs.g = nan: expected -1 .. 1");
  EXPECT_EQ(complaint({{"g", Numbers{0, 1}}}), "inputs.g = 2 numbers: expected a number");
  EXPECT_EQ(complaint({{"g", "x"}}), "inputs.g = \"x\": expected a number");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"count", Numbers{1.5}}}), "inputs.count = 1.5: expected a whole number");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"light", Numbers{1, 2}}}),
            "inputs.light = 2 numbers: expected three numbers, or one for a grey");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"light", Numbers{1, 2, 11}}}), "inputs.light[2] = 11: expected 0 .. 10");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"top", Numbers{-1}}}), "inputs.top = -1: expected 0 .. 1e+05 m");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"mode", "printd"}}),
            "inputs.mode = \"printd\": unknown; did you mean printed?");
  EXPECT_EQ(complaint({{"g", Numbers{0}}, {"lihgt", Numbers{0}}}), "inputs.lihgt: unknown key; did you mean light?");
}

TEST(Adapters, have_names_of_their_own_and_defaults_in_their_ranges) {
  std::set<std::string_view> names;
  for (const Adapter& adapter : all_adapters()) {
    EXPECT_TRUE(names.insert(adapter.name).second) << adapter.name << " twice";
    EXPECT_FALSE(adapter.text.empty()) << adapter.name;
    for (const ParameterInfo& key : adapter.inputs) {
      if (key.otherwise) {
        EXPECT_NO_THROW(check_parameter(key, *key.otherwise, "")) << adapter.name << ' ' << key.name;
      }
    }
  }
}

TEST(Adapters, that_prepare_data_say_so_on_other_engines) {
  const auto simd = engine_or_none("simd");
  Adapter adapter{.name = "x.y", .text = "", .inputs = {}, .outputs = "", .unit = "1", .call = {}, .double_only = true};
  try {
    evaluate(adapter, {}, *simd);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "x.y: runs on engine double alone, not on simd");
  }
}

}  // namespace
}  // namespace airlight::test
