// The Jetlag intro's sky. Golden values: computed in double by a program that shares nothing with this one.
#include "model/jetlag.h"

#include <numbers>

#include "golden.h"
#include "model/jetlag_noise.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;

/// y up; azimuth 0 looks along -z [degrees].
Numbers dir(double azimuth, double elevation) {
  const double az = azimuth * std::numbers::pi / 180, el = elevation * std::numbers::pi / 180;
  return {std::cos(el) * std::sin(az), std::sin(el), -std::cos(el) * std::cos(az)};
}
const double n = std::sqrt(2.04);
const Numbers sun{1 / n, 0.2 / n, 1 / n}, eye{0, 200, 0};

Golden density(const char* id, double h, Numbers expected) {
  return {id, "jetlag.density_clear", {{"p_m", Numbers{0, h, 0}}}, std::move(expected)};
}
Golden escape(const char* id, Numbers d, double radius, double expected) {
  return {id, "jetlag.escape", {{"p_m", eye}, {"dir", std::move(d)}, {"R_m", Numbers{radius}}}, {expected}, 1e3};
}
Golden depth(const char* id, double steps, Numbers expected) {
  return {id,
          "jetlag.depth_integral_clear",
          {{"o_m", eye}, {"dir", dir(0, 90)}, {"L_m", Numbers{19800}}, {"steps", Numbers{steps}}},
          std::move(expected),
          1e3};
}
Golden clear(const char* id, Numbers d, double length, Numbers behind, Numbers expected) {
  return {id,
          "jetlag.scatter_clear",
          {{"o_m", eye}, {"dir", std::move(d)}, {"L_m", Numbers{length}}, {"Lo", std::move(behind)}, {"sun", sun}},
          std::move(expected)};
}
Golden cloud(const char* id, const char* top_length, const char* constants, Numbers expected) {
  return {id,
          "jetlag.scatter_cloud",
          {{"o_m", Numbers{-300, 200, 40}},
           {"dir", dir(135, 12)},
           {"L_m", Numbers{92180.563}},
           {"sun", sun},
           {"t_s", Numbers{20}},
           {"sun_top_length", top_length},
           {"phase_constants", constants}},
          std::move(expected),
          1,
          2e-6,
          2e-2};
}

const std::vector<Golden> values{
    density("G4_1_ground", 0, {1, 1}),
    density("G4_1_1km", 1000, {0.882497, 0.434598}),
    density("G4_1_5km", 5000, {0.535261, 0.0155039}),
    escape("G4_2_up", dir(0, 90), 6380e3, 19800.000),
    escape("G4_2_level", dir(0, 0), 6380e3, 502250.893),
    escape("G4_2_cloud_top", dir(0, 10), 6362.5e3, 13169.055),
    depth("G4_3_4", 4, {9583.07, 4258.92}),
    depth("G4_3_64", 64, {7284.86, 1152.34}),
    {"G4_5_near", "jetlag.noise31", {{"v", Numbers{3.25, 7.5, 11.75}}}, {0.386642}},
    {"G4_5_far", "jetlag.noise31", {{"v", Numbers{-3.3, 1000.2, 2050.7}}}, {0.580902}},
    {"G4_6",
     "jetlag.density_cloud",
     {{"p_m", Numbers{2500, 1600, 2000}}, {"t_s", Numbers{20}}},
     {0.818648, 39.8316, 0.512458},
     1,
     2e-6,
     2e-2},
    clear("G4_7", dir(135, 5), 193693.062, {0}, {3.00001, 1.81874, 0.490821}),
    clear("G4_8", dir(-45, 20), 57228.647, {0}, {0.0888746, 0.145732, 0.159887}),
    clear("G4_9", dir(0, -1), 9000, {0.5, 0.4, 0.3}, {0.415172, 0.318353, 0.199781}),
    cloud("G4_10", "printed", "rounded", {0.728362, 0.458815, 0.142602}),
    cloud("G4_11", "corrected", "rounded", {0.789075, 0.506269, 0.164503}),
    cloud("G4_12", "printed", "exact", {0.769777, 0.484625, 0.150353}),
};

class Jetlag : public testing::TestWithParam<GoldenCase> {};
TEST_P(Jetlag, says_what_the_source_says) { expect_golden(std::get<0>(GetParam()), std::get<1>(GetParam())); }
INSTANTIATE_TEST_SUITE_P(golden, Jetlag, on_all_engines(values), golden_name);

TEST(JetlagNoise, begins_as_specified_and_its_bytes_are_the_table_s) {
  const std::uint8_t first[] = {27, 212, 115, 190, 148, 203, 255, 246};  // G4.4
  const std::vector<double> texels = jetlag_noise_texels();
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(jetlag_noise_byte(i), first[i]);
    EXPECT_EQ(texels[i], first[i] / 255.0);
  }
  // The jump to a byte and the walk to it agree.
  for (std::uint32_t i : {1023u, 4096u, 4194303u}) EXPECT_EQ(texels[i], jetlag_noise_byte(i) / 255.0) << i;
}

// The noise repeats after 1024 texels: offsets reduced by that are the same clouds.
TEST(JetlagDrift, moves_the_noise_as_far_as_time_says) {
  const double t = 123.4;
  Fields drift = jetlag_drift(t);
  const std::pair<const char*, double> octaves[] = {{"first", 1}, {"ninth", 9}, {"seventeenth", 17}};
  for (const auto& [name, k] : octaves) {
    const double x = (drift[name][0] - k * 0.0015 * t * -90) / 1024, z = (drift[name][2] - k * 0.0015 * t * 80) / 1024;
    EXPECT_NEAR(x, std::round(x), 1e-12) << name;
    EXPECT_NEAR(z, std::round(z), 1e-12) << name;
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(drift[name][c], 0);
      EXPECT_LT(drift[name][c], 1024);
    }
  }
}

}  // namespace
}  // namespace airlight::test
