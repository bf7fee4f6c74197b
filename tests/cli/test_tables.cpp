// `airlight tables`, read by the example's reader: the numbers of `probe`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "airlight/sky.h"
#include "run_program.h"

namespace airlight {
namespace {

nlohmann::json read_tables(const Folder& folder, const std::string& reader, double zenith, double azimuth) {
  const std::string command = std::string(AIRLIGHT_PYTHON " -B " AIRLIGHT_EXAMPLES "/read_tables/") + reader + ' ' +
                              (folder / "tables") + " " + std::to_string(zenith) + " " + std::to_string(azimuth);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("no shell");
  std::string text;
  char block[4096];
  while (const std::size_t n = std::fread(block, 1, sizeof block, pipe)) text.append(block, n);
  if (pclose(pipe) != 0) throw std::runtime_error("the reader failed");
  return nlohmann::json::parse(text);
}

TEST(Tables, the_readers_numbers_are_those_of_probe) {
  const Folder folder;
  const Outcome made = run(folder, {"tables", "earth-hazy", "--sun-elevation", "25", "--sun-azimuth", "40",
                                    "--altitude", "800", "-o", "tables"});
  ASSERT_EQ(made.code, 0) << made.err;
  for (const auto& [zenith, azimuth] : {std::pair{10.0, 200.0}, {60.0, 40.0}, {75.0, -70.0}, {86.0, 130.0}}) {
    SCOPED_TRACE(zenith);
    const nlohmann::json read = read_tables(folder, "read_tables.py", zenith, azimuth);
    for (const char* quantity : {"radiance", "transmittance"}) {
      const nlohmann::json question{{"quantity", quantity},      {"altitude", 800},
                                    {"view_zenith", zenith},     {"view_azimuth", azimuth},
                                    {"sun_zenith", 65},          {"sun_azimuth", 40},
                                    {"distance", nullptr},       {"wavelengths", read["wavelengths_nm"]},
                                    {"atmosphere", "earth-hazy"}};
      const Outcome probe = run(folder, {"probe", "--batch", "-"}, {.input = question.dump() + "\n"});
      ASSERT_EQ(probe.code, 0) << probe.err;
      const nlohmann::json answer = json_lines(probe.out).at(0)["value"];
      for (std::size_t k = 0; k < 4; ++k) {
        const double expected = answer[k], got = read[quantity][k];
        // A texel of the sky's table is up to ten degrees wide near the zenith, where the sky changes slowly: 0.6 %
        // measured. Optical depth is interpolated to 4e-4 of itself: measured at 86 degrees.
        const double tolerance = std::string(quantity) == "radiance" ? 0.01 : 1e-3 * std::max(1.0, -std::log(expected));
        EXPECT_NEAR(got, expected, tolerance * expected) << quantity << ' ' << k;
      }
    }
  }
}

TEST(Tables, of_all_orders_give_the_models_numbers) {
  const Folder folder;
  constexpr double degree = 0.017453292519943295;
  const Sky sky(built_in_atmosphere("earth-hazy"), "precomputed", make_engine("simd"),
                {{"detail", "draft"}, {"panels", std::vector<double>{64}}});
  for (const auto& [sun, altitude] : {std::pair{25.0, 800.0}, {-4.0, 12000.0}}) {
    const Outcome made =
        run(folder, {"tables", "earth-hazy", "--model", "precomputed", "--set", "detail=draft", "--sun-elevation",
                     std::to_string(sun), "--altitude", std::to_string(altitude), "-o", "tables"});
    ASSERT_EQ(made.code, 0) << made.err;
    for (const auto& [zenith, azimuth] : {std::pair{10.0, 200.0}, {86.0, 30.0}, {120.0, 130.0}}) {
      SCOPED_TRACE(zenith);
      const nlohmann::json read = read_tables(folder, "read_precomputed.py", zenith, azimuth);
      const auto wavelengths = read["wavelengths_nm"].get<std::vector<double>>();
      const Ray whole{.altitude = altitude,
                      .view = direction(azimuth * degree, (90 - zenith) * degree),
                      .sun = direction(0, sun * degree)};
      // Short of its end a ray is marched, as the reader does, and not looked up.
      const Planet planet = built_in_atmosphere("earth-hazy").planet;
      const double along = (planet.ground_radius + altitude) * whole.view[2];
      const auto gap = [&](double upper, double lower) {
        return (upper - lower) * (2 * planet.ground_radius + upper + lower);
      };
      const double reach = zenith < 90 ? std::sqrt(along * along + gap(planet.top_altitude, altitude)) - along
                                       : -along - std::sqrt(along * along - gap(altitude, 0));
      Ray segment = whole;
      segment.distance = reach - 1;
      std::vector<double> expected(4), all(4), air(4);
      sky.evaluate(Quantity::path_radiance, {&segment, 1}, wavelengths, expected);
      sky.evaluate(Quantity::radiance, {&whole, 1}, wavelengths, all);
      sky.evaluate(Quantity::path_radiance, {&whole, 1}, wavelengths, air);
      for (std::size_t k = 0; k < 4; ++k) expected[k] += all[k] - air[k];  // the ground's part
      // The reader's 400 steps against three Gauss points in each of 128 panels of a ray, which is held to what is seen along the whole of it:
      // in a draft's few cells that is a few percent off.
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(double(read["radiance"][k]) / expected[k], 1, 0.04) << "sun " << sun << ", value " << k;
    }
  }
}

TEST(Tables, every_table_is_there_twice) {
  const Folder folder;
  ASSERT_EQ(run(folder, {"tables", "earth", "--sun-elevation", "25", "-o", "tables"}).code, 0);
  const nlohmann::json index = nlohmann::json::parse(read_file(folder / "tables/tables.json"));
  for (const char* name : {"zones", "profile", "phases", "optical_depth", "sunlight", "multiple", "sky_view", "aerial",
                           "aerial_depth", "aerial_class0", "aerial_class1"}) {
    ASSERT_TRUE(index["tables"].contains(name)) << name;
    const nlohmann::json& table = index["tables"][name];
    const std::size_t texels = std::size_t(table["width"]) * std::size_t(table["height"]) * std::size_t(table["depth"]);
    EXPECT_EQ(read_file(folder / ("tables/" + std::string(table["raw"]))).size(), 16 * texels) << name;
    EXPECT_EQ(read_file(folder / ("tables/" + std::string(table["exr"]))).substr(0, 4), "\x76\x2f\x31\x01") << name;
  }
}

TEST(Tables, a_scene_gives_its_air_sun_and_eye) {
  const Folder folder;
  const std::string text = R"(
air = { base = "earth", aerosol_optical_depth = 0.3 }
[camera]
height_above_ground = 800
[sun]
elevation = 25
azimuth = 40
)";
  write_file(folder / "scene.toml", text);
  ASSERT_EQ(run(folder, {"tables", "scene.toml", "-o", "of_scene"}).code, 0);
  ASSERT_EQ(run(folder, {"tables", "earth", "--aerosol-optical-depth", "0.3", "--sun-elevation", "25", "--sun-azimuth",
                         "40", "--altitude", "800", "-o", "of_words"})
                .code,
            0);
  for (const char* file : {"sky_view.f32", "aerial.f32", "aerial_class1.f32"})
    EXPECT_TRUE(read_file(folder / ("of_scene/" + std::string(file))) ==
                read_file(folder / ("of_words/" + std::string(file))))
        << file;
  ASSERT_EQ(run(folder, {"tables", "scene.toml", "--altitude", "90", "--sun-elevation", "5", "-o", "changed"}).code, 0);
  const nlohmann::json observer = nlohmann::json::parse(read_file(folder / "changed/tables.json"))["observer"];
  EXPECT_EQ(observer["altitude"], 90);
  EXPECT_NEAR(observer["sun"][2], std::sin(5 * 0.017453292519943295), 1e-12);
  EXPECT_NEAR(double(observer["sun"][0]) / double(observer["sun"][1]), std::tan(40 * 0.017453292519943295), 1e-12);
}

TEST(Tables, colours_come_back_from_four_wavelengths) {
  const Folder folder;
  ASSERT_EQ(run(folder, {"tables", "earth", "--sun-elevation", "25", "-o", "tables"}).code, 0);
  const nlohmann::json index = nlohmann::json::parse(read_file(folder / "tables/tables.json"));
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k)
        sum += double(index["to_srgb"][row][k]) * double(index["from_srgb"][k][column]);
      EXPECT_NEAR(sum, row == column, 1e-9);  // two matrices of doubles, one made from the other
    }
  }
}

TEST(Tables, bad_words_are_named) {
  const Folder folder;
  const struct {
    std::vector<std::string> words;
    const char* says;
  } cases[] = {{{"tables", "eart", "--sun-elevation", "5", "-o", "t"}, "did you mean earth"},
               {{"tables", "earth", "-o", "t"}, "--sun-elevation"},
               {{"tables", "earth", "--sun-elevation", "5", "--altitude", "1e6", "-o", "t"}, "--altitude"},
               {{"tables", "earth", "--sun-elevation", "5", "--model", "skyveiw", "-o", "t"}, "did you mean skyview"}};
  for (const auto& c : cases) {
    const Outcome outcome = run(folder, c.words);
    EXPECT_EQ(outcome.code, 2) << c.says;
    EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

}  // namespace
}  // namespace airlight
