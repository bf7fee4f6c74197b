// `airlight eval`.
#include <gtest/gtest.h>

#include "airlight/engine.h"
#include "airlight/error.h"
#include "run_program.h"

namespace airlight {
namespace {

using nlohmann::json;

class EvalOnEngine : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      make_engine(GetParam());
    } catch (const WorkError& error) {
      GTEST_SKIP() << "no engine " << GetParam() << " on this machine: " << error.what();
    }
  }
  Outcome eval(const std::string& input) { return run(folder_, {"eval", "--engine", GetParam()}, {.input = input}); }
  Folder folder_;
};

TEST_P(EvalOnEngine, answers_in_order_and_says_what_is_wrong) {
  const Outcome outcome = eval(R"({"id":"k1","fn":"core.phase_rayleigh","inputs":{"one_minus_cos":0.5}})"
                               "\n"
                               R"({"id":"k2","fn":"core.phase_raleigh","inputs":{"one_minus_cos":0.5}})"
                               "\n"
                               R"({"id":"k3","fn":"core.phase_henyey_greenstein","inputs":{"g":0.5,"one_minus_cos":2}})"
                               "\n"
                               R"({"id":"k4","fn":"core.phase_rayleigh","inputs":{"one_minus_cos":1}})"
                               "\n"
                               R"({"id":"k5","fn":"core.phase_henyey_greenstein","inputs":{"g":0,"one_minus_cos":2}})"
                               "\n"
                               R"({"id":"k6","fn":"core.one_minus_cos","inputs":{"a":[1,0,0],"b":[0,1,0]}})");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), 6u);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(answers[i]["id"], (std::string{'k', char('1' + i)}));
  const auto value = [&](int i) { return answers[i].at("value").at(0).get<double>(); };
  // Closed forms: 3/(16 pi) (1 + c^2); (1 - g^2) / (4 pi (1 + g^2 - 2 g c)^1.5). 2e-5: the kernels' stated bound.
  EXPECT_NEAR(value(0), 0.0596831036594607 * 1.25, 2e-5 * 0.0746);
  EXPECT_NE(answers[1].at("error").get<std::string>().find("did you mean core.phase_rayleigh?"), std::string::npos)
      << answers[1];
  EXPECT_NEAR(value(2), 0.0795774715459477 * 0.75 / 3.375, 2e-5 * 0.0177);
  EXPECT_NEAR(value(3), 0.0596831036594607, 2e-5 * 0.0597);
  EXPECT_NEAR(value(4), 0.0795774715459477, 2e-5 * 0.0796);
  EXPECT_NEAR(value(5), 1, 2e-5);
}

TEST_P(EvalOnEngine, outputs_of_several_parts_are_named) {
  // An observer at 100 km altitude in an atmosphere of 60 km, looking straight down: the air begins 40 km below.
  const Outcome outcome = eval(
      R"({"id":1,"fn":"core.enter_atmosphere","inputs":{"ground_radius":6.36e6,"top":6e4,"altitude":1e5,"view":[0,0,-1]}})");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const json answer = json_lines(outcome.out).at(0);
  EXPECT_NEAR(answer.at("value").at(0).get<double>(), 4e4, 2e-5 * 4e4);
  EXPECT_NEAR(answer.at("outputs").at("entry_altitude").at(0).get<double>(), 6e4, 2e-5 * 6e4);
  EXPECT_NEAR(answer.at("outputs").at("entry_mu").at(0).get<double>(), -1, 2e-5);
}

INSTANTIATE_TEST_SUITE_P(Engines, EvalOnEngine, testing::Values("double", "simd", "gl"),
                         [](const auto& engine) { return std::string(engine.param); });

TEST(Eval, the_list_names_every_function_with_units_and_bound) {
  const Folder folder;
  const Outcome text = run(folder, {"eval", "--list"});
  EXPECT_EQ(text.code, 0);
  const Outcome listed = run(folder, {"eval", "--list", "--json"});
  ASSERT_EQ(listed.code, 0);
  const json list = json::parse(listed.out);
  ASSERT_GT(list.size(), 10u);
  for (const json& function : list) {
    EXPECT_NE(text.out.find(function["fn"].get<std::string>()), std::string::npos);
    EXPECT_GT(function["bound"].get<double>(), 0) << function;
    EXPECT_GT(function["scale"].get<double>(), 0) << function;
  }
  EXPECT_EQ(text.out.find("Scalar pad"), std::string::npos) << "padding is nobody's business";
  EXPECT_EQ(listed.out.find("\"pad"), std::string::npos);
  // The list says enough to call a function: every argument in the middle of its range.
  for (const json& function : list) {
    if (function["fn"] != "core.phase_cornette_shanks") continue;
    json inputs;
    for (const json& argument : function["arguments"])
      inputs[argument["name"].get<std::string>()] =
          (argument["range"][0].get<double>() + argument["range"][1].get<double>()) / 2;
    const Outcome answer =
        run(folder, {"eval"}, {.input = json{{"id", 1}, {"fn", function["fn"]}, {"inputs", inputs}}.dump()});
    EXPECT_EQ(answer.code, 0) << answer.out;
    return;
  }
  FAIL() << "core.phase_cornette_shanks is not listed";
}

TEST(Eval, writes_a_file) {
  const Folder folder;
  const Outcome outcome = run(folder, {"eval", "-o", "out.jsonl"},
                              {.input = R"({"id":1,"fn":"core.phase_rayleigh","inputs":{"one_minus_cos":"nan"}})"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(json_lines(read_file(folder / "out.jsonl")).at(0).at("value").at(0), "nan");
}

}  // namespace
}  // namespace airlight
