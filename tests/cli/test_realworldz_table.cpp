// `airlight realworldz-table`: tables that are generated, projected back from pictures, picked in and changed.
#include <gtest/gtest.h>

#include <cmath>

#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

// Without fog, stars and mountains the sky is the table's alone.
std::vector<std::string> panorama(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"sky",        "--model",
                                 "realworldz", "--sun-azimuth",
                                 "60",         "--sun-elevation",
                                 "25",         "--size",
                                 "512x256",    "--altitude",
                                 "2",          "--no-sun",
                                 "--set",      "Tfar=1",
                                 "--set",      "Sfar=0",
                                 "--set",      "stars=0",
                                 "--set",      "terrain=0",
                                 "-o",         out,
                                 "--float"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

double light(const Picture& p, int x, int y, std::size_t c) {
  return double(p.rgb[3 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x)) + c]) / 1e4;
}

/// Peak signal-to-noise ratio [dB] of what is above the horizon, white being 1.
double likeness(const Picture& a, const Picture& b) {
  double sum = 0;
  const int rows = a.height / 2 - 1;  // the last row above the horizon is half its haze: its ring is a row high
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < a.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::pow(std::min(light(a, x, y, c), 1.0) - std::min(light(b, x, y, c), 1.0), 2);
  return -10 * std::log10(sum / (3.0 * rows * a.width));
}

// The specification asks for 35 dB where the photograph covers.
TEST(RealworldzTable, projected_back_from_a_panorama_shows_the_same_sky) {
  const Folder folder;
  ASSERT_EQ(run(folder, panorama("sky.exr")).code, 0);
  const Outcome made =
      run(folder, {"realworldz-table", "--from", "sky.exr", "--sun", "60,25", "-o", "table.png", "-o", "table.exr"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("% of it seen in sky.exr"), std::string::npos) << made.err;
  ASSERT_EQ(run(folder, panorama("again.exr", {"--set", "table=table.png"})).code, 0);
  ASSERT_EQ(run(folder, panorama("floats.exr", {"--set", "table=table.exr"})).code, 0);
  const Picture sky = read_picture(folder / "sky.exr");
  EXPECT_GE(likeness(read_picture(folder / "again.exr"), sky), 35);
  EXPECT_GE(likeness(read_picture(folder / "floats.exr"), sky), 35);
}

TEST(RealworldzTable, painted_by_hand_is_what_a_sky_shows) {
  const Folder folder;
  ASSERT_EQ(run(folder, {"realworldz-table", "-o", "plain.png"}).code, 0);
  ASSERT_EQ(run(folder, {"realworldz-table", "--table", "plain.png", "--redden", "0.5", "-o", "red.png"}).code, 0);
  ASSERT_EQ(run(folder, panorama("plain.exr", {"--set", "table=plain.png"})).code, 0);
  ASSERT_EQ(run(folder, panorama("own.exr")).code, 0);
  ASSERT_EQ(run(folder, panorama("red.exr", {"--set", "table=red.png"})).code, 0);
  const Picture plain = read_picture(folder / "plain.exr"), own = read_picture(folder / "own.exr"),
                red = read_picture(folder / "red.exr");
  EXPECT_GE(likeness(plain, own), 50);  // eight bits an encoded colour: half a step of 1/255, 54 dB at white
  EXPECT_LT(likeness(red, own), 40);
  EXPECT_NEAR(light(red, 400, 40, 0) / light(plain, 400, 40, 0), 1.5, 0.03);  // eight bits
}

TEST(RealworldzTable, tells_which_cell_colours_a_pixel_and_back) {
  const Folder folder;
  ASSERT_EQ(run(folder, panorama("sky.exr")).code, 0);
  // The sun's own pixel: azimuth 60 and elevation 25 of 512 x 256, north in the middle.
  const Outcome at_sun =
      run(folder, {"realworldz-table", "--from", "sky.exr", "--sun-pixel", "341,92", "--pixel", "341,92"});
  ASSERT_EQ(at_sun.code, 0) << at_sun.err;
  EXPECT_EQ(at_sun.out.find("column 0, row "), 0u) << at_sun.out;
  const Outcome picked = run(folder, {"realworldz-table", "--from", "sky.exr", "--sun", "60,25", "--pixel", "100,60"});
  int column = -1, row = -1;
  ASSERT_EQ(std::sscanf(picked.out.c_str(), "column %d, row %d", &column, &row), 2) << picked.out;
  const Outcome shown = run(folder, {"realworldz-table", "--from", "sky.exr", "--sun", "60,25", "--cell",
                                     std::to_string(column) + "," + std::to_string(row), "--highlight", "h.exr",
                                     "--discontinuities", "edges.png"});
  ASSERT_EQ(shown.code, 0) << shown.err;
  EXPECT_EQ(read_picture(folder / "h.exr").rgb[3 * (60 * 512 + 100)], 1);
}

TEST(RealworldzTable, refuses_what_makes_no_sense) {
  const Folder folder;
  ASSERT_EQ(run(folder, panorama("sky.exr")).code, 0);
  const auto before = folder.names();
  const struct {
    std::vector<std::string> words;
    const char* says;
  } cases[] = {{{}, "nothing to do"},
               {{"-o", "a.jpg"}, "expected .png or .exr"},
               {{"--from", "none.exr", "--sun", "0,1", "-o", "a.png"}, "none.exr"},
               {{"--from", "sky.exr", "-o", "a.png"}, "either --sun or --sun-pixel"},
               {{"--from", "sky.exr", "--sun", "10", "-o", "a.png"}, "--sun = 10: expected two numbers"},
               {{"--from", "sky.exr", "--sun", "0,91", "-o", "a.png"}, "expected -90 .. 90 degrees"},
               {{"--from", "sky.exr", "--sun", "0,9", "--projection", "cube", "-o", "a.png"}, "cube"},
               {{"--from", "sky.exr", "--sun", "0,9", "--horizon", "90", "-o", "a.png"}, "no sky"},
               {{"--pixel", "1,1"}, "expected --from"},
               {{"--from", "sky.exr", "--sun", "0,9", "--cell", "1,1"}, "--highlight"},
               {{"--set", "Rg=1", "--from", "sky.exr", "--sun", "0,9", "-o", "a.png"}, "realworldz.Rg = 1"}};
  for (const auto& c : cases) {
    std::vector<std::string> words{"realworldz-table"};
    words.insert(words.end(), c.words.begin(), c.words.end());
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(RealworldzTable, is_named_in_a_scene_beside_it) {
  const Folder folder;
  ASSERT_EQ(run(folder, {"realworldz-table", "-o", "t.png", "--size", "32"}).code, 0);
  write_file(folder / "s.toml",
             "[sun]\nelevation = 10\n[camera]\nwidth = 32\nheight = 18\n[picture]\nmodel = \"realworldz\"\n"
             "[realworldz]\ntable = \"t.png\"\nro = 62000\nri = 60000\n");
  const Outcome outcome = run(folder, {"render", "s.toml", "-o", "s.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: realworldz.ro = 62000: less than Rb = 63000 m"), std::string::npos)
      << outcome.err;
  std::filesystem::remove(folder / "t.png");
  const Outcome missing = run(folder, {"render", "s.toml", "-o", "s.png"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.err.find("realworldz.table: cannot read"), std::string::npos) << missing.err;
}

}  // namespace
}  // namespace airlight
