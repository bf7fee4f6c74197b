// Every mistake gets a message that names file, line, key, value and what is legal.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "airlight/error.h"
#include "bad_lines.h"
#include "scenefile/atmosphere_file.h"

namespace airlight {
namespace {

// Each case changes one line of a good file, or adds one.
const std::vector<std::string> good{
    "[planet]",                                                   // 1
    "ground_radius = 6_371_000.0",                                // 2
    "top_altitude = 120_000.0",                                   // 3
    "albedo = 0.1",                                               // 4
    "[sun]",                                                      // 5
    "irradiance = { file = \"solar_irradiance.csv\" }",           // 6
    "angular_radius = 0.00465",                                   // 7
    "[[constituent]]",                                            // 8
    "name = \"haze\"",                                            // 9
    "profile = { type = \"exponential\", scale_height = 1500 }",  // 10
    "extinction = 1e-4",                                          // 11
    "single_scattering_albedo = 0.9",                             // 12
    "phase = { type = \"henyey-greenstein\", g = 0.7 }",          // 13
};

TEST(BadAtmospheres, the_good_one_is_good) { EXPECT_NO_THROW(parse_atmosphere(with_line(good, 0, ""), "air.toml")); }

TEST(BadAtmospheres, get_file_line_key_value_and_range) {
  const std::string table = "{ wavelengths = ";
  const std::vector<BadLine> cases{
      // values out of range
      {2, "ground_radius = -3", {"air.toml:2: ", "planet.ground_radius = -3: expected 1000 .. 1e+09 m"}},
      {2, "ground_radius = nan", {"air.toml:2: ", "planet.ground_radius = nan"}},
      {2, "ground_radius = inf", {"air.toml:2: ", "planet.ground_radius = inf"}},
      {3, "top_altitude = -1.0", {"air.toml:3: ", "planet.top_altitude = -1: expected 1 .. 1e+09 m above the ground"}},
      {4, "albedo = 1.01", {"air.toml:4: ", "planet.albedo = 1.01: expected 0 .. 1"}},
      {4, "albedo = -nan", {"air.toml:4: ", "planet.albedo"}},
      {4,
       "albedo = " + table + "[400, 500], values = [0.1, 1.2] }",
       {"air.toml:4: ", "planet.albedo.values[1] = 1.2: expected 0 .. 1"}},
      {6, "irradiance = -1", {"air.toml:6: ", "sun.irradiance = -1: expected 0 .. "}},
      {7, "angular_radius = 0", {"air.toml:7: ", "sun.angular_radius = 0: expected 1e-06 .. 1.5 rad"}},
      {7, "limb_darkening = 11", {"air.toml:7: ", "sun.limb_darkening = 11: expected 0 .. 10"}},
      {10,
       "profile = { type = \"exponential\", scale_height = -1500 }",
       {"air.toml:10: ", "constituent[0].profile.scale_height = -1500: expected 1 .. 1e+08 m"}},
      {10,
       "profile = { type = \"tent\", altitude = 2e4, half_width = 0 }",
       {"air.toml:10: ", "profile.half_width = 0"}},
      {10,
       "profile = { type = \"layers\", layers = [{ bottom = 5, top = 5, density = 1 }] }",
       {"air.toml:10: ", "profile.layers[0].top = 5: expected more than the layer's bottom, 5 m"}},
      {10,
       "profile = { type = \"layers\", layers = [] }",
       {"air.toml:10: ", "profile.layers: 0 values: expected 1 .. 1000"}},
      {10,
       "profile = { type = \"table\", altitudes = [0, 2, 1], densities = [1, 1, 1] }",
       {"air.toml:10: ", "profile.altitudes[2] = 1 after 2: expected strictly increasing"}},
      {10,
       "profile = { type = \"table\", altitudes = [0, 2], densities = [1, -1] }",
       {"air.toml:10: ", "profile.densities[1] = -1: expected 0 .. "}},
      {10,
       "profile = { type = \"table\", altitudes = [0, 2], densities = [1] }",
       {"air.toml:10: ", "profile.densities: 1 values: expected 2, as many as altitudes"}},
      {11, "extinction = -1e-4", {"air.toml:11: ", "constituent[0].extinction = -1e-04: expected 0 .. 1000 1/m"}},
      {11, "extinction = 1e4", {"air.toml:11: ", "constituent[0].extinction = 10000: expected 0 .. 1000 1/m"}},
      {11,
       "extinction = { type = \"power\", at = 0, value = 1, exponent = 1 }",
       {"air.toml:11: ", "extinction.at = 0: expected 1 .. "}},
      {11,
       "extinction = { type = \"angstrom\", at = 550, value = 1, exponent = 99 }",
       {"air.toml:11: ", "extinction.exponent = -99: expected -20 .. 20"}},
      {11,
       "extinction = { wavelengths = [400], values = [1], scale = -2 }",
       {"air.toml:11: ", "extinction.scale = -2"}},
      {12,
       "single_scattering_albedo = 1.5",
       {"air.toml:12: ", "constituent[0].single_scattering_albedo = 1.5: expected 0 .. 1"}},
      {13,
       "phase = { type = \"henyey-greenstein\", g = 1.0 }",
       {"air.toml:13: ", "constituent[0].phase.g = 1: expected -0.99 .. 0.99"}},
      {13,
       "phase = { type = \"double-henyey-greenstein\", g1 = 0.8, g2 = 0, weight = 2 }",
       {"air.toml:13: ", "phase.weight = 2: expected 0 .. 1"}},
      {13,
       "phase = { type = \"rayleigh\", depolarisation = -0.1 }",
       {"air.toml:13: ", "phase.depolarisation = -0.1: expected 0 .. 1"}},
      {13,
       "phase = { type = \"table\", angles = [0, 180], values = [1, 1] }",
       {"air.toml:13: ", "phase.angles[1] = 180: expected 0 .. 3.15 rad"}},
      {13,
       "phase = { type = \"table\", angles = [0.1, 3.14159265], values = [1, 1] }",
       {"air.toml:13: ", "phase.angles[0] = 0.1: expected 0 .. 0 rad"}},
      {13,
       "phase = { type = \"table\", angles = [0, 3.14159265], values = [0, 0] }",
       {"air.toml:13: ", "phase.values", "not all 0"}},
      // spectra
      {6,
       "irradiance = " + table + "[500, 400], values = [1, 1] }",
       {"air.toml:6: ", "sun.irradiance.wavelengths[1] = 400 after 500: expected strictly increasing"}},
      {6,
       "irradiance = " + table + "[400, 400], values = [1, 1] }",
       {"air.toml:6: ", "wavelengths[1] = 400 after 400"}},
      {6,
       "irradiance = " + table + "[], values = [] }",
       {"air.toml:6: ", "sun.irradiance.wavelengths: 0 values: expected 1 .. "}},
      {6,
       "irradiance = " + table + "[400, 500], values = [1] }",
       {"air.toml:6: ", "sun.irradiance.values: 1 values: expected 2"}},
      {6,
       "irradiance = " + table + "[400, 500, 601], values = [1, 1, 1], sampling = \"bins\" }",
       {"air.toml:6: ", "wavelengths[2] = 601: expected 600 nm, for bins are evenly spaced"}},
      {6,
       "irradiance = " + table + "[900, 950], values = [1, 1] }\nlimb_darkening = " + table +
           "[400, 500], values = [1, 1] }",
       {"air.toml:", "no wavelength lies inside the data of every spectrum"}},
      {6,
       "irradiance = { file = \"solar_iradiance.csv\" }",
       {"air.toml:6: ", "sun.irradiance.file = \"solar_iradiance.csv\": no such file beside air.toml",
        "solar_irradiance.csv"}},
      {6, "irradiance = { file = \"/\" }", {"expected a regular file"}},
      {6, "irradiance = { file = \"cie_1931_2deg.csv\" }", {"cie_1931_2deg.csv:2: ", "expected 2 numbers"}},
      {6,
       "irradiance = { file = \"solar_irradiance.csv\", sampling = \"points\" }",
       {"air.toml:6: ", "sun.irradiance.sampling = \"points\"; did you mean point?"}},
      {6,
       "irradiance = { type = \"column\", dobson = 3, cross_section = 1 }",
       {"air.toml:6: ", "only the absorption of a constituent"}},
      {11,
       "extinction = { type = \"powr\", at = 550, value = 1 }",
       {"air.toml:11: ", "constituent[0].extinction.type = \"powr\": unknown law; did you mean power?"}},
      {11,
       "extinction = { type = \"power\", at = 550, value = 1 }",
       {"air.toml:11: ", "constituent[0].extinction.exponent is missing"}},
      {11,
       "extinction = { type = \"product\", factors = [1e-5, { type = \"power\", at = 550, value = 1, exponent = 30 }] "
       "}",
       {"air.toml:11: ", "extinction.factors[1].exponent = 30"}},
      // keys and types
      {2, "ground_radus = 6e6", {"air.toml:1: ", "planet.ground_radius is missing"}},
      {4, "albdo = 0.1", {"air.toml:4: ", "planet.albdo: unknown key; did you mean albedo?"}},
      {1, "colour = 3\n[planet]", {"air.toml:1: ", "colour: unknown key; expected one of", "planet"}},
      {4,
       "albedo = \"white\"",
       {"air.toml:4: ", "planet.albedo: expected a number, { wavelengths, values }, { file }"}},
      {2, "ground_radius = \"6371 km\"", {"air.toml:2: ", "planet.ground_radius: expected a number, got a string"}},
      {2, "ground_radius = 2026-06-21", {"air.toml:2: ", "expected a number, got a date or time"}},
      {9, "name = 7", {"air.toml:9: ", "constituent[0].name: expected a string, got a number"}},
      {9, "name = \"\"", {"air.toml:9: ", "constituent[0].name: expected a name that is not empty"}},
      {10, "profile = 8000", {"air.toml:10: ", "constituent[0].profile: expected a table, got a number"}},
      {10, "profile = { scale_height = 8000 }", {"air.toml:10: ", "constituent[0].profile.type is missing"}},
      {10,
       "profile = { type = \"exponental\", scale_height = 8000 }",
       {"air.toml:10: ", "type = \"exponental\": unknown profile; did you mean exponential?"}},
      {10,
       "profile = { type = \"exponential\", scaleheight = 8000 }",
       {"air.toml:10: ", "constituent[0].profile.scale_height is missing"}},
      {10,
       "profile = { type = \"exponential\", scale_height = 8000, top = 3 }",
       {"air.toml:10: ", "constituent[0].profile.top: unknown key"}},
      {10,
       "profile = { type = \"table\", altitudes = [0, \"1\"], densities = [1, 1] }",
       {"air.toml:10: ", "profile.altitudes[1]: expected a number, got a string"}},
      {10,
       "profile = { type = \"layers\", layers = [3] }",
       {"air.toml:10: ", "profile.layers[0]: expected a table, got a number"}},
      {12,
       "",
       {"air.toml:8: ", "constituent[0]: expected either extinction and single_scattering_albedo, or scattering"}},
      {12,
       "single_scattering_albedo = 0.9\nabsorption = 1",
       {"air.toml:8: ", "constituent[0]: expected either extinction"}},
      {13, "", {"air.toml:8: ", "constituent[0].phase is missing"}},
      {13, "phase = { type = \"hg\", g = 0.7 }", {"air.toml:13: ", "unknown phase function; expected one of rayleigh"}},
      {13,
       good[12] + "\n[[constituent]]\nname = \"haze\"\nprofile = { type = \"us-standard-1976\" }\nabsorption = 0",
       {"air.toml:15: ", "constituent[1].name = \"haze\": expected a name not yet used"}},
      {13,
       good[12] + "\n[[constituent]]\nname = \"o3\"\nprofile = { type = \"tent\", altitude = 9e8, half_width = 1 "
                  "}\nabsorption = { type = \"column\", dobson = 300, cross_section = 1e-25 }",
       {"air.toml:17: ", "profile holds air"}},
      {4,
       "alb\xC3\xA9"
       "do = 1",
       {"air.toml:4: ", "expected ASCII outside quotes and comments"}},
      {4, "name = \"\xFF\"", {"air.toml:4: ", "expected UTF-8"}},
      {4, "albedo = { wavelengths = [400, }", {"air.toml:4: ", "'}' closes no '{'"}},
      {5, "[sun", {"air.toml:5: "}},
      {4, "albedo = ", {"air.toml:4: "}},
      {4, "albedo = 0.1\nalbedo = 0.2", {"air.toml:5: "}},
      {4, "name = \"\xC3\"", {"air.toml:4: ", "expected UTF-8"}},
      {4, "albedo = 0.1 \xff", {"air.toml:"}},
      {4, "albedo = " + std::string(1000, '['), {"air.toml:4: ", "expected at most 24 levels of nesting"}},
      {4,
       "a" +
           [] {
             std::string dots;
             for (int i = 0; i < 1000; ++i) dots += ".a";
             return dots;
           }() +
           " = 1",
       {"air.toml:4: ", "levels of nesting"}},
      {4,
       "a = [\"\"\"x\"\"\"\"\", {b" +
           [] {
             std::string dots;
             for (int i = 0; i < 100; ++i) dots += ".b";
             return dots;
           }() +
           " = 1}]",
       {"air.toml:4: ", "levels of nesting"}},
      {4, "a = 'caf\xC3\xA9'", {"air.toml:4: ", "expected ASCII in single quotes"}},
      {4, "a = \"caf\\\xC3\xA9\"", {"air.toml:4: ", "expected an escape behind a backslash"}},
      // bases and overrides
      {1, "base = \"erth\"\n[planet]", {"air.toml:1: ", "base = \"erth\": unknown atmosphere; did you mean earth?"}},
      {1,
       "ozone = 300\n[planet]",
       {"air.toml:1: ", "ozone: atmosphere air has no constituent \"ozone\" to change; it has haze"}},
      {1, "base = \"earth\"\nozone = -1\n[planet]", {"air.toml:2: ", "ozone = -1: expected 0 .. 10000 Dobson units"}},
      {1,
       "base = \"earth\"\naerosol_optical_depth = \"thick\"\n[planet]",
       {"air.toml:2: ", "aerosol_optical_depth: expected a number, got a string"}},
  };
  EXPECT_GE(cases.size(), 30u);
  expect_refused(good, cases, [](const std::string& text) { parse_atmosphere(text, "air.toml"); });
}

TEST(BadAtmospheres, empty_text_says_what_is_missing) {
  for (const char* text : {"", "\n\n", "# nothing"}) {
    try {
      parse_atmosphere(text, "air.toml");
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "air.toml:1: planet is missing");
    }
  }
}

}  // namespace
}  // namespace airlight
