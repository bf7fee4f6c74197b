#include "scenefile/atmosphere_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

// The project's example of an atmosphere: Bruneton 2017's demonstration.
constexpr const char* bruneton = R"(
[planet]
ground_radius = 6_360_000.0     # m
top_altitude  = 60_000.0
albedo        = 0.1
[sun]
irradiance     = { file = "solar_irradiance.csv", sampling = "point" }
angular_radius = 0.004675       # rad
[[constituent]]
name = "molecules"
profile    = { type = "exponential", scale_height = 8000.0 }
scattering = { type = "power", at = 1000.0, value = 1.24062e-6, exponent = -4.0 }    # nm, 1/m
phase      = { type = "rayleigh" }
[[constituent]]
name = "aerosol"
profile    = { type = "exponential", scale_height = 1200.0 }
extinction = { type = "angstrom", value = 4.44e-6, at = 550.0, exponent = 0.0 }
single_scattering_albedo = 0.9      # or scattering = and absorption = instead of extinction and albedo
phase      = { type = "cornette-shanks", g = 0.8 }
[[constituent]]
name = "ozone"
profile    = { type = "tent", altitude = 25000.0, half_width = 15000.0 }
absorption = { type = "column", dobson = 300.0, cross_section = { file = "ozone_cross_section_233K.csv", sampling = "point" } }
)";

/// An atmosphere of one constituent called "x", given by the lines after its name.
std::string with_constituent(const std::string& lines) {
  return "[planet]\nground_radius = 6e6\ntop_altitude = 1e5\n[sun]\nirradiance = 1\n[[constituent]]\nname = \"x\"\n" +
         lines;
}
Constituent constituent(const std::string& lines) {
  return parse_atmosphere(with_constituent(lines), "x.toml").constituents.at(0);
}

TEST(AtmosphereFile, the_example_is_the_built_in_atmosphere) {
  EXPECT_EQ(parse_atmosphere(bruneton, "earth-bruneton.toml"), built_in_atmosphere("earth-bruneton"));
}

TEST(AtmosphereFile, built_in_atmospheres_survive_being_written_and_read) {
  for (const std::string_view name : built_in_atmospheres()) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    EXPECT_EQ(parse_atmosphere(to_toml(atmosphere), "any.toml"), atmosphere) << to_toml(atmosphere);
    const Atmosphere changed =
        name == "mars-clear"
            ? atmosphere
            : with_overrides(atmosphere, {.aerosol_optical_depth = 1.0 / 3, .angstrom = 0.7, .ozone = 0.1});
    EXPECT_EQ(parse_atmosphere(to_toml(changed), "any.toml"), changed) << to_toml(changed);
  }
}

TEST(AtmosphereFile, every_profile_phase_and_law_survives_being_written_and_read) {
  Atmosphere atmosphere = built_in_atmosphere("earth");
  atmosphere.name = "\"quoted\\ \n\t\x01 name\" of \xC3\x85ngstr\xC3\xB6m";
  const std::vector<Profile> profiles{ExponentialProfile{1.0 / 3 * 1e4},
                                      TentProfile{1e3, 2e3},
                                      LayersProfile{{{0, 100, 0.1}, {100, 1e4, 1e-3}}},
                                      TableProfile{{0, 1e3, 1e5}, {1, 0.1, 0}, true},
                                      TableProfile{{0, 1e3}, {1, 0.1}, false},
                                      StandardAtmosphereProfile{}};
  const double uniform = 1 / (4 * std::numbers::pi);
  const std::vector<Phase> phases{RayleighPhase{0.03},
                                  RayleighPhase{},
                                  IsotropicPhase{},
                                  HenyeyGreensteinPhase{-0.1},
                                  CornetteShanksPhase{0.76},
                                  DoubleHenyeyGreensteinPhase{0.9, -0.2, 0.7},
                                  TablePhase{{0, 1, std::numbers::pi}, {uniform, uniform, uniform}}};
  const Spectrum table(TableSpectrum{{400, 500.5, 700}, {0.1, 1.0 / 7, 0}, Sampling::point, ""});
  const std::vector<Spectrum> spectra{0.0,
                                      1e-300,
                                      123456789.0 / 1e10,
                                      table,
                                      table.scaled(1.0 / 3),
                                      Spectrum(TableSpectrum{{400, 410, 420}, {1, 2, 3}, Sampling::bins, ""}),
                                      Spectrum(PowerSpectrum{551, 1e-5, -1.3}),
                                      Spectrum(RayleighAirSpectrum{1e25}).scaled(2),
                                      Spectrum(ProductSpectrum{{1e-5, table}, {table, 0.5}}).scaled(0.1),
                                      Spectrum(ProductSpectrum{{}, {}})};
  atmosphere.constituents.clear();
  for (std::size_t i = 0; i < 10; ++i) {
    atmosphere.constituents.push_back({"c" + std::to_string(i), profiles[i % profiles.size()], spectra[i],
                                       spectra[(i + 3) % spectra.size()], phases[i % phases.size()]});
  }
  EXPECT_EQ(parse_atmosphere(to_toml(atmosphere), "any.toml"), atmosphere) << to_toml(atmosphere);
}

TEST(AtmosphereFile, name_is_given_or_the_files) {
  EXPECT_EQ(parse_atmosphere(bruneton, "some/where/titan.toml").name, "titan");
  EXPECT_EQ(parse_atmosphere("name = \"Titan\"\n" + std::string(bruneton), "a.toml").name, "Titan");
}

TEST(AtmosphereFile, names_may_hold_any_character) {
  // A byte order mark first, characters of two to four bytes, a comment, and one behind a line's continuation.
  const std::string name = "Z\xC3\xBCrich \xE2\x98\x80\xF0\x9F\x8C\x84";
  const std::string quoted = "\xEF\xBB\xBFname = \"" + name + "\" # \xC3\xA9\n" + bruneton;
  EXPECT_EQ(parse_atmosphere(quoted, "air.toml").name, name);
  const std::string many_lines = "name = \"\"\"\\\n  " + name + "\"\"\"\"\n" + bruneton;
  EXPECT_EQ(parse_atmosphere(many_lines, "air.toml").name, name + '"');
}

TEST(AtmosphereFile, angstrom_exponent_has_the_other_sign) {
  const Constituent aerosol = constituent(
      "profile = { type = \"exponential\", scale_height = 1500 }\n"
      "scattering = { type = \"angstrom\", at = 500, value = 1e-4, exponent = 2 }\nphase = { type = \"isotropic\" }");
  EXPECT_NEAR(aerosol.scattering.at(1000), 0.25e-4, 1e-18);
}

TEST(AtmosphereFile, extinction_and_a_coloured_albedo_multiply) {
  const Constituent dust = constituent(
      "profile = { type = \"exponential\", scale_height = 1500 }\n"
      "extinction = { type = \"angstrom\", at = 500, value = 1e-4, exponent = 1 }\n"
      "single_scattering_albedo = { wavelengths = [400, 800], values = [0.6, 1.0] }\n"
      "phase = { type = \"henyey-greenstein\", g = 0.7 }");
  EXPECT_NEAR(dust.scattering.at(600), 1e-4 * 500 / 600 * 0.8, 1e-18);
  EXPECT_NEAR(dust.absorption.at(600), 1e-4 * 500 / 600 * 0.2, 1e-18);
  EXPECT_EQ(dust.absorption.at(800), 0);
}

TEST(AtmosphereFile, shipped_files_are_bins_unless_said_otherwise) {
  const auto sampling = [](const std::string& spectrum) {
    const Atmosphere atmosphere = parse_atmosphere(
        "[planet]\nground_radius = 6e6\ntop_altitude = 1e5\n[sun]\nirradiance = " + spectrum, "a.toml");
    return std::get<TableSpectrum>(atmosphere.sun.irradiance.law()).sampling;
  };
  EXPECT_EQ(sampling("{ file = \"solar_irradiance.csv\" }"), Sampling::bins);
  EXPECT_EQ(sampling("{ file = \"solar_irradiance.csv\", sampling = \"point\" }"), Sampling::point);
  EXPECT_EQ(sampling("{ wavelengths = [400, 410], values = [1, 2] }"), Sampling::point);
  EXPECT_EQ(sampling("{ wavelengths = [400, 410], values = [1, 2], sampling = \"bins\" }"), Sampling::bins);
}

TEST(AtmosphereFile, phase_tables_are_normalised) {
  const Constituent x = constituent(
      "profile = { type = \"exponential\", scale_height = 1500 }\nscattering = 1e-5\n"
      "phase = { type = \"table\", angles = [0, 1, 3.14159265], values = [7, 7, 7] }");
  EXPECT_NEAR(std::get<TablePhase>(x.phase).values.at(1), 1 / (4 * std::numbers::pi), 1e-9);
}

TEST(AtmosphereFile, starts_from_a_base) {
  EXPECT_EQ(parse_atmosphere("base = \"earth\"", "earth.toml"), built_in_atmosphere("earth"));
  const Atmosphere changed = parse_atmosphere(
      "base = \"earth\"\naerosol_optical_depth = 0.3\nangstrom = 1\nozone = 250\n[planet]\nalbedo = 0.3\n",
      "earth.toml");
  Atmosphere expected = built_in_atmosphere("earth");
  expected.planet.albedo = 0.3;
  EXPECT_EQ(changed, with_overrides(expected, {.aerosol_optical_depth = 0.3, .angstrom = 1, .ozone = 250}));
}

TEST(AtmosphereFile, constituents_replace_the_bases_of_the_same_name_and_join_the_others) {
  const std::string lines =
      "\nprofile = { type = \"exponential\", scale_height = 700 }\nscattering = 1e-5\nphase = { type = \"isotropic\" "
      "}\n";
  const Atmosphere changed = parse_atmosphere(
      "base = \"earth\"\n[[constituent]]\nname = \"aerosol\"" + lines + "[[constituent]]\nname = \"fog\"" + lines,
      "a.toml");
  ASSERT_EQ(changed.constituents.size(), 4u);
  EXPECT_EQ(changed.constituents[1].name, "aerosol");
  EXPECT_EQ(changed.constituents[1].profile, Profile(ExponentialProfile{700}));
  EXPECT_EQ(changed.constituents[3].name, "fog");
}

TEST(AtmosphereFile, columns_of_a_base_follow_another_top) {
  const Atmosphere low = parse_atmosphere("base = \"earth\"\n[planet]\ntop_altitude = 30000\n", "a.toml");
  const Constituent& ozone = low.constituents[2];
  EXPECT_NEAR(ozone.absorption.at(605) * mean_density(ozone.profile, 0, 30'000) * 30'000, 300 * dobson_unit * 5.019e-25,
              1e-12);
}

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    // Tests run side by side: each process has a folder of its own.
    path = std::filesystem::path(testing::TempDir()) / ("airlight_scenefile_test-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
  }
  void TearDown() override { std::filesystem::remove_all(path); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return (path / name).string();
  }
  std::filesystem::path path;
};

TEST_F(Folder, files_are_looked_for_beside_the_toml_first) {
  write("my.csv", "nm,value\n400,1\n700,3\n");
  write("solar_irradiance.csv", "nm,value\n400,1\n410,3\n");
  const std::string planet = "[planet]\nground_radius = 6e6\ntop_altitude = 1e5\n";
  const auto irradiance = [&](const std::string& file) {
    return load_atmosphere(write("a.toml", planet + "[sun]\nirradiance = { file = \"" + file + "\" }\n"))
        .sun.irradiance;
  };
  EXPECT_EQ(irradiance("my.csv").at(550), 2) << "what people bring holds points";
  EXPECT_EQ(irradiance("solar_irradiance.csv").at(410), 2) << "a file of a shipped name holds bins, and goes first";
  EXPECT_EQ(std::get<TableSpectrum>(irradiance("my.csv").law()).file, "my.csv");
}

TEST_F(Folder, bad_lines_of_named_files_are_found) {
  write("my.csv", "nm,value\n400,1\n700;3\n");
  try {
    load_atmosphere(write("a.toml", "base = \"earth\"\n[sun]\nirradiance = { file = \"my.csv\" }\n"));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("my.csv:3: "), std::string::npos) << error.what();
  }
}

TEST_F(Folder, load_takes_names_and_paths) {
  EXPECT_EQ(load_atmosphere("mars-clear"), built_in_atmosphere("mars-clear"));
  EXPECT_EQ(load_atmosphere(write("mine.toml", to_toml(built_in_atmosphere("earth")))), built_in_atmosphere("earth"));
  EXPECT_THROW(load_atmosphere((path / "missing.toml").string()), InputError);
  EXPECT_THROW(load_atmosphere(path.string()), InputError);
  std::filesystem::create_directories(path / "folder.toml");
  EXPECT_THROW(load_atmosphere((path / "folder.toml").string()), InputError);
  EXPECT_THROW(load_atmosphere("erth"), InputError);
}

}  // namespace
}  // namespace airlight
