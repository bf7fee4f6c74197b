// `airlight probe --batch`.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "run_program.h"

namespace airlight {
namespace {

using nlohmann::json;

const json example = json::parse(
    R"({"id":"a","atmosphere":"earth-bruneton","model":"single","quantity":"radiance","altitude":0,"view_zenith":80,"view_azimuth":0,
        "sun_zenith":60,"sun_azimuth":0,"distance":null,"wavelengths":[440,550,680]})");

json with(json line, const json& changes) {
  line.update(changes);
  return line;
}

std::string lines(const std::vector<json>& objects) {
  std::string text;
  for (const json& object : objects) text += object.dump() + '\n';
  return text;
}

Outcome batch(const std::string& input, std::vector<std::string> more = {}) {
  const Folder folder;
  more.insert(more.begin(), {"probe", "--batch", "-"});
  return run(folder, more, {.input = input});
}

/// The one number that a line is answered with.
double number(const json& answer) { return answer.at("value").at(0).get<double>(); }

TEST(Batch, answers_every_quantity) {
  std::vector<json> questions;
  for (const char* quantity : {"radiance", "path_radiance", "transmittance", "sun_irradiance", "sky_irradiance"})
    questions.push_back(with(example, {{"id", quantity}, {"quantity", quantity}}));
  for (const char* quantity : {"luminance", "sun_illuminance", "sky_illuminance", "global_illuminance"}) {
    questions.push_back(with(example, {{"id", quantity}, {"quantity", quantity}}));
    questions.back().erase("wavelengths");
  }
  const Outcome outcome = batch(lines(questions));
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), questions.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i]["id"], questions[i]["id"]);
    EXPECT_EQ(answers[i]["value"].size(), i < 5 ? 3u : 1u);
    for (const json& value : answers[i]["value"]) EXPECT_GT(value.get<double>(), 0) << answers[i];
  }
  // The ray meets no ground, so nothing but air shines along it.
  EXPECT_EQ(answers[0]["value"], answers[1]["value"]);
  for (const json& transmittance : answers[2]["value"]) EXPECT_LT(transmittance.get<double>(), 1);
  // Sun 30 degrees up: sky plus half of the sun. 1e-12: rounding of sin 30 degrees.
  EXPECT_NEAR(number(answers[8]) / (number(answers[7]) + 0.5 * number(answers[6])), 1, 1e-12);
  // Bright daylight, not watts or kilolux.
  EXPECT_GT(number(answers[8]), 2e4);
  EXPECT_LT(number(answers[8]), 1e5);
}

TEST(Batch, keeps_the_order_across_chunks_and_topics) {
  std::vector<json> questions;
  for (int i = 0; i < 9000; ++i)  // more than one chunk
    questions.push_back(with(example, {{"id", i},
                                       {"quantity", "transmittance"},
                                       {"view_zenith", i % 90},
                                       {"wavelengths", i % 3 == 0 ? json{550} : json{440, 680}}}));
  const Outcome outcome = batch(lines(questions));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), questions.size());
  for (int i = 0; i < 9000; ++i) {
    ASSERT_EQ(answers[i]["id"], i);
    ASSERT_EQ(answers[i]["value"].size(), i % 3 == 0 ? 1u : 2u);
    ASSERT_EQ(answers[i]["value"], answers[i % 90]["value"]) << "answered together or apart, the same";
  }
}

TEST(Batch, bad_lines_get_errors_and_the_rest_is_answered) {
  const std::string text = lines({example, with(example, {{"id", "b"}, {"wavelengths", {100}}})}) +
                           "{\"id\":\"c\",\n\n" +
                           lines({with(example, {{"id", "d"}, {"model", "singel"}}),
                                  with(example, {{"id", "e"}, {"atmosphere", "nowhere.toml"}}),
                                  with(example, {{"id", "f"}, {"view_zenth", 3}}), with(example, {{"id", "g"}})});
  const Outcome outcome = batch(text);
  EXPECT_EQ(outcome.code, 1);
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), 7u);
  const char* const fragments[] = {
      "", "standard input:2", "standard input:3", "did you mean single?", "nowhere.toml", "did you mean view_zenith?",
      ""};
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(answers[i]["id"], std::string(1, char('a' + i)));
    if (*fragments[i])
      EXPECT_NE(answers[i].at("error").get<std::string>().find(fragments[i]), std::string::npos) << answers[i];
    else
      EXPECT_TRUE(answers[i].contains("value")) << answers[i];
  }
  EXPECT_NE(answers[1]["error"].get<std::string>().find("360"), std::string::npos) << "the legal range: " << answers[1];
  EXPECT_EQ(answers[0]["value"], answers[6]["value"]) << "a bad line among them changes nothing";
}

TEST(Batch, wavelengths_of_a_luminance_default_to_forty) {
  json forty = json::array();
  for (int nm = 385; nm <= 775; nm += 10) forty.push_back(nm);
  auto without = with(example, {{"quantity", "luminance"}});
  without.erase("wavelengths");
  const auto answers = json_lines(batch(lines({without, with(without, {{"wavelengths", forty}})})).out);
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0]["value"], answers[1]["value"]);
}

TEST(Batch, options_fill_in_for_lines_that_name_no_air_or_model) {
  auto bare = with(example, {{"quantity", "transmittance"}, {"view_zenith", 0}});
  const auto named = json_lines(batch(lines({with(bare, {{"atmosphere", "mars-clear"}})})).out);
  bare.erase("atmosphere");
  bare.erase("model");
  const auto filled = json_lines(batch(lines({bare}), {"--planet", "mars-clear", "--model", "single"}).out);
  EXPECT_EQ(named, filled);

  // T = exp(-depth): what the aerosol adds at 550 nm straight up is its optical depth.
  const auto clear = json_lines(batch(lines({bare}), {"--aerosol-optical-depth", "0"}).out);
  const auto hazy = json_lines(batch(lines({bare}), {"--aerosol-optical-depth", "0.4"}).out);
  // 1e-3: the tables are single precision and the aerosol ends at the top of the air.
  EXPECT_NEAR(std::log(clear[0]["value"][1].get<double>() / hazy[0]["value"][1].get<double>()), 0.4, 1e-3);
}

TEST(Batch, parameters_are_those_of_the_model_that_is_named_beside_them) {
  const json fast = with(example, {{"atmosphere", "earth"}, {"model", "precomputed"}}),
             exact = with(fast, {{"model", "single"}});
  const std::vector<std::string> draft{"--model", "precomputed", "--set", "detail=draft"};
  const auto answers = json_lines(batch(lines({fast, exact}), draft).out);
  const auto few =
      json_lines(batch(lines({fast}), {"--model", "precomputed", "--set", "detail=draft", "--set", "panels=3"}).out);
  EXPECT_EQ(answers[1]["value"], json_lines(batch(lines({exact})).out)[0]["value"]);
  EXPECT_GT(number(answers[0]), 1.05 * number(answers[1])) << "all orders and one";
  EXPECT_NE(number(few[0]), number(answers[0]));
  EXPECT_NEAR(number(few[0]) / number(answers[0]), 1, 0.05);

  const Outcome bad = batch(lines({fast}), {"--model", "precomputed", "--set", "panels=1"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_NE(bad.err.find("3 .. 64"), std::string::npos) << bad.err;
  EXPECT_EQ(batch(lines({fast}), {"--model", "codeflow", "--set", "g=0"}).code, 2);
}

TEST(Batch, published_systems_answer_in_red_green_and_blue_of_their_own) {
  for (const char* model : {"codeflow", "hoffman_preetham", "jetlag", "realworldz", "rama"}) {
    json question = with(example, {{"model", model}, {"atmosphere", "earth"}, {"quantity", "radiance"}});
    question.erase("wavelengths");
    const auto answers = json_lines(batch(lines({question})).out);
    ASSERT_EQ(answers.size(), 1u) << model;
    ASSERT_TRUE(answers[0].contains("value")) << model << ": " << answers[0];
    ASSERT_EQ(answers[0]["value"].size(), 3u) << model;
    const auto ask = [&](const char* key) { return std::to_string(question[key].get<double>()); };
    const Folder folder;
    const Outcome one = run(folder, {"probe", "--json", "--model", model, "--altitude", ask("altitude"),
                                     "--view-zenith", ask("view_zenith"), "--view-azimuth", ask("view_azimuth"),
                                     "--sun-elevation", std::to_string(90 - question["sun_zenith"].get<double>())});
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(answers[0]["value"], json::parse(one.out)["radiance"]) << model;
  }
}

TEST(Batch, a_segment_of_no_length_is_empty) {
  const auto answers = json_lines(batch(lines({with(example, {{"distance", 0}, {"quantity", "transmittance"}}),
                                               with(example, {{"distance", 0}, {"quantity", "path_radiance"}})}))
                                      .out);
  ASSERT_EQ(answers.size(), 2u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(answers[0].at("value")[i], 1.0);
    EXPECT_EQ(answers[1].at("value")[i], 0.0);
  }
}

TEST(Batch, reads_and_replaces_one_and_the_same_file) {
  const Folder folder;
  write_file(folder / "all.jsonl", lines({example}));
  EXPECT_EQ(run(folder, {"probe", "--batch", "all.jsonl", "-o", "all.jsonl"}).code, 0);
  const auto answers = json_lines(read_file(folder / "all.jsonl"));
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_TRUE(answers[0].contains("value"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"all.jsonl"});
}

/// Writes to a pipe and waits until a file is there. @returns whether it came within 20 s
bool write_and_await(int pipe, const std::string& text, const std::string& file) {
  if (write(pipe, text.data(), text.size()) != ssize_t(text.size())) return false;
  for (int i = 0; i < 1000; ++i) {
    std::error_code none;
    if (std::filesystem::file_size(file, none) > 0 && !none) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST(Batch, an_interrupt_keeps_what_is_answered_beside_the_old_file) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder / "in.jsonl").c_str(), 0600), 0);
  write_file(folder / "out.jsonl", "precious");
  Program program(folder, {"probe", "--batch", "in.jsonl", "-o", "out.jsonl"});
  const int pipe = open((folder / "in.jsonl").c_str(), O_WRONLY);
  ASSERT_GE(pipe, 0);
  ASSERT_TRUE(write_and_await(pipe, lines({example, example}), folder / "out.jsonl.partial"));
  program.signal(SIGINT);
  const Outcome outcome = program.wait(10);
  close(pipe);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_NE(outcome.err.find("the first 2 answers are in out.jsonl.partial"), std::string::npos) << outcome.err;
  EXPECT_EQ(json_lines(read_file(folder / "out.jsonl.partial")).size(), 2u);
  EXPECT_EQ(read_file(folder / "out.jsonl"), "precious");

  // The next run that ends well leaves neither the rest nor the old file.
  write_file(folder / "again.jsonl", lines({example}));
  EXPECT_EQ(run(folder, {"probe", "--batch", "again.jsonl", "-o", "out.jsonl"}).code, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"again.jsonl", "in.jsonl", "out.jsonl"}));
  EXPECT_EQ(json_lines(read_file(folder / "out.jsonl")).size(), 1u);
}

TEST(Batch, reads_and_replaces_what_an_interrupt_left) {
  const Folder folder;
  write_file(folder / "a.partial", lines({example}));
  EXPECT_EQ(run(folder, {"probe", "--batch", "a.partial", "-o", "a"}).code, 0);
  EXPECT_EQ(json_lines(read_file(folder / "a")).size(), 1u);
}

TEST(Batch, a_full_disk_keeps_whole_lines) {
  const Folder folder;
  write_file(folder / "in.jsonl", lines(std::vector<json>(2000, example)));
  const Outcome outcome = run(folder, {"probe", "--batch", "in.jsonl", "-o", "out.jsonl"}, {.file_size_limit = 20000});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("out.jsonl.partial"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"in.jsonl", "out.jsonl.partial"}));
  const std::string kept = read_file(folder / "out.jsonl.partial");
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(kept.back(), '\n');
  for (const json& answer : json_lines(kept)) EXPECT_EQ(answer["id"], "a");
}

TEST(Batch, a_device_is_written_at_once) {
  const Folder folder;
  const Outcome outcome = run(folder, {"probe", "--batch", "-", "-o", "/dev/stdout"}, {.input = lines({example})});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(json_lines(outcome.out).size(), 1u);
  EXPECT_TRUE(folder.names().empty());
}

#ifdef AIRLIGHT_WITH_REFERENCE
// A model whose tables are single precision, and the quadrature that it is judged by: the accuracy that
// docs/accuracy.md states for rays by day, with room.
TEST(Batch, the_reference_answers_like_the_model_that_it_judges) {
  std::vector<json> questions;
  for (const char* quantity :
       {"radiance", "path_radiance", "transmittance", "sun_irradiance", "luminance", "sun_illuminance"})
    for (const char* model : {"single", "reference-single"}) {
      // Down to the ground, so that radiance and path radiance differ.
      questions.push_back(with(example, {{"quantity", quantity}, {"model", model}, {"altitude", 2000}}));
      questions.back()["view_zenith"] = 100;
    }
  const Outcome outcome = batch(lines(questions));
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), questions.size());
  for (std::size_t i = 0; i < answers.size(); i += 2)
    for (std::size_t w = 0; w < answers[i]["value"].size(); ++w)
      EXPECT_NEAR(answers[i]["value"][w].get<double>() / answers[i + 1]["value"][w].get<double>(), 1, 3e-3)
          << questions[i];
  EXPECT_GT(number(answers[0]), 1.02 * number(answers[2])) << "the ground shines";
}

const json slab = json::parse(
    R"({"model":"plane-parallel","quantity":"radiance","layers":[{"scattering_optical_depth":0.2,"phase":{"type":"rayleigh"}}],
        "view_zenith":57.43656,"sun_zenith":85.38596})");

// Problem 2b of DISORT (Stamnes et al. 1988), where the sun's irradiance is pi; cosines 0.538263 and 0.080442. 1e-3: its 16
// streams, as in tests/reference.
TEST(Batch, plane_parallel_air_gives_published_numbers) {
  const double pi = 3.141592653589793;
  const auto answers =
      json_lines(batch(lines({slab, with(slab, {{"observer", "space"}, {"view_zenith", 180 - 57.43656}}),
                              with(slab, {{"quantity", "sky_irradiance"}}), with(slab, {{"view_azimuth", 180}}),
                              with(slab, {{"view_azimuth", 250}, {"sun_azimuth", 70}})}))
                     .out);
  ASSERT_EQ(answers.size(), 5u);
  EXPECT_NEAR(number(answers[0]) * pi / 4.64061e-2, 1, 1e-3);
  EXPECT_NEAR(number(answers[1]) * pi / 4.87120e-2, 1, 1e-3);
  EXPECT_NEAR(number(answers[2]) * pi / 1.06123e-1, 1, 1e-3);
  // Only the difference of azimuths counts. 1e-12: rounding.
  EXPECT_NEAR(number(answers[3]) / number(answers[4]), 1, 1e-12);
  EXPECT_LT(number(answers[3]), 0.99 * number(answers[0])) << "brighter towards the sun";
}

TEST(Batch, a_thousand_views_of_a_slab_cost_little_more_than_one) {
  std::vector<json> questions;
  for (int i = 0; i < 1000; ++i)
    questions.push_back(with(slab, {{"id", i}, {"view_zenith", 0.09 * i}, {"view_azimuth", i % 360}}));
  const auto start = std::chrono::steady_clock::now();
  const auto answers = json_lines(batch(lines(questions)).out);
  // Half a second on an idle machine; a thousand solutions would be 20.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));
  ASSERT_EQ(answers.size(), 1000u);
  for (const json& answer : answers) EXPECT_GT(number(answer), 0) << answer;
}

TEST(Batch, plane_parallel_air_says_what_it_cannot_answer) {
  const auto answers = json_lines(
      batch(lines({with(slab, {{"quantity", "luminance"}}),
                   with(slab, {{"quantity", "sky_irradiance"}, {"observer", "space"}}), with(slab, {{"layers", 3}})}))
          .out);
  ASSERT_EQ(answers.size(), 3u);
  const char* const fragments[] = {"expected one of radiance, sky_irradiance", "sky_irradiance is that of the ground",
                                   "layers = 3"};
  for (int i = 0; i < 3; ++i)
    EXPECT_NE(answers[i].value("error", "").find(fragments[i]), std::string::npos) << answers[i];
  const Outcome alone = run(Folder(), {"probe", "--model", "plane-parallel", "--sun-elevation", "30"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_NE(alone.err.find("--batch"), std::string::npos) << alone.err;
}

TEST(Batch, the_reference_says_what_it_cannot_answer) {
  const json line = with(example, {{"model", "reference-single"}});
  const auto answers =
      json_lines(batch(lines({with(line, {{"quantity", "sky_irradiance"}}), with(line, {{"max_order", 2}}),
                              with(line, {{"wavelengths", {100}}}), with(line, {{"max_order", 1}})}))
                     .out);
  ASSERT_EQ(answers.size(), 4u);
  const char* const fragments[] = {"quantity = sky_irradiance: model reference-single does not compute it",
                                   "max_order = 2: expected 0 or 1", "expected 360 .. 830 nm"};
  for (int i = 0; i < 3; ++i)
    EXPECT_NE(answers[i].value("error", "").find(fragments[i]), std::string::npos) << answers[i];
  EXPECT_TRUE(answers[3].contains("value"));
}
// Random walks: the numbers of quadrature where one order is asked for, within their own errors; the same for a seed.
TEST(Batch, the_random_reference_states_its_errors) {
  const json walks = with(example, {{"model", "reference"}, {"atmosphere", "earth-bruneton"}, {"samples", 2048}});
  const json once = with(walks, {{"model", "reference-single"}, {"max_order", 1}});
  json exact = once;
  exact.erase("samples");
  const auto answers =
      json_lines(batch(lines({walks, walks, with(walks, {{"seed", 2}}), with(walks, {{"max_order", 1}}), exact,
                              with(walks, {{"quantity", "luminance"}}), with(walks, {{"quantity", "sky_irradiance"}}),
                              with(walks, {{"samples", 0.5}}), with(walks, {{"target_error", 2}}), once}))
                     .out);
  ASSERT_EQ(answers.size(), 10u);
  EXPECT_EQ(answers[0]["value"].size(), answers[0]["standard_error"].size());
  EXPECT_EQ(answers[0]["samples"], 2048);
  EXPECT_EQ(answers[0]["value"], answers[1]["value"]);
  const double value = number(answers[0]), error = answers[0]["standard_error"][0];
  EXPECT_NE(value, number(answers[2]));
  // Two runs of the same error differ by more than six of them once in 50000 pairs.
  EXPECT_NEAR(value, number(answers[2]), 6 * error);
  EXPECT_LT(error, 0.03 * value);
  // The first order is found by quadrature, with a tolerance of 1e-5.
  EXPECT_NEAR(number(answers[3]) / number(answers[4]), 1, 1e-4);
  EXPECT_GT(value, 1.05 * number(answers[4])) << "more than one order";
  EXPECT_EQ(answers[5]["standard_error"].size(), 1u);
  EXPECT_GT(number(answers[6]), 0);
  EXPECT_NE(answers[7].value("error", "").find("samples = 0.5"), std::string::npos) << answers[7];
  EXPECT_NE(answers[8].value("error", "").find("target_error = 2"), std::string::npos) << answers[8];
  EXPECT_NE(answers[9].value("error", "").find("samples"), std::string::npos) << "a key of reference alone";
}

#else
TEST(Batch, a_reference_that_is_not_built_in_says_so) {
  const auto answers = json_lines(batch(lines({with(example, {{"model", "reference-single"}})})).out);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_NE(answers[0].value("error", "").find("AIRLIGHT_WITH_REFERENCE"), std::string::npos) << answers[0];
}
#endif

TEST(Batch, nothing_in_nothing_out) {
  const Outcome outcome = batch("\n  \n");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
}

TEST(Batch, a_line_too_long_is_one_error) {
  const Outcome outcome = batch(std::string(3 << 20, 'x') + '\n' + lines({example}));
  EXPECT_EQ(outcome.code, 1);
  const auto answers = json_lines(outcome.out);
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_NE(answers[0].at("error").get<std::string>().find("longer"), std::string::npos);
  EXPECT_EQ(answers[1]["id"], "a");
}

}  // namespace
}  // namespace airlight
