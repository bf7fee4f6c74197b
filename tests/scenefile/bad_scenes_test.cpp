// Every mistake gets a message that names file, line, key, value and what is legal.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "airlight/error.h"
#include "bad_lines.h"
#include "scenefile/scene_file.h"

namespace airlight {
namespace {

// Each case changes one line of a good file, or adds some.
const std::vector<std::string> good_scene{
    "air = \"earth\"",         // 1
    "place = \"46.5,7.5\"",    // 2
    "[camera]",                // 3
    "type = \"perspective\"",  // 4
    "position = [0, 0]",       // 5
    "altitude = 3000",         // 6
    "field_of_view = 50",      // 7
    "[sun]",                   // 8
    "elevation = 10",          // 9
    "[[terrain]]",             // 10
    "file = \"a.tif\"",        // 11
    "[relief]",                // 12
    "height = 1000",           // 13
    "[surface]",               // 14
    "snow_line = 2000",        // 15
    "[picture]",               // 16
    "samples = 4",             // 17
};

TEST(BadScenes, the_good_one_is_good) { EXPECT_NO_THROW(parse_scene(with_line(good_scene, 0, ""), "s.toml")); }

TEST(BadScenes, get_file_line_key_value_and_range) {
  const std::vector<BadLine> cases{
      {1, "air = \"erth\"", {"s.toml:1: ", "air: ", "did you mean earth?"}},
      {1, "air = \"missing.toml\"", {"s.toml:1: ", "air: missing.toml: no such file"}},
      {1, "air = 3", {"s.toml:1: ", "air: expected a table, got a number"}},
      {1, "air = { aerosol_optical_depth = 1 }", {"s.toml:1: ", "air.base is missing"}},
      {1, "air = { base = \"earth\", ozone = -1 }", {"s.toml:1: ", "air.ozone: ", "expected 0 .. 10000"}},
      {1, "air = { base = \"earth\", ozon = 1 }", {"s.toml:1: ", "air.ozon: unknown key; did you mean ozone?"}},
      {1, "camra = 1", {"s.toml:1: ", "camra: unknown key; did you mean camera?"}},
      {2, "place = \"46.5\"", {"s.toml:2: ", "place: "}},
      {2, "place = \"146.5,7\"", {"s.toml:2: ", "place: ", "90"}},
      {2, "place = [46.5, 7.5]", {"s.toml:2: ", "place: expected a string, got an array"}},
      {4,
       "type = \"perspektive\"",
       {"s.toml:4: ", "camera.type = \"perspektive\": unknown; did you mean perspective?"}},
      {4, "width = 0", {"s.toml:4: ", "camera.width = 0: expected 1 .. 65536 pixels"}},
      {4, "width = 10.5", {"s.toml:4: ", "camera.width = 10.5: expected a whole number"}},
      {4, "type = \"cube\"\nheight = 3", {"s.toml:5: ", "camera.height = 3: expected 512"}},
      {5, "position = [0, 0, 0]", {"s.toml:5: ", "camera.position: expected 2 numbers, got 3"}},
      {5, "position = [0, 1e9]", {"s.toml:5: ", "camera.position[1] = 1e+09: expected -1e+07 .. 1e+07 m"}},
      {5, "position = [0, nan]", {"s.toml:5: ", "camera.position[1] = nan"}},
      {5,
       "position = [0, 0]\nplace = \"1,2\"",
       {"s.toml:5: ", "camera.position: expected either this or place, not both"}},
      {6, "altitude = -30000", {"s.toml:6: ", "camera.altitude = -30000: expected -20000 .. 1e+09 m"}},
      {6,
       "altitude = 10\nheight_above_ground = 10",
       {"s.toml:6: ", "camera.altitude: expected either this or height_above_ground"}},
      {6, "height_above_ground = 0", {"s.toml:6: ", "camera.height_above_ground = 0: expected 0.1 .. 1e+09 m"}},
      {7, "field_of_view = 200", {"s.toml:7: ", "camera.field_of_view = 200: expected 0.1 .. 170 degrees"}},
      {7, "azimuth = 3\nlook_at_position = [1, 2]", {"s.toml:7: ", "camera.azimuth: expected either this or look_at"}},
      {7, "look_at_altitude = 3", {"s.toml:7: ", "camera.look_at_altitude: expected look_at or look_at_position, too"}},
      {7, "fov = 3", {"s.toml:7: ", "camera.fov: unknown key"}},
      {9, "elevation = 91", {"s.toml:9: ", "sun.elevation = 91: expected -90 .. 90 degrees"}},
      {9, "azimuth = 1", {"s.toml:8: ", "sun.elevation is missing"}},
      {9, "time = \"yesterday\"", {"s.toml:9: ", "sun.time: "}},
      {9,
       "time = \"2026-06-21T18:40Z\"\nelevation = 1",
       {"s.toml:10: ", "sun.elevation: expected either this or time"}},
      {9, "elevation = 1\nrefraction = true", {"s.toml:10: ", "sun.refraction: expected only where time is given"}},
      {10, "[light]\nelevation = 3\n[[terrain]]", {"s.toml:10: ", "light: expected an array, got a table"}},
      {10, "[[light]]\n[[terrain]]", {"s.toml:10: ", "light[0].elevation is missing"}},
      {10,
       "[[light]]\nbody = \"moom\"\n[[terrain]]",
       {"s.toml:11: ", "light[0].body = \"moom\": unknown; did you mean moon?"}},
      {10, "[[light]]\nbody = \"moon\"\n[[terrain]]", {"s.toml:10: ", "light[0].elevation is missing"}},
      {10,
       "[[light]]\nelevation = 1\nphase = 3\n[[terrain]]",
       {"s.toml:12: ", "light[0].phase: expected only of a moon that stands by angles"}},
      {10,
       "[[light]]\nelevation = 1\nratio = -1\n[[terrain]]",
       {"s.toml:12: ", "light[0].ratio = -1: expected 0 .. 1e+06"}},
      {10,
       "[[light]]\nelevation = 1\nratio = 1\nirradiance = 1\n[[terrain]]",
       {"s.toml:13: ", "light[0].irradiance: expected either this or ratio"}},
      {10, "[[light]]\nelevation = 1\nirradiance = -1\n[[terrain]]", {"s.toml:12: ", "light[0].irradiance"}},
      {10,
       "[[light]]\nelevation = 1\nangular_radius = 90\n[[terrain]]",
       {"s.toml:12: ", "light[0].angular_radius = 90: expected 0.001 .. 85 degrees"}},
      {10,
       "[[light]]\nelevation = 1\nirradience = 1\n[[terrain]]",
       {"s.toml:12: ", "light[0].irradience: unknown key; did you mean irradiance?"}},
      {10, "[terrain]", {"s.toml:10: ", "terrain: expected an array, got a table"}},
      {11, "fil = \"a\"", {"s.toml:10: ", "terrain[0].file is missing"}},
      {11, "file = \"a.tif\"\nblend = -1", {"s.toml:12: ", "terrain[0].blend = -1: expected 0.1 .. 1e+05 m"}},
      {11, "file = \"a.tif\"\nband = 0", {"s.toml:12: ", "terrain[0].band = 0: expected 1 .. 1000"}},
      {13, "height = inf", {"s.toml:13: ", "relief.height = inf: expected 0 .. 20000 m"}},
      {13,
       "wavelength = 100\n[land]\nextent = 1e6",
       {"s.toml:13: ", "relief.wavelength = 100: expected at least a thousandth of land.extent"}},
      {13, "ruggednes = 1", {"s.toml:13: ", "relief.ruggednes: unknown key; did you mean ruggedness?"}},
      {15, "image_scale = 1", {"s.toml:15: ", "surface.image_scale: expected only where image is given"}},
      {15, "rock = [0.1, 0.2, 1.3]", {"s.toml:15: ", "surface.rock[2] = 1.3: expected 0 .. 1"}},
      {15, "rock = \"red\"", {"s.toml:15: ", "surface.rock: expected an array, got a string"}},
      {17, "samples = 0", {"s.toml:17: ", "picture.samples = 0: expected 1 .. 256"}},
      {17, "exposure = \"bright\"", {"s.toml:17: ", "picture.exposure = \"bright\": expected \"auto\" or a number"}},
      {17, "exposure = 1000", {"s.toml:17: ", "picture.exposure = 1000: expected -100 .. 100 EV"}},
      {17, "soft_shadows = 1", {"s.toml:17: ", "picture.soft_shadows: expected true or false, got a number"}},
      {17, "tone = \"film\"", {"s.toml:17: ", "picture.tone = \"film\": unknown"}},
  };
  EXPECT_GE(cases.size(), 40u);
  expect_refused(good_scene, cases, [](const std::string& text) { parse_scene(text, "s.toml"); });
}

}  // namespace
}  // namespace airlight
