// Wrong words on the command line: exit code 2, a message that names option, value and what is legal, and no file left.
#include <gtest/gtest.h>

#include "run_program.h"

namespace airlight {
namespace {

struct Bad {
  std::vector<std::string> arguments;
  std::vector<std::string> fragments;  ///< that the message must hold
};

/// `sky` with a sun and an output, and more words.
std::vector<std::string> sky(std::vector<std::string> more) {
  std::vector<std::string> words{"sky", "--sun-elevation", "30", "--size", "8x4", "-o", "x.exr"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}
std::vector<std::string> sun(const std::string& elevation) {
  return {"sky", "-o", "x.exr", "--sun-elevation", elevation};
}
std::vector<std::string> output(const std::string& file) {
  return {"sky", "--sun-elevation", "30", "--size", "8x4", "-o", file};
}
std::vector<std::string> size(const std::string& sides) {
  return {"sky", "--sun-elevation", "30", "-o", "x.exr", "--size", sides};
}
std::vector<std::string> at(const std::string& place, const std::string& time) {
  return {"sky", "-o", "x.exr", "--place", place, "--time", time};
}
std::vector<std::string> probe_words(std::vector<std::string> more) {
  more.insert(more.begin(), {"probe", "--sun-elevation", "30"});
  return more;
}

const std::vector<Bad>& bad_words() {
  static const std::vector<Bad> table{
      {{}, {"Usage", "sky", "probe"}},
      {{"sunset"}, {"airlight: sunset: unknown command", "airlight --help"}},
      {{"planet"}, {"planet: unknown command; did you mean planets?"}},
      {{"--verbose"}, {"--verbose: unknown option; a command comes first"}},
      {{"help", "skyy"}, {"airlight: skyy: unknown command; did you mean sky?", "airlight --help"}},
      {{"help", "nosuch"}, {"airlight: nosuch: unknown command"}},
      {{"help", "help"}, {"airlight: help: unknown command"}},
      {{"help", "--json"}, {"--json: unknown option; a command comes first"}},
      {{"help", "sky", "nonsense"}, {"airlight: help: 'nonsense': one word more than expected"}},
      {{"help", "planets", "mars"}, {"airlight: help: 'mars': one word more than expected"}},
      {{"skyy", "--help"}, {"airlight: skyy: unknown command; did you mean sky?"}},
      {{"sky", "--sun-elevation", "30"}, {"--output", "required"}},
      {{"sky", "-o", "x.exr"}, {"--place", "--time", "--sun-elevation"}},
      {sky({"--tint", "blue"}), {"airlight sky: --tint: unknown option", "airlight sky --help"}},
      {{"sky", "--sun_elevation", "30"}, {"--sun_elevation: unknown option; did you mean --sun-elevation?"}},
      {sky({"--sun-azimut=3"}), {"--sun-azimut: unknown option; did you mean --sun-azimuth?"}},
      {{"sky", "-o", "x.exr", "--place", "46.6,", "7.9", "--time", "2026-03-20T17:08Z"}, {"'7.9'", "quotes"}},
      {sky({"--projection", "fish"}), {"did you mean fisheye?"}},
      {{"planets", "mars"}, {"did you mean mars-clear?"}},
      // numbers
      {sun("nan"), {"--sun-elevation = nan", "-90 .. 90 degrees"}},
      {sun("inf"), {"--sun-elevation = inf", "-90 .. 90 degrees"}},
      {sun("1e999"), {"--sun-elevation = 1e999", "-90 .. 90 degrees"}},
      {sun("91"), {"--sun-elevation = 91", "-90 .. 90 degrees"}},
      {sun("ten"), {"--sun-elevation = ten", "-90 .. 90 degrees"}},
      {sun("30x"), {"--sun-elevation = 30x"}},
      {sun(""), {"--sun-elevation"}},
      {sky({"--sun-azimuth", "361"}), {"--sun-azimuth = 361", "-360 .. 360 degrees"}},
      {sky({"--altitude", "-1e9"}), {"--altitude = -1e9", "m"}},
      {sky({"--altitude"}), {"--altitude"}},
      // place and time
      {{"sky", "-o", "x.exr", "--place", "46.6,7.9"}, {"--place", "--time"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--light", "elevation = 3, azimut = 1"},
       {"--light", "did you mean", "azimuth"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--light", "body = \"moon\""}, {"--light", "elevation"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--light", "elevation ="}, {"--light = elevation =: expected"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--light", "moon"},
       {"--light = moon: expected keys with values, as 'body = \"moon\"'"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--light", "body = \"moon\", time = \"2026-01-03T23:00Z\""},
       {"--light", "place"}},
      {{"sky", "--model", "codeflow", "--sun-elevation", "30", "-o", "x.exr", "--light", "elevation = 3"},
       {"codeflow", "one light"}},
      {{"sky", "-o", "x.exr", "--time", "2026-06-21T18:40Z"}, {"--time", "--place"}},
      {sky({"--place", "46.6,7.9", "--time", "2026-06-21T18:40Z"}), {"--place", "--sun-elevation"}},
      {sky({"--refraction"}), {"--refraction", "--place"}},
      {at("91,0", "2026-06-21T18:40Z"), {"91,0", "-90"}},
      {at("46.6", "2026-06-21T18:40Z"), {"46.6"}},
      {at("46.6,7.9,3", "2026-06-21T18:40Z"), {"46.6,7.9,3"}},
      {at("nan,0", "2026-06-21T18:40Z"), {"nan,0"}},
      {at("46.6,7.9", "yesterday"), {"yesterday"}},
      {at("46.6,7.9", "2026-13-21T18:40Z"), {"2026-13-21T18:40Z"}},
      {at("46.6,7.9", "2026-06-21T18:40"), {"2026-06-21T18:40"}},
      // names
      {sky({"--planet", "erth"}), {"erth", "did you mean", "earth"}},
      {sky({"--planet", "nowhere.toml"}), {"nowhere.toml"}},
      {sky({"--model", "skyveiw"}), {"--model = skyveiw", "did you mean", "skyview"}},
      {sky({"--engine", "sidm"}), {"sidm", "did you mean", "simd"}},
      {sky({"--projection", "fishye"}), {"--projection = fishye", "did you mean", "fisheye"}},
      {sky({"--tone", "filmik"}), {"--tone = filmik", "did you mean", "filmic"}},
      // air
      {sky({"--ozone", "-1"}), {"--ozone = -1", "Dobson"}},
      {sky({"--aerosol-optical-depth", "nan"}), {"--aerosol-optical-depth = nan", "0 .. 100"}},
      {sky({"--planet", "mars-clear", "--ozone", "300"}), {"ozone", "mars-clear"}},
      // camera and picture
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--size", "0x4"}, {"--size = 0", "1 .. 65536 pixels"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--size", "2.5"}, {"--size = 2.5", "whole"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--size", "1e9"}, {"--size = 1e9"}},
      {size("4x4x4"), {"--size = 4x4x4: expected 1 .. 65536 pixels a side, WIDTHxHEIGHT or one number"}},
      {size("8,4"), {"--size = 8,4: expected 1 .. 65536 pixels a side, WIDTHxHEIGHT or one number"}},
      {size("8x"), {"--size = 8x: expected 1 .. 65536 pixels a side, WIDTHxHEIGHT or one number"}},
      {size("X8"), {"--size = X8: expected 1 .. 65536 pixels a side, WIDTHxHEIGHT or one number"}},
      {size("x"), {"--size = x: expected 1 .. 65536 pixels a side, WIDTHxHEIGHT or one number"}},
      {{"sky", "--sun-elevation", "30", "-o", "x.exr", "--size", "8x4", "--projection", "cube"},
       {"--size = 8x4", "square"}},
      {sky({"--projection", "perspective", "--field-of-view", "180"}), {"--field-of-view", "180", "170"}},
      {sky({"--exposure", "bright"}), {"--exposure = bright", "EV"}},
      {sky({"--exposure", "nan"}), {"--exposure = nan", "EV"}},
      {sky({"--wavelengths", "700,400"}), {"--wavelengths = 700,400", "increasing"}},
      {sky({"--wavelengths", "8", "--sensor", "no_such.csv"}), {"no_such.csv"}},
      {sky({"--model", "codeflow", "--spectral"}), {"codeflow", "red, green and blue"}},
      {sky({"--wavelengths", "5"}), {"--wavelengths = 5"}},
      {sky({"--wavelengths", "300:900:200"}), {"300", "360", "830"}},
      {output("x.jpg"), {"x.jpg", ".exr", ".hdr", ".png"}},
      {output("missing/x.exr"), {"missing"}},
      {output("/proc/x.exr"), {"/proc"}},
      {sky({"-o", "x.exr"}), {"-o", "twice"}},
      // probe
      {{"probe"}, {"--sun-elevation"}},
      {probe_words({"--view-zenith", "200"}), {"--view-zenith = 200", "0 .. 180 degrees"}},
      {probe_words({"--wavelengths", "900"}), {"900", "360", "830"}},
      {probe_words({"--wavelengths", "440,,550"}), {"--wavelengths"}},
      {probe_words({"--wavelengths", "700:400:50"}), {"700:400:50"}},
      {probe_words({"--distance", "-1"}), {"--distance = -1"}},
      {probe_words({"--max-order", "1.5"}), {"--max-order = 1.5", "whole"}},
      {{"probe", "--batch", "missing.jsonl"}, {"missing.jsonl"}},
      {{"probe", "--batch", "."}, {"folder"}},
      {{"probe", "--batch", "-", "--view-zenith", "3"}, {"--batch", "--view-zenith"}},
      {{"probe", "--batch", "-", "--model", "nishita"}, {"--model = nishita", "single", "skyview"}},
      {probe_words({"-o", "missing/x.txt"}), {"missing"}},
      // eval and the lists
      {{"eval", "--engine", "dobule"}, {"dobule", "did you mean", "double"}},
      {{"eval", "--json"}, {"--list"}},
      {{"planets", "maars-clear"}, {"maars-clear", "did you mean", "mars-clear"}},
      {{"planets", "earth", "--json"}, {"--json"}},
      {{"models", "single"}, {"single"}},
  };
  return table;
}

TEST(BadUsage, exit_code_2_a_message_that_names_the_trouble_and_no_file) {
  for (const auto& [arguments, fragments] : bad_words()) {
    std::string words = "airlight";
    for (const auto& argument : arguments) words += ' ' + argument;
    SCOPED_TRACE(words);
    const Folder folder;
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& fragment : fragments)
      EXPECT_NE(outcome.err.find(fragment), std::string::npos) << "no \"" << fragment << "\" in: " << outcome.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(BadUsage, atmosphere_files_are_named_with_line_key_and_value) {
  struct BadFile {
    std::string text, fragment;
  };
  const std::string sun = "[sun]\nirradiance = 1.5\n";
  for (const auto& [text, fragment] : {
           BadFile{"[planet\n", "air.toml:1"},
           BadFile{"[planet]\nground_radius = -3.0\ntop_altitude = 60000.0\n" + sun,
                   "air.toml:2: planet.ground_radius = -3"},
           BadFile{"[planet]\nground_radius = nan\ntop_altitude = 60000.0\n" + sun,
                   "air.toml:2: planet.ground_radius = nan"},
           BadFile{"[planet]\nground_radius = 6360000.0\ntop_altitude = -1.0\n" + sun,
                   "air.toml:3: planet.top_altitude = -1"},
           BadFile{"[planet]\nground_radus = 6360000.0\ntop_altitude = 60000.0\n" + sun, "ground_radius"},
       }) {
    SCOPED_TRACE(text);
    const Folder folder;
    write_file(folder / "air.toml", text);
    const Outcome outcome = run(folder, {"sky", "--planet", "air.toml", "--sun-elevation", "30", "-o", "x.exr"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"air.toml"});
  }
}

TEST(BadUsage, an_instruction_set_that_does_not_exist_is_refused) {
  const Folder folder;
  const Outcome outcome = run(folder, {"probe", "--sun-elevation", "30"}, {.environment = {"AIRLIGHT_ISA=avx9"}});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("AIRLIGHT_ISA"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("avx9"), std::string::npos) << outcome.err;
}

TEST(BadUsage, help_is_no_error_and_states_units_and_ranges) {
  const Folder folder;
  for (const char* command : {"sky", "probe", "eval", "models", "planets", "doctor"}) {
    const Outcome outcome = run(folder, {command, "--help"});
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_EQ(outcome.err, "") << command;
  }
  const std::string help = run(folder, {"sky", "--help"}).out;
  EXPECT_EQ(run(folder, {"help", "sky"}).out, help);
  EXPECT_EQ(run(folder, {"help"}).out, run(folder, {"--help"}).out);
  for (const char* text : {"[degrees, -90 .. 90]", "Dobson units", "pixels", "[m, ", "[nm]", "EV"})
    EXPECT_NE(help.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace airlight
