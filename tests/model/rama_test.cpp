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

// ---- properties ----

std::unique_ptr<EngineCaller> kernels_on(const char* name) {
  return std::make_unique<EngineCaller>(*engine_or_none(name));
}

/// J at places, for an engine and settings.
std::vector<double> sources(EngineCaller& kernels, const RamaSettings& settings, const std::vector<Numbers>& places) {
  Numbers texels;
  for (const Numbers& p : places) texels.insert(texels.end(), {p[0], p[1], p[2], 0});
  const Shape shape{int(places.size()), 1};
  return kernels.read(kernels.run(
      "rama.places", {{"rama", rama_fields(settings)}},
      {{"lights", kernels.upload({6, 2}, rama_lights(settings))}, {"places", kernels.upload(shape, texels)}},
      shape)[0]);
}

// Six strips at 0 and 120 degrees to both sides: a third of a turn, and the mirror about a strip, change nothing.
TEST(RamaSource, repeats_by_a_third_of_a_turn_and_mirrors_about_strips) {
  const double third = 2 * std::acos(-1.0) / 3;
  const auto at = [](double x, double r, double phi) { return Numbers{x, r * std::cos(phi), r * std::sin(phi)}; };
  const auto kernels = kernels_on("double");
  for (double x : {-20.0, -10.0, -4.9, 0.0, 6.0, 15.95}) {
    for (double phi : {0.2, 0.9}) {
      const auto j =
          sources(*kernels, {}, {at(x, 5, phi), at(x, 5, phi + third), at(x, 5, phi - third), at(x, 5, -phi)});
      for (std::size_t k = 1; k < 4; ++k)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(j[4 * k + c], j[c], 1e-9 * j[c]) << x << " " << phi;
    }
  }
}

// Without attenuation each strip's light is its closed solid angle: what nothing hides adds up to beta rho / 4 pi sum of L0 Omega.
TEST(RamaSource, of_thin_air_is_the_strips_solid_angle_in_closed_form) {
  RamaSettings thin;
  for (double& b : thin.scattering) b = 1e-9;
  thin.spin = 0;
  const auto kernels = kernels_on("double");
  const Numbers q{7, 2, -3};
  const auto j = sources(*kernels, thin, {q});
  const auto lights = rama_lights(thin);
  double sum = 0;
  for (std::size_t l = 0; l < 6; ++l) {
    const double *const a = &lights[4 * l], *const b = &lights[4 * (6 + l)];
    const double h = a[0] - (q[1] * a[1] + q[2] * a[2]), side = q[2] * a[1] - q[1] * a[2], square = h * h + side * side;
    const auto f = [&](double x) { return (x - q[0]) / std::hypot(x - q[0], std::sqrt(square)); };
    sum += a[3] * b[2] * h / square * (f(b[1]) - f(b[0]));
  }
  EXPECT_NEAR(j[0], 1e-9 / (4 * std::acos(-1.0)) * sum, 1e-7 * j[0]);  // the arc tangent's own error is 1e-8
}

TEST(RamaSource, is_finite_on_strips_on_the_axis_and_beyond_the_hull) {
  RamaSettings still, dark, clear;
  still.spin = 0;
  dark.power = 0;
  clear.scattering = {};
  const std::vector<Numbers> places{{10, 8, 0},
                                    {15.9, 8, 0},
                                    {5.1, 8, 0},
                                    {16.5, 8, 0},
                                    {-10, 7.5, 0},
                                    {0, 0, 0},
                                    {24, 0, 0},
                                    {-24.7, 0, 0},
                                    {-5, 7.5, 0},
                                    {-5, 7.9, 0},
                                    {-5, 0, 0},
                                    {20, 8, 0},
                                    {10, -4, 6.9282032302755088}};
  for (const char* engine : {"double", "simd", "gl"}) {
    if (!engine_or_none(engine)) continue;
    const auto kernels = kernels_on(engine);
    for (const RamaSettings& s : {RamaSettings{}, still, dark, clear}) {
      const auto j = sources(*kernels, s, places);
      for (std::size_t i = 0; i < j.size(); ++i) {
        ASSERT_TRUE(std::isfinite(j[i])) << engine << ", place " << i / 4;
        ASSERT_GE(j[i], 0) << engine << ", place " << i / 4;
      }
    }
    // On the strip the light is that of half of all directions.
    const auto on = sources(*kernels, {}, {{10, 8, 0}})[0], near = sources(*kernels, {}, {{10, 7.9, 0}})[0];
    EXPECT_GT(on, near) << engine;
  }
}

// Every ray from inside ends on the hull, at its nearest part, whose normal faces the eye.
TEST(RamaHull, is_closed_and_faces_inwards) {
  const auto kernels = kernels_on("double");
  std::uint32_t bits = 1;
  const auto random = [&bits] { return (bits = 1664525 * bits + 1013904223) / 4294967296.0 * 2 - 1; };
  int cliff = 0;
  for (int k = 0; k < 3000; ++k) {
    const double x = 22 * random(), phi = 3.14159 * random();
    const double widest = x < -5 ? 7.5 : 8, cap = x > 16 ? x - 16 : x < -16.5 ? x + 16.5 : 0;
    const double r = 0.999 * std::sqrt(std::max(widest * widest - cap * cap, 0.0)) * std::sqrt(std::fabs(random()));
    Numbers p{x, r * std::cos(phi), r * std::sin(phi)}, d{random(), random(), random()};
    // Also straight along the axis, where a ray never leaves the cylinder, and square to it.
    if (k % 5 == 0) d[1] = d[2] = 0;
    if (k % 7 == 0) d[0] = 0;
    if (k % 35 == 0) d[1] = 1;
    const double n = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (double& c : d) c /= n;
    const auto hit = kernels->call("rama.hull", {{"p", p}, {"d", d}}, {});
    Numbers q(3);
    for (std::size_t c = 0; c < 3; ++c) q[c] = p[c] + hit[0] * d[c];
    const double radius = std::hypot(q[1], q[2]);
    // On one of the five parts, to rounding.
    const bool on_cliff = std::fabs(q[0] + 5) < 1e-6 && radius > 7.5 - 1e-6 && radius < 8 + 1e-6;
    const double gap = q[0] > 16      ? std::hypot(radius, q[0] - 16) - 8
                       : q[0] > -5    ? radius - 8
                       : q[0] > -16.5 ? radius - 7.5
                                      : std::hypot(radius, q[0] + 16.5) - 7.5;
    ASSERT_TRUE(on_cliff || std::fabs(gap) < 1e-6) << "ray " << k << " ends at " << q[0] << ", r = " << radius;
    ASSERT_LT(hit[1] * d[0] + hit[2] * d[1] + hit[3] * d[2], 1e-6) << "ray " << k;
    cliff += on_cliff;
  }
  EXPECT_GT(cliff, 0) << "no ray met the cliff: the test is blind to it";
}

TEST(RamaAir, lets_light_through_in_parts_as_in_whole) {
  const auto kernels = kernels_on("double");
  const Numbers p{-3, 2, 7}, q{9, -6, 1};
  const auto through = [&](const Numbers& a, const Numbers& b) {
    return kernels->call("rama.transmittance", {{"p", a}, {"q", b}}, {{"rama", rama_fields({})}})[2];
  };
  Numbers m(3);
  for (std::size_t c = 0; c < 3; ++c) m[c] = 0.7 * p[c] + 0.3 * q[c];
  EXPECT_NEAR(through(p, q), through(p, m) * through(m, q), 1e-9);  // six points are exact to 1e-8 of the depth
  EXPECT_NEAR(through(p, q), through(q, p), 1e-14);
}

}  // namespace
}  // namespace airlight::test
