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

// ---- properties ----

struct Lit {
  Numbers light, through;
};
struct Look {
  double height;         ///< [m] of the eye, x and z being 0
  Numbers view, to_sun;  ///< y up: the rays pass has the world's z up
};
/// One row of rays at a time: the noise alone is a table of 32 MB.
std::vector<Lit> look(Engine& engine, const JetlagSettings& settings, const std::vector<Look>& rays) {
  EngineCaller kernels(engine);
  static const std::vector<double> noise = jetlag_noise_texels();
  const Shape shape{int(rays.size()), 1};
  Numbers eyes, suns;
  for (const Look& r : rays) {
    eyes.insert(eyes.end(), {r.height, r.view[0], -r.view[2], r.view[1]});
    suns.insert(suns.end(), {1e15, r.to_sun[0], -r.to_sun[2], r.to_sun[1]});
  }
  const auto answers = kernels.run("jetlag.rays", {{"jetlag", jetlag_fields(settings)}, {"drift", jetlag_drift(20)}},
                                   {{"noise", kernels.upload({jetlag_noise_size, jetlag_noise_size}, noise)},
                                    {"eyes", kernels.upload(shape, eyes)},
                                    {"suns", kernels.upload(shape, suns)}},
                                   shape);
  const Numbers light = kernels.read(answers[0]), through = kernels.read(answers[1]);
  std::vector<Lit> lit;
  for (std::size_t i = 0; i < light.size(); i += 4)
    lit.push_back({{light[i], light[i + 1], light[i + 2]}, {through[i], through[i + 1], through[i + 2]}});
  return lit;
}

// Towards the Sun, away from it, up, down, level; eyes on the ground, in a cloud, at the top of the air and above; the Sun down to nadir.
TEST(JetlagRays, are_finite_and_not_negative_whatever_is_asked) {
  JetlagSettings clear, dark, coarse;
  clear.clouds = false;
  dark.sun_intensity = 0;
  coarse.near_steps = coarse.far_steps = coarse.short_steps = 1;
  std::vector<Look> rays;
  for (double height : {0.0, 1700.0, 20000.0, 50000.0})
    for (const Numbers& view :
         {dir(0, 90), dir(0, -90), dir(0, 0), dir(45, 3), dir(45, -3), sun, Numbers{-sun[0], -sun[1], -sun[2]}})
      for (const Numbers& to_sun : {sun, dir(0, 90), dir(0, 0), dir(30, -2), dir(0, -90)})
        rays.push_back({height, view, to_sun});
  for (const char* name : {"double", "simd"}) {
    for (const JetlagSettings& settings : {JetlagSettings{}, clear, dark, coarse}) {
      const auto lit = look(*engine_or_none(name), settings, rays);
      for (std::size_t i = 0; i < lit.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_TRUE(std::isfinite(lit[i].light[c])) << name << ", ray " << i;
          ASSERT_GE(lit[i].light[c], 0) << name << ", ray " << i;
          ASSERT_TRUE(lit[i].through[c] >= 0 && lit[i].through[c] <= 1) << name << ", ray " << i;
        }
      }
    }
  }
}

// Sampled at the middles of many steps, the transmittance straight up is that of two exponentials in closed form.
TEST(JetlagRays, straight_up_lose_what_the_exponential_atmospheres_hold) {
  JetlagSettings fine;
  fine.clouds = false;
  fine.midpoint = true;
  fine.jitter_view = fine.jitter_light = 0.5;
  fine.short_steps = 1024;
  const auto column = [](double scale) { return scale * (1 - std::exp(-20000 / scale)); };
  const Lit lit = look(*engine_or_none("double"), fine, {{0, dir(0, 90), dir(0, 90)}})[0];
  const double rayleigh[] = {5.8e-6, 13.5e-6, 33.1e-6};
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(lit.through[c], std::exp(-rayleigh[c] * column(8000) - 2.2e-5 * column(1200)),
                1e-6);  // 1024 midpoints: (20/1.2/1024)^2 / 24
}

// As the source says of its own sums: steps that begin at their dense ends darken a sky with a low Sun, blue by a factor of two and more.
TEST(JetlagRays, of_few_steps_are_darker_than_converged_ones) {
  JetlagSettings few, many;
  few.clouds = many.clouds = false;
  many.midpoint = true;
  many.jitter_view = many.jitter_light = 0.5;
  many.short_steps = many.clear_light_steps = 256;
  std::vector<Look> rays;
  for (double elevation : {2.0, 5.0, 10.0, 20.0, 40.0}) rays.push_back({200, dir(135, elevation), dir(135, 8)});
  const auto coarse = look(*engine_or_none("double"), few, rays), fine = look(*engine_or_none("double"), many, rays);
  double most = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_GT(fine[i].light[2], coarse[i].light[2]) << "ray " << i;
    most = std::max(most, fine[i].light[2] / coarse[i].light[2]);
  }
  EXPECT_GT(most, 2);
}

}  // namespace
}  // namespace airlight::test
