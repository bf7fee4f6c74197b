// Rama, the spinning cylinder. Golden values: computed in double by a program that shares nothing with this one.
#include "model/rama.h"

#include "golden.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;

Golden one(const char* id, const char* function, const char* key, Numbers value, Numbers expected, double scale = 1) {
  return {id, function, {{key, std::move(value)}}, std::move(expected), scale};
}
Golden two(const char* id, const char* function, Numbers p, Numbers q, Numbers expected) {
  return {id, function, {{"p_km", std::move(p)}, {"q_km", std::move(q)}}, std::move(expected)};
}
Golden texel(const char* id, const char* function, double i, double j, double k, Numbers expected) {
  return {id, function, {{"i", Numbers{i}}, {"j", Numbers{j}}, {"k", Numbers{k}}}, std::move(expected)};
}
Golden warp(const char* id, double x, double expected) { return one(id, "rama.x_warp", "x_km", {x}, {expected}, 24); }
Golden source(const char* id, Numbers q, Numbers expected) {
  return one(id, "rama.J", "q_km", std::move(q), std::move(expected), 0.1);
}
Golden north_light(const char* id, Numbers q, double expected) {
  return {id,
          "rama.solid_angle_line",
          {{"light_radius_km", Numbers{8}},
           {"light_angle_deg", Numbers{0}},
           {"x1_km", Numbers{5.1}},
           {"x2_km", Numbers{15.9}},
           {"width_km", Numbers{0.1}},
           {"q_km", std::move(q)}},
          {expected},
          0.01};
}
Golden sees(const char* id, Numbers s, Numbers q, double expected) {
  return {id, "rama.visibility", {{"s_km", std::move(s)}, {"q_km", std::move(q)}}, {expected}};
}
const Parameters ray{{"p_km", Numbers{3, 0, -7.9}}, {"d_km", Numbers{12, 0, 12}}};
Parameters ray_from(const char* source) {
  Parameters p = ray;
  p["source"] = source;
  return p;
}

const std::vector<Golden> values{
    {"G2_1_kappa", "rama.kappa_per_km2", {}, {0.0073654}, 0.0073654},
    one("G2_1_axis", "rama.density_ratio", "r_km", {0}, {0.624137}),
    one("G2_1_4", "rama.density_ratio", "r_km", {4}, {0.702198}),
    one("G2_1_7_5", "rama.density_ratio", "r_km", {7.5}, {0.944517}),
    {"G2_2", "rama.L0_north_south", {}, {15901.5, 14907.7}, 15901.5},
    warp("G2_4_a", -24.75, -24.000000),
    warp("G2_4_b", -24, -23.440559),
    warp("G2_4_c", -16.5, -16.000000),
    warp("G2_4_d", -5, -3.484848),
    warp("G2_4_e", -1, -0.606061),
    warp("G2_4_f", 0.5, 0.312500),
    warp("G2_4_g", 5, 5.000000),
    warp("G2_4_h", 5.1, 6.000000),
    warp("G2_4_i", 10, 10.169811),
    warp("G2_4_j", 16.1, 17.000000),
    warp("G2_4_k", 20, 20.923077),
    texel("G2_5", "rama.texel_world_point", 34, 8, 16, {9.74286, 7.24444, 1.94114}),
    texel("G2_6", "rama.texel_world_point", 6, 20, 4, {-16.7063, 4.5697, 0.0747782}),
    one("G2_7", "rama.texture_coordinate", "p_km", {10, -5, 3}, {0.707547, 0.520075, 0.689727}),
    two("G2_8", "rama.transmittance", {10, 8, 0}, {10, -8, 0}, {0.933803, 0.852104, 0.676562}),
    two("G2_9", "rama.transmittance_fast", {10, 8, 0}, {10, -8, 0}, {0.933751, 0.851994, 0.676347}),
    two("G2_10", "rama.transmittance", {-15, 0, 0}, {15, 0, 0}, {0.897056, 0.775799, 0.538069}),
    north_light("G2_11_near", {10, 0, 0}, 0.0139482),
    north_light("G2_11_far", {0, 0, 0}, 0.00444679),
    source("G2_12", {10, 0, 0}, {0.195343, 0.433295, 0.928613}),
    source("G2_13", {10, 6, 0}, {0.630712, 1.43641, 3.29368}),
    source("G2_14", {-10, 0, -6}, {0.232734, 0.519013, 1.1298}),
    source("G2_15", {-4, 7.8, 0.3}, {0.0722512, 0.153055, 0.29217}),
    source("G2_20", {-4.8, 7.9, 0.3}, {0.0514974, 0.109009, 0.207846}),
    {"G2_16", "rama.scattering_midpoint30", ray_from("exact"), {3.00376, 6.32216, 11.9043}},
    {"G2_17", "rama.scattering_midpoint30", ray_from("texture"), {2.99666, 6.30724, 11.8766}, 1, 2e-3, 2e-3},
    {"G2_19", "rama.scattering_exact_rayleigh30", ray, {2.87247, 6.0367, 11.3238}},
    texel("G2_18", "rama.texel_value", 34, 8, 16, {0.296494, 0.667262, 1.48844}),
    // Both sides of the cliff, past its edge and through the opening.
    sees("past_the_cliff", {-10, 7.5, 0}, {-4.8, 7.9, 0}, 0),
    sees("through_the_opening", {-10, -7.5, 0}, {-4.8, 7.9, 0}, 1),
    sees("on_one_side", {10, 8, 0}, {-4.8, 7.9, 0}, 1),
};

class Rama : public testing::TestWithParam<GoldenCase> {};
TEST_P(Rama, says_what_the_source_says) { expect_golden(std::get<0>(GetParam()), std::get<1>(GetParam())); }
INSTANTIATE_TEST_SUITE_P(golden, Rama, on_all_engines(values), golden_name);

// G2.3, and the density it stands for at the axis, half way and the ground.
TEST(RamaDensity, is_near_a_straight_line_in_the_squared_radius) {
  const double kappa = rama_kappa({});
  const auto [a, b] = rama_density_line(kappa);
  EXPECT_NEAR(a, 0.613097, 1.5e-6);
  EXPECT_NEAR(b, 0.375863, 1.5e-6);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i)
    worst = std::max(worst, std::fabs(a + b * i / 1000 - std::exp(-64 * kappa * (1 - i / 1000.0))));
  EXPECT_NEAR(worst, 0.0110395, 1e-6);  // the grid misses the maximum by less
  const auto still = rama_density_line(0);
  EXPECT_EQ(still[0], 1);
  EXPECT_EQ(still[1], 0);
}

}  // namespace
}  // namespace airlight::test
