// `airlight sky`: what lies in the files.
#include <gtest/gtest.h>

#include <cmath>

#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

Picture sky(std::vector<std::string> more, const std::string& file = "sky.exr") {
  const Folder folder;
  more.insert(more.begin(), "sky");
  more.insert(more.end(), {"-o", file});
  const Outcome outcome = run(folder, more);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return read_picture(folder / file);
}

TEST(Pictures, one_rendering_fills_several_files) {
  const Folder folder;
  const Outcome outcome = run(folder, {"sky", "--place", "46.6,7.9", "--time", "2026-06-21T18:40Z", "--size", "64x32",
                                       "-o", "a.exr", "-o", "a.hdr", "-o", "a.png"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("a.exr, a.hdr, a.png: 64 x 32, earth, skyview on simd"), std::string::npos) << outcome.err;
  for (const char* file : {"a.exr", "a.hdr", "a.png"}) {
    const Picture picture = read_picture(folder / file);
    EXPECT_EQ(picture.width, 64) << file;
    EXPECT_EQ(picture.height, 32) << file;
    EXPECT_GT(picture.luminance(32, 4), 0) << file;
  }
  EXPECT_EQ(folder.names().size(), 3u);
}

TEST(Pictures, metadata_say_how_they_were_made) {
  const Picture picture =
      sky({"--place", "46.6,7.9", "--time", "2026-06-21T18:40Z", "--refraction", "--size", "16", "--ozone", "250"});
  for (const char* text :
       {"earth", "skyview", "simd", "46.6,7.9", "2026-06-21T18:40", "cd m-2", "lifts the sun", "1 / distance^2", "250",
        "wavelengths [nm] = ", "sun azimuth [degrees] = ", "sun elevation [degrees] = ", "airlight "})
    EXPECT_NE(picture.header.find(text), std::string::npos) << text << " in\n" << picture.header;
}

TEST(Pictures, light_of_two_suns_adds_up) {
  for (const char* projection : {"fisheye", "cube"}) {
    const auto with = [&](std::vector<std::string> words) {
      words.insert(words.end(), {"--projection", projection, "--size", "24", "--float"});
      return sky(words);
    };
    const Picture first = with({"--sun-elevation", "25", "--sun-azimuth", "40"}),
                  second = with({"--sun-elevation", "5", "--sun-azimuth", "200"}),
                  both =
                      with({"--sun-elevation", "25", "--sun-azimuth", "40", "--light", "elevation = 5, azimuth = 200"});
    ASSERT_EQ(both.rgb.size(), first.rgb.size());
    // The same floats are added: nothing but the file's rounding.
    for (std::size_t i = 0; i < both.rgb.size(); ++i)
      ASSERT_NEAR(both.rgb[i], first.rgb[i] + second.rgb[i], 1e-6f * std::abs(both.rgb[i])) << projection << ' ' << i;
    EXPECT_NE(both.header.find("light[0] elevation [degrees] = 5"), std::string::npos) << both.header;
  }
}

TEST(Pictures, a_moon_lights_the_night) {
  // Full on 3 January 2026; at midnight it is high over the Alps, and the sun 65 degrees below the horizon.
  const std::vector<std::string> night{"--place", "46.6,7.9", "--time", "2026-01-03T23:00Z", "--size", "32"};
  std::vector<std::string> moonlit = night;
  moonlit.insert(moonlit.end(), {"--light", "body = \"moon\""});
  const Picture dark = sky(night), lit = sky(moonlit);
  // A full moon is some 4e5 times fainter than the sun: skies of 0.003 to 0.03 cd/m2.
  EXPECT_LT(dark.luminance(16, 4), 1e-4);
  EXPECT_GT(lit.luminance(16, 4), 1e-3);
  EXPECT_LT(lit.luminance(16, 4), 0.1);
}

TEST(Pictures, spectral_channels_are_named_by_their_wavelengths) {
  const Picture picture = sky({"--sun-elevation", "20", "--size", "16", "--wavelengths", "360:830:10", "--spectral"});
  EXPECT_EQ(picture.layers.size(), 3u + 48);
  for (const char* name : {"S0.360nm", "S0.550nm", "S0.830nm"}) ASSERT_TRUE(picture.layers.contains(name)) << name;
  const std::size_t zenith = 8;  // of the first row
  EXPECT_GT(picture.layers.at("S0.450nm")[zenith], 2 * picture.layers.at("S0.700nm")[zenith]);
  EXPECT_NE(picture.header.find("spectralLayoutVersion = 1.0"), std::string::npos) << picture.header;
  // With the eye in between: the same picture as without the channels, but for half floats.
  const Picture plain = sky({"--sun-elevation", "20", "--size", "16", "--wavelengths", "360:830:10"});
  for (std::size_t i = 0; i < plain.rgb.size(); ++i)
    EXPECT_NEAR(picture.rgb[i], plain.rgb[i], 2e-3f * std::abs(plain.rgb[i]) + 1e-3f);
  // Fractions take a comma: a point would begin a layer.
  EXPECT_TRUE(
      sky({"--sun-elevation", "20", "--size", "8", "--wavelengths", "16", "--spectral"}).layers.contains("S0.392,5nm"));
}

TEST(Pictures, a_sensor_takes_the_eyes_place) {
  const Folder folder;
  // Channels that see one band each, and the third nothing.
  write_file(folder / "camera.csv", "nm,r,g,b\n600,1,0,0\n640,1,0,0\n641,0,0,0\n");
  const Outcome outcome = run(folder, {"sky", "--sun-elevation", "20", "--size", "8", "--wavelengths", "590:650:10",
                                       "--spectral", "--sensor", "camera.csv", "--float", "-o", "a.exr"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture picture = read_picture(folder / "a.exr");
  EXPECT_NE(picture.header.find("camera.csv"), std::string::npos);
  // 40 nm wide, and half a nanometre at its falling edge; light changes by a few percent over it.
  EXPECT_NEAR(picture.rgb[0], 40.5f * picture.layers.at("S0.620nm")[0], 0.04f * picture.rgb[0]);
  EXPECT_EQ(picture.rgb[1], 0);
  EXPECT_EQ(picture.rgb[2], 0);
}

TEST(Pictures, sizes_that_are_not_said_follow_the_projection) {
  const auto size = [](std::vector<std::string> more) {
    more.insert(more.end(), {"--sun-elevation", "30", "--no-sun"});
    const Picture picture = sky(more, "sky.png");
    return std::pair(picture.width, picture.height);
  };
  EXPECT_EQ(size({"--size", "32"}), std::pair(32, 16));
  EXPECT_EQ(size({"--size", "32", "--projection", "fisheye"}), std::pair(32, 32));
  EXPECT_EQ(size({"--size", "32", "--projection", "perspective"}), std::pair(32, 18));
  EXPECT_EQ(size({"--size", "8", "--projection", "cube"}), std::pair(48, 8));
  EXPECT_EQ(size({"--size", "10x30", "--projection", "perspective"}), std::pair(10, 30));
}

TEST(Pictures, cube_faces_lie_in_the_documented_order) {
  const std::vector<std::string> air{"--sun-elevation", "40",      "--sun-azimuth", "110",
                                     "--no-sun",        "--float", "--model",       "single"};
  auto words = air;
  words.insert(words.end(), {"--projection", "cube", "--size", "8"});
  const Picture cube = sky(words);
  ASSERT_EQ(cube.width, 48);
  int face = 0;
  for (const auto& [azimuth, elevation] :
       {std::pair{"90", "0"}, {"270", "0"}, {"0", "0"}, {"180", "0"}, {"0", "90"}, {"0", "-90"}}) {
    words = air;
    words.insert(words.end(), {"--projection", "perspective", "--size", "8x8", "--camera-azimuth", azimuth,
                               "--camera-elevation", elevation});
    const Picture view = sky(words);
    // The mean over the face does not depend on how the face is turned. 1e-4: rays of single precision.
    double of_cube = 0, of_view = 0;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        of_cube += cube.luminance(8 * face + x, y);
        of_view += view.luminance(x, y);
      }
    EXPECT_NEAR(of_cube / of_view, 1, 1e-4) << "face " << face;
    ++face;
  }
}

TEST(Pictures, the_sun_stands_where_it_was_put) {
  // Azimuth 60 of a panorama around north: x = (60 + 180) / 360; elevation 20: y = (90 - 20) / 180.
  const std::vector<std::string> words{"--sun-elevation", "20", "--sun-azimuth", "60", "--size", "720x360", "--float"};
  const Picture picture = sky(words);
  int brightest_x = 0, brightest_y = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.luminance(x, y) > picture.luminance(brightest_x, brightest_y)) brightest_x = x, brightest_y = y;
  EXPECT_NEAR(brightest_x, 480, 1);
  EXPECT_NEAR(brightest_y, 140, 1);
  auto without = words;
  without.push_back("--no-sun");
  // The disc is 1e4 and more times as bright as the sky beside it; at this size it fills about one pixel.
  EXPECT_GT(picture.luminance(brightest_x, brightest_y), 100 * sky(without).luminance(brightest_x, brightest_y));
}

TEST(Pictures, more_wavelengths_give_nearly_the_same_colours) {
  const std::vector<std::string> words{"--sun-elevation", "30", "--no-sun", "--float", "--size", "16"};
  auto many = words;
  many.insert(many.end(), {"--wavelengths", "40"});
  const Picture four = sky(words), forty = sky(many);
  // 4 wavelengths are an approximation of the integral: a few percent in luminance of a daylight sky.
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(four.luminance(x, 2) / forty.luminance(x, 2), 1, 0.05);
}

// A model whose picture is not in the unit that it states comes out black or white at its own exposure.
TEST(Pictures, of_published_systems_are_neither_black_nor_white) {
  const Folder folder;
  for (const char* model : {"codeflow", "hoffman_preetham", "jetlag", "rama", "realworldz"}) {
    SCOPED_TRACE(model);
    const Outcome outcome = run(folder, {"sky", "--model", model, "--sun-elevation", "20", "--projection",
                                         "perspective", "--field-of-view", "80", "--size", "48x32", "-o", "a.png"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Picture picture = read_picture(folder / "a.png");
    double sum = 0;
    for (const float value : picture.rgb) sum += double(value);
    const double mean = sum / double(picture.rgb.size());
    EXPECT_GT(mean, 0.05);
    EXPECT_LT(mean, 0.95);
  }
}

}  // namespace
}  // namespace airlight
