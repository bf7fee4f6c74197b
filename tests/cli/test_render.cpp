// `airlight render`: what lies in the files, and what it says of bad words.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mountains.h"
#include "read_picture.h"
#include "run_program.h"

namespace airlight {
namespace {

const std::string scene_text = mountains("height_above_ground = 300");

TEST(Render, layers_recombine_to_the_picture) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const Outcome outcome = run(folder, {"render", "scene.toml", "-o", "a.exr", "-o", "a.png", "--aov", "all"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture picture = read_picture(folder / "a.exr");
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 36);
  const auto layer = [&](const char* name) -> const std::vector<float>& {
    const auto found = picture.layers.find(name);
    if (found == picture.layers.end()) throw std::runtime_error(std::string("no layer ") + name);
    return found->second;
  };
  int sky = 0, lit = 0;
  for (std::size_t i = 0; i < layer("Z").size(); ++i) {
    const char* const colours[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto of = [&](const std::string& name) { return layer((name + '.' + colours[c]).c_str())[i]; };
      const float rgb = of("surface") * of("transmittance") + of("inscatter");
      ASSERT_NEAR(rgb, picture.rgb[3 * i + c], 1e-5 * std::abs(rgb));  // rounding of 32-bit floats
    }
    sky += std::isinf(layer("Z")[i]);
    lit += layer("sun_visibility")[i] > 0.5f;
  }
  EXPECT_GT(sky, 100);
  EXPECT_GT(lit, 100);
  EXPECT_EQ(read_picture(folder / "a.png").width, 64);
  EXPECT_EQ(folder.names().size(), 3u);
}

TEST(Render, spectral_layers_make_the_pictures_colours) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  for (const char* samples : {"1", "4"}) {
    const Outcome outcome =
        run(folder, {"render", "scene.toml", "--samples", samples, "-o", "a.exr", "--aov", "spectral,depth"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Picture picture = read_picture(folder / "a.exr");
    ASSERT_EQ(run(folder, {"tables", "scene.toml", "-o", "tables"}).code, 0);
    const nlohmann::json index = nlohmann::json::parse(read_file(folder / "tables/tables.json"));
    for (std::size_t i = 0; i < picture.layers.at("Z").size(); ++i) {
      std::array<double, 3> rgb{};
      double brightest = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::string at = "." + std::to_string(int(index["wavelengths_nm"][k])) + "nm";
        const double surface = picture.layers.at("surface" + at)[i], inscatter = picture.layers.at("inscatter" + at)[i],
                     transmittance = picture.layers.at("transmittance" + at)[i];
        ASSERT_GE(transmittance, 0);
        ASSERT_LE(transmittance, 1);
        for (std::size_t c = 0; c < 3; ++c) {
          const double part = double(index["to_srgb"][c][k]) * (surface * transmittance + inscatter);
          rgb[c] += part;
          brightest = std::max(brightest, std::abs(part));
        }
      }
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(picture.rgb[3 * i + c], rgb[c], 1e-5 * brightest);  // floats, of which four add up
      // Air lets red light through more than blue; a mean over samples near and far, weighted by their light, need not.
      if (samples == std::string("1")) {
        ASSERT_LT(picture.layers.at("transmittance.445nm")[i], picture.layers.at("transmittance.635nm")[i]);
      }
    }
  }
}

TEST(Render, any_wavelengths_are_woven_of_pictures_of_four) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const auto draw = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "scene.toml", "--samples", "1", "--float", "-o", "a.exr"});
    const Outcome outcome = run(folder, more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_picture(folder / "a.exr");
  };
  // The four of real time are the picture of real time; among more they stay what they are.
  const Picture plain = draw({}), four = draw({"--wavelengths", "445,515,565,635", "--spectral"}),
                six = draw({"--wavelengths", "445,515,565,635,700,720", "--spectral"});
  EXPECT_EQ(six.layers.size(), 3u + 6);
  for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
    const float size =
        std::abs(plain.rgb[i - i % 3]) + std::abs(plain.rgb[i - i % 3 + 1]) + std::abs(plain.rgb[i - i % 3 + 2]);
    ASSERT_NEAR(four.rgb[i], plain.rgb[i], 1e-5f * size);  // sums of floats, by large weights
  }
  for (const char* name : {"S0.445nm", "S0.635nm"}) EXPECT_EQ(four.layers.at(name), six.layers.at(name)) << name;
  EXPECT_GT(six.layers.at("S0.700nm")[0], six.layers.at("S0.720nm")[0]);  // the blue sky at its red end
}

TEST(Render, chosen_layers_alone_are_written) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const Outcome outcome = run(folder, {"render", "scene.toml", "--size", "16", "-o", "a.exr", "--aov", "depth,normal"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture picture = read_picture(folder / "a.exr");
  EXPECT_EQ(picture.width, 16);
  EXPECT_EQ(picture.height, 9);
  EXPECT_TRUE(picture.layers.contains("Z"));
  EXPECT_TRUE(picture.layers.contains("normal.X"));
  EXPECT_FALSE(picture.layers.contains("surface.R"));
}

// What counts is how the file is written, not how its ending is spelled.
TEST(Render, layers_go_into_whatever_is_written_as_exr) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  for (const char* name : {"u.EXR", "/dev/stdout"}) {
    const Outcome outcome = run(folder, {"render", "scene.toml", "--size", "16", "-o", name, "--aov", "depth"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    if (!outcome.out.empty()) write_file(folder / "piped.exr", outcome.out);
  }
  for (const char* name : {"u.EXR", "piped.exr"}) EXPECT_TRUE(read_picture(folder / name).layers.contains("Z")) << name;
}

TEST(Render, a_cube_has_six_faces) {
  const Folder folder;
  std::string scene = scene_text;
  scene.replace(scene.find("[camera]"), 8, "[camera]\ntype = \"cube\"");
  for (const char* line : {"height = 36\n", "field_of_view = 60\n", "azimuth = 30\n"})
    scene.replace(scene.find(line), std::string(line).size(), "");
  scene.replace(scene.find("width = 64"), 10, "width = 16");
  write_file(folder / "scene.toml", scene);
  const Outcome outcome = run(folder, {"render", "scene.toml", "-o", "a.exr"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Picture picture = read_picture(folder / "a.exr");
  EXPECT_EQ(picture.width, 96);
  EXPECT_EQ(picture.height, 16);
  // Face 5 looks up into the sky, face 6 down to the ground 300 m below: brighter and darker than each other's neighbour.
  EXPECT_GT(picture.luminance(72, 8), 0);
  EXPECT_GT(picture.luminance(88, 8), 0);
}

TEST(Render, a_frame_is_the_one_that_sequence_makes) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text + R"(
[[animate]]
key = "camera.azimuth"
times = [0, 1]
values = [30, 50]
)");
  const std::vector<std::string> words{"scene.toml", "--size", "16", "--fps", "4"};
  const auto made = [&](std::vector<std::string> more) {
    more.insert(more.end(), words.begin(), words.end());
    const Outcome outcome = run(folder, more);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  };
  made({"sequence", "--frames", "3:3", "-o", "%d.exr"});
  made({"render", "--frame", "3", "-o", "frame.exr"});
  made({"render", "--frame", "0", "-o", "first.exr"});
  EXPECT_EQ(read_picture(folder / "3.exr").rgb, read_picture(folder / "frame.exr").rgb);
  EXPECT_NE(read_picture(folder / "first.exr").rgb, read_picture(folder / "frame.exr").rgb);
}

// Land casts shadows into the air where the model can make them: left out with a word where nothing was asked, refused where they were.
TEST(Render, shadows_in_the_air_are_left_out_where_they_cannot_be) {
  const Folder folder;
  const std::string space = mountains("altitude = 400000\nelevation = -90");
  write_file(folder / "ground.toml", scene_text);
  write_file(folder / "space.toml", space);
  write_file(folder / "asked.toml", space + "[picture]\nair_shadows = true\n");
  const std::string note = "warning: land casts no shadows into the air";
  const auto says = [&](std::vector<std::string> words, const char* output = "a.exr") {
    words.insert(words.end(), {"-o", output});
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(says({"render", "ground.toml"}).find(note), std::string::npos);
  EXPECT_NE(says({"render", "ground.toml", "--model", "single"}).find(note), std::string::npos);
  EXPECT_EQ(says({"render", "space.toml", "--no-air-shadows"}).find(note), std::string::npos);
  EXPECT_NE(says({"render", "space.toml", "--aov", "depth"}).find(note), std::string::npos);
  EXPECT_NE(
      says({"haze", "--scene", "space.toml", "--color", "a.exr", "--depth-kind", "distance"}, "hazed.exr").find(note),
      std::string::npos);
  const Outcome refused = run(folder, {"render", "asked.toml", "-o", "b.exr"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("model skyview: cannot shade the air for an observer at 400000 m; expected "
                             "picture.air_shadows = false"),
            std::string::npos)
      << refused.err;
}

TEST(Render, bad_words_are_named_and_nothing_is_written) {
  const Folder folder;
  write_file(folder / "scene.toml", scene_text);
  const struct {
    std::vector<std::string> words;
    const char* says;
  } cases[] = {{{"render", "none.toml", "-o", "a.png"}, "none.toml"},
               {{"render", "scene.toml", "-o", "a.exr", "--aov", "depht"}, "did you mean depth"},
               {{"render", "scene.toml", "-o", "a.exr", "--aov", "x"}, "expected one of all, surface, "},
               {{"render", "scene.toml", "-o", "a.png", "--aov", "depth"}, "--aov: layers go into an .exr"},
               {{"render", "scene.toml", "-o", "a.png", "--samples", "3"}, "samples = 3"},
               {{"render", "scene.toml", "-o", "a.png", "--size", "0"}, "--size"},
               {{"render", "scene.toml", "-o", "a.png", "--model", "skyveiw"}, "did you mean skyview"},
               {{"render", "scene.toml", "-o", "a.txt"}, ".txt"},
               {{"render", "scene.toml", "-o", "a.png", "-o", "a.png"}, "named twice"},
               {{"render", "scene.toml", "-o", "a.png", "--frame", "-1"}, "--frame = -1: expected 0 .. "},
               {{"render", "scene.toml", "-o", "a.png", "--fps", "24"}, "--frame"},
               {{"render", "scene.toml"}, "--output"}};
  for (const auto& c : cases) {
    const Outcome outcome = run(folder, c.words);
    EXPECT_EQ(outcome.code, 2) << c.says;
    EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.toml"});
  }
}

}  // namespace
}  // namespace airlight
