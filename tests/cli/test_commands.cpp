// What the commands print.
#include <gtest/gtest.h>

#include <cmath>

#include "airlight/sky.h"
#include "run_program.h"
#include "scenefile/atmosphere_file.h"

namespace airlight {
namespace {

using nlohmann::json;

json probe(std::vector<std::string> more) {
  const Folder folder;
  more.insert(more.begin(), {"probe", "--json"});
  const Outcome outcome = run(folder, more);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Probe, table_and_json_say_the_same_with_units) {
  const std::vector<std::string> view{"--sun-elevation", "30", "--view-zenith", "60",
                                      "--view-azimuth",  "90", "--wavelengths", "550"};
  const json answer = probe(view);
  for (const char* quantity : {"radiance", "path_radiance", "transmittance", "sun_irradiance", "sky_irradiance"}) {
    ASSERT_EQ(answer.at(quantity).size(), 1u) << quantity;
    EXPECT_TRUE(answer.at("units").contains(quantity));
  }
  const Folder folder;
  auto words = view;
  words.insert(words.begin(), "probe");
  const Outcome table = run(folder, words);
  ASSERT_EQ(table.code, 0) << table.err;
  for (const char* quantity : {"luminance", "sun_illuminance", "sky_illuminance", "global_illuminance"}) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", answer.at(quantity).get<double>());
    EXPECT_NE(table.out.find(text), std::string::npos) << quantity << ' ' << text << " in\n" << table.out;
  }
  for (const char* unit : {"W m-2 sr-1 nm-1", "W m-2 nm-1", "cd m-2", "lx", "degrees"})
    EXPECT_NE(table.out.find(unit), std::string::npos) << unit;
}

TEST(Probe, agrees_with_the_batch) {
  const json answer = probe({"--sun-elevation", "20", "--sun-azimuth", "30", "--view-zenith", "70", "--view-azimuth",
                             "100", "--altitude", "500", "--distance", "2000", "--wavelengths", "440,680", "--planet",
                             "earth-bruneton", "--model", "single"});
  const Folder folder;
  const Outcome batch = run(
      folder, {"probe", "--batch", "-"},
      {.input =
           R"({"id":1,"atmosphere":"earth-bruneton","model":"single",)"
           R"("quantity":"radiance","altitude":500,"view_zenith":70,"view_azimuth":100,"sun_zenith":70,"sun_azimuth":30,)"
           R"("distance":2000,"wavelengths":[440,680]})"});
  EXPECT_EQ(json_lines(batch.out).at(0).at("value"), answer.at("radiance"));
}

TEST(Probe, sunlight_follows_the_distance_of_the_day) {
  // Earth is nearest to the sun in early January, farthest in early July: 0.983 and 1.017 au.
  std::vector<double> irradiance, distance;
  for (const char* time : {"2026-01-04T12:00Z", "2026-07-05T12:00Z"}) {
    const json answer = probe({"--place", "0,0", "--time", time, "--altitude", "1e6", "--wavelengths", "550"});
    irradiance.push_back(answer.at("sun_irradiance").at(0));
    distance.push_back(answer.at("sun_distance"));
  }
  EXPECT_NEAR(distance[0], 0.983, 0.001);
  EXPECT_NEAR(distance[1], 1.017, 0.001);
  // Above the air nothing else changes; 1e-6: single precision.
  EXPECT_NEAR(irradiance[0] / irradiance[1] * std::pow(distance[0] / distance[1], 2), 1, 1e-6);
}

TEST(Probe, refraction_lifts_the_sun_only_when_asked) {
  const std::vector<std::string> sunset{"--place", "46.6,7.9", "--time", "2026-03-20T17:38Z"};
  const json plain = probe(sunset);
  auto words = sunset;
  words.push_back("--refraction");
  const json lifted = probe(words);
  EXPECT_EQ(plain.at("refraction"), false);
  EXPECT_EQ(lifted.at("refraction"), true);
  const double lift = lifted.at("sun_elevation").get<double>() - plain.at("sun_elevation").get<double>();
  EXPECT_GT(lift, 0.4);  // the standard lift is 0.57 degrees at the horizon, and less above
  EXPECT_LT(lift, 0.7);
}

TEST(Probe, southern_places_are_no_options) {
  const json answer = probe({"--place", "-33.9,18.4", "--time", "2026-12-21T10:30Z"});
  EXPECT_GT(answer.at("sun_elevation").get<double>(), 70);  // Cape Town near noon at its summer solstice
}

TEST(Models, are_listed) {
  const Folder folder;
  const Outcome text = run(folder, {"models"});
  EXPECT_EQ(text.code, 0);
  const json list = json::parse(run(folder, {"models", "--json"}).out);
  ASSERT_EQ(list.size(), models().size());
  for (const json& model : list) EXPECT_NE(text.out.find(model.at("name").get<std::string>()), std::string::npos);
}

TEST(Planets, print_toml_that_reads_back_to_the_same_air) {
  const Folder folder;
  const json list = json::parse(run(folder, {"planets", "--json"}).out);
  ASSERT_EQ(list.size(), built_in_atmospheres().size());
  for (const json& planet : list) {
    const std::string name = planet.at("name");
    const Outcome toml = run(folder, {"planets", name});
    ASSERT_EQ(toml.code, 0) << toml.err;
    EXPECT_EQ(parse_atmosphere(toml.out, name + ".toml"), built_in_atmosphere(name)) << name;
  }
  const Outcome thin = run(folder, {"planets", "earth", "--ozone", "250"});
  EXPECT_NE(thin.out.find("250"), std::string::npos);
}

TEST(Doctor, tells_what_this_machine_can_run) {
  const Folder folder;
  const json report = json::parse(run(folder, {"doctor", "--json"}).out);
  EXPECT_EQ(report.at("version"), std::string("airlight ") + AIRLIGHT_VERSION);
  EXPECT_GE(report.at("threads").get<int>(), 1);
  ASSERT_EQ(report.at("engines").size(), 3u);
  EXPECT_TRUE(report.at("engines")[0].at("works"));
  EXPECT_TRUE(report.at("engines")[1].at("works"));
  bool any = false;
  for (const json& set : report.at("instruction_sets")) any = any || set.at("available").get<bool>();
  EXPECT_TRUE(any);
  for (const json& data : report.at("data")) EXPECT_TRUE(data.at("found")) << data;
  const Outcome text = run(folder, {"doctor"});
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find(report.at("engines")[1].at("device").get<std::string>()), std::string::npos) << text.out;
  const Outcome broken = run(folder, {"doctor"}, {.environment = {"AIRLIGHT_ISA=avx9"}});
  EXPECT_EQ(broken.code, 1);
  EXPECT_NE(broken.out.find("avx9"), std::string::npos);
}

TEST(Version, is_printed) {
  const Folder folder;
  EXPECT_EQ(run(folder, {"--version"}).out, std::string("airlight ") + AIRLIGHT_VERSION + "\n");
}

}  // namespace
}  // namespace airlight
