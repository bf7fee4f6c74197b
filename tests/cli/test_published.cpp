// Published systems on the command line: adapters of `eval`, `--set`, `--preset`, their parameters in `models` and in scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "airlight/engine.h"
#include "airlight/error.h"
#include "run_program.h"

namespace airlight {
namespace {

using nlohmann::json;

json eval(const std::string& line, const char* engine = "double") {
  const Folder folder;
  const Outcome outcome = run(folder, {"eval", "--engine", engine}, {.input = line});
  return json_lines(outcome.out).at(0);
}

TEST(Adapters, answer_with_their_own_inputs_words_and_defaults) {
  // Golden values of the specification, 2e-6 and the print's rounding.
  EXPECT_NEAR(eval(R"({"id":1,"fn":"codeflow.phase","inputs":{"alpha":0,"g":0.63}})")["value"][0].get<double>(),
              0.228603, 2e-6);
  const json l =
      eval(R"({"id":1,"fn":"hoffman_preetham.inscatter","inputs":{"cos_view_sun":0.5,"s_m":10000,"mode":"printed"}})")
          ["value"];
  EXPECT_NEAR(l.at(2).get<double>(), 0.0218367, 1e-7);
}

TEST(Adapters, refuse_what_their_inputs_may_not_be) {
  const auto complaint = [](const std::string& inputs, const char* engine = "double") {
    return eval(R"({"id":1,"fn":"hoffman_preetham.dome_R_integral","inputs":)" + inputs + "}", engine)
        .at("error")
        .get<std::string>();
  };
  EXPECT_NE(complaint(R"({})").find("inputs.zenith_deg: missing"), std::string::npos);
  EXPECT_NE(complaint(R"({"zenith_deg":91})").find("inputs.zenith_deg = 91: expected 0 .. 90 degrees"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"zenith_deg":"nan"})").find("inputs.zenith_deg"), std::string::npos);
  EXPECT_NE(complaint(R"({"zenith_dg":1})").find("inputs.zenith_dg: unknown key; did you mean zenith_deg?"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"zenith_deg":1})", "simd").find("runs on engine double alone, not on simd"),
            std::string::npos);
}

TEST(Adapters, are_listed_with_their_engines_and_hide_what_they_are_named_like) {
  const Folder folder;
  const json list = json::parse(run(folder, {"eval", "--list", "--json"}).out);
  std::set<std::string> names;
  bool alone = false;
  for (const json& entry : list) {
    EXPECT_TRUE(names.insert(entry["fn"]).second) << entry["fn"] << " is listed twice";
    if (entry["fn"] == "hoffman_preetham.dome_R_integral") alone = entry["engines"] == json::array({"double"});
  }
  EXPECT_TRUE(alone);
  EXPECT_NE(run(folder, {"eval", "--list"}).out.find("engine double alone"), std::string::npos);
}

void expect_refused(const std::vector<std::string>& words, const std::string& message) {
  const Folder folder;
  std::vector<std::string> all{"sky", "--sun-elevation", "10", "--size", "16x8", "-o", "a.png"};
  all.insert(all.end(), words.begin(), words.end());
  const Outcome outcome = run(folder, all);
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(PublishedSky, refuses_parameters_by_name_value_and_range) {
  expect_refused({"--model", "codeflow", "--set", "intensity=99"}, "codeflow.intensity = 99: expected 0 .. 10");
  expect_refused({"--model", "codeflow", "--set", "intensty=1"}, "did you mean intensity?");
  expect_refused({"--model", "codeflow", "--set", "intensity"}, "--set = intensity: expected NAME=VALUE");
  expect_refused({"--model", "codeflow", "--set", "intensity=1", "--set", "intensity=2"}, "given twice");
  expect_refused({"--model", "hoffman_preetham", "--preset", "sunst"}, "did you mean sunset?");
  expect_refused({"--model", "codeflow", "--preset", "sunset"}, "codeflow.preset: unknown key");
  expect_refused({"--model", "codeflow", "--wavelengths", "8"}, "draws in red, green and blue");
  expect_refused({"--set", "intensity=1"}, "skyview.intensity: unknown key");
}

TEST(PublishedSky, takes_the_sun_of_a_preset) {
  const Folder folder;
  const Outcome outcome = run(folder, {"sky", "--model", "hoffman_preetham", "--preset", "sunset", "--size", "32x16",
                                       "-o", "a.png", "-o", "a.exr"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("elevation 6.00 degrees"), std::string::npos) << outcome.err;
}

TEST(PublishedScene, has_a_table_of_the_models_name) {
  const Folder folder;
  const auto scene = [&](const std::string& more) {
    write_file(folder / "s.toml",
               "[sun]\nelevation = 10\n[camera]\nwidth = 32\nheight = 18\n[picture]\nmodel = "
               "\"codeflow\"\n" +
                   more);
    return run(folder, {"render", "s.toml", "-o", "s.png"});
  };
  EXPECT_EQ(scene("[codeflow]\nvariant = \"repository\"\nkr = [0.2, 0.5, 0.7]\nintensity = 2\n").code, 0);
  const Outcome high = scene("[codeflow]\nintensity = 20\n");
  EXPECT_EQ(high.code, 2);
  EXPECT_NE(high.err.find("s.toml:9: codeflow.intensity = 20: expected 0 .. 10"), std::string::npos) << high.err;
  EXPECT_NE(scene("[codeflow]\nintensty = 2\n").err.find("did you mean intensity?"), std::string::npos);
  EXPECT_NE(scene("[relief]\nseed = 1\n").err.find("expected a scene without terrain and relief"), std::string::npos);
}

TEST(PublishedModels, list_their_parameters_and_presets) {
  const Folder folder;
  for (const json& model : json::parse(run(folder, {"models", "--json"}).out)) {
    if (model["name"] != "hoffman_preetham") continue;
    EXPECT_EQ(model["wavelengths"], (json::array({650, 570, 475})));
    EXPECT_EQ(model["presets"].size(), 4u);
    const auto& keys = model["parameters"];
    const auto g = std::ranges::find_if(keys, [](const json& key) { return key["name"] == "g"; });
    ASSERT_NE(g, keys.end());
    EXPECT_EQ((*g)["default"], -0.75);
    EXPECT_EQ((*g)["range"], (json::array({-0.999, 0.999})));
    return;
  }
  FAIL() << "hoffman_preetham is not listed";
}

TEST(PublishedScene, draws_land_with_what_the_command_line_says_instead) {
  const Folder folder;
  write_file(folder / "s.toml",
             "[sun]\nelevation = 10\n[camera]\nwidth = 32\nheight = 18\nheight_above_ground = 300\n[relief]\nseed = 1\n"
             "[picture]\nmodel = \"hoffman_preetham\"\nair_shadows = false\n[hoffman_preetham]\npreset = \"clear\"\n");
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"render", "s.toml", "-o", "s.exr"});
    return run(folder, words);
  };
  for (const char* renderer : {"vertex", "texture", "pixel"})
    EXPECT_EQ(render({"--set", std::string("renderer=") + renderer}).code, 0) << renderer;
  EXPECT_EQ(render({"--preset", "mars", "--aov", "all"}).code, 0);
  EXPECT_EQ(render({"--model", "jetlag"}).code, 0);
  const auto refused = [&](std::vector<std::string> words, const char* why) {
    const Outcome outcome = render(std::move(words));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
  };
  refused({"--set", "g=2"}, "hoffman_preetham.g = 2: expected -0.999 .. 0.999");
  refused({"--set", "show=wireframe"}, "sky alone");
  refused({"--aov", "spectral"}, "--aov spectral: model hoffman_preetham draws in red, green and blue");
  refused({"--model", "codeflow"}, "expected a scene without terrain and relief");
}

TEST(PublishedProbe, answers_in_red_green_and_blue) {
  const Folder folder;
  // G1.17 and G1.15 of the specification: 45 degrees above the horizon towards the sun, whose zenith angle is 30 degrees.
  const Outcome outcome = run(folder, {"probe", "--model", "hoffman_preetham", "--set", "sunlight=dome",
                                       "--sun-elevation", "60", "--view-zenith", "45", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json answer = json::parse(outcome.out);
  const double expected[] = {0.0259282, 0.0292621, 0.0354699};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(answer["radiance"][c].get<double>(), expected[c], 3e-4 * expected[c]);
  EXPECT_EQ(answer["wavelengths"], (json::array({650, 570, 475})));
  EXPECT_EQ(answer["units"]["radiance"], "relative");
  EXPECT_GT(answer["sky_irradiance"][2].get<double>(), answer["sky_irradiance"][0].get<double>()) << "a blue sky";
  const json codeflow = json::parse(
      run(folder, {"probe", "--model", "codeflow", "--sun-elevation", "30", "--view-zenith", "45", "--json"}).out);
  EXPECT_FALSE(codeflow.contains("sun_irradiance")) << "it says nothing on that";
  EXPECT_NE(run(folder, {"probe", "--model", "jetlag", "--sun-elevation", "30"}).out.find("red"), std::string::npos);
  const auto refused = [&](std::vector<std::string> words, const char* why) {
    words.insert(words.begin(), {"probe", "--sun-elevation", "30"});
    const Outcome bad = run(folder, words);
    EXPECT_EQ(bad.code, 2);
    EXPECT_NE(bad.err.find(why), std::string::npos) << bad.err;
  };
  refused({"--model", "codeflow", "--wavelengths", "550"}, "answers in red, green and blue");
  refused({"--model", "rama", "--max-order", "1"}, "--max-order = 1");
  refused({"--set", "g=0"}, "model skyview has no parameters");
}

}  // namespace
}  // namespace airlight
