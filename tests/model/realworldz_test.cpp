// RealWorldz' fog and painted sky. Golden values: computed in double by a program that shares nothing with this one.
#include "model/realworldz.h"

#include "golden.h"
#include "model/realworldz_table.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;
using std::numbers::pi;

/// A place over the default planet, at an angle from (0, 1, 0) towards z.
Numbers place(double angle, double height, double ground = 60e3) {
  return {0, (ground + height) * std::cos(angle), (ground + height) * std::sin(angle)};
}
Golden fog(const char* id, Numbers x, Numbers expected) {
  return {id, "realworldz.fog_F1_F2_Ffinal", {{"x", std::move(x)}}, std::move(expected)};
}
Golden ring(const char* id, double elevation, Numbers expected) {
  return {id,
          "realworldz.optical_depth_ring",
          {{"viewer_height_m", Numbers{2}}, {"elevation_deg", Numbers{elevation}}},
          std::move(expected)};
}
Golden sky_u(const char* id, double angle, double expected) {
  return {id, "realworldz.sky_u", {{"angle_deg", Numbers{angle}}}, {expected}};
}
Golden column(const char* id, double j, double expected) {
  return {id, "realworldz.resampled_source_x", {{"dest_column", Numbers{j}}, {"dest_width", Numbers{512}}}, {expected}};
}

const std::vector<Golden> values{
    {"G5_1_a", "realworldz.shell_a_b", {}, {-1.00806452e-09, 4.39112903}},
    {"G5_2", "realworldz.shell_center_q", {}, {0, -3000, 0}, 6e4},
    fog("G5_3", place(0, 0), {0.390121, 0.39, 0.000120968}),
    fog("G5_4", place(0.05, 0), {0.390575, 0.338848, 0.0517267}),
    fog("G5_5", place(0.2, 0), {0.397355, 0.0414147, 0.35594}),
    fog("G5_6", place(0.2, 2500), {0.0738156, 0.0342108, 0.0396047}),
    {"G5_7",
     "realworldz.project_outside_point",
     {{"x", Numbers{0, 1e5, 1e5}}, {"eps", Numbers{630}}},
     {0, 67134.2, 17835.5},
     6e4},
    fog("G5_7_fog", {0, 1e5, 1e5}, {-0.888011, 0.00122204, 0}),
    sky_u("G5_8_18", 18, 0.0244717),
    sky_u("G5_8_60", 60, 0.25),
    sky_u("G5_8_90", 90, 0.5),
    sky_u("G5_8_180", 180, 1),
    column("G5_9_0", 0, 0.0198976),
    column("G5_9_10", 10, 0.091482),
    column("G5_9_256", 256, 0.500622),
    column("G5_9_511", 511, 0.980102),
    ring("G5_10", 90, {0.299587, 0.741125}),
    ring("G5_11", 20, {0.767309, 0.464261}),
    ring("G5_12", 2, {2.03022, 0.131307}),
    {"G5_13",
     "realworldz.sky_fragment",
     {{"atmos_rgba", Numbers{0.3, 0.5, 0.9, 0.8}},
      {"star_rgba", Numbers{0.6, 0.6, 0.7, 0.25}},
      {"ext", Numbers{0.95, 0.9, 0.85}},
      {"ins", Numbers{0.02, 0.03, 0.05}}},
     {0.761, 0.912, 1.291}},
};

class Realworldz : public testing::TestWithParam<GoldenCase> {};
TEST_P(Realworldz, says_what_the_source_says) { expect_golden(std::get<0>(GetParam()), std::get<1>(GetParam())); }
INSTANTIATE_TEST_SUITE_P(golden, Realworldz, on_all_engines(values), golden_name);

TEST(RealworldzShell, factor_has_all_its_printed_digits) {
  const Numbers a_b = answer("realworldz.shell_a_b", {}, *engine_or_none("double"));
  EXPECT_NEAR(a_b[0], -1.00806452e-09, 1e-17);
  EXPECT_NEAR(a_b[1], 4.39112903, 1e-8);
}

// ---- what fog is required to do, over the default planet and the snow planet ----

struct Planet {
  const char* name;
  RealworldzSettings settings;
};
void PrintTo(const Planet& p, std::ostream* out) { *out << p.name; }

class RealworldzFog : public testing::TestWithParam<Planet> {
 protected:
  double fog(const Numbers& x, const Numbers& viewer) const {
    EngineCaller kernels(*engine_or_none("double"));
    return kernels.call("realworldz.fog_anywhere", {{"x", x}, {"viewer", viewer}},
                        {{"rw", realworldz_fields(GetParam().settings)}})[2];
  }
};

TEST_P(RealworldzFog, does_not_fall_with_distance_along_a_great_circle) {
  const RealworldzSettings& s = GetParam().settings;
  for (double height : {0.0, 0.3 * (s.bounding_radius - s.ground_radius)}) {
    double last = -1;
    for (double angle = 0; angle <= pi / 2; angle += 0.01) {
      const double f = fog(place(angle, height), place(0, height));
      EXPECT_GE(f, last - 1e-12) << "height " << height << ", angle " << angle;
      last = f;
    }
  }
}

TEST_P(RealworldzFog, does_not_grow_with_height_beyond_the_clear_zone) {
  const RealworldzSettings& s = GetParam().settings;
  for (double angle : {0.5, 1.0, 1.5}) {
    double last = 2;
    for (double height = 0; height < s.bounding_radius - s.ground_radius; height += 50) {  // beyond, places are moved
      const double f = fog(place(angle, height), place(0, 2));
      EXPECT_LE(f, last + 1e-12) << "angle " << angle << ", height " << height;
      last = f;
    }
  }
}

// The jump over a metre of the viewer's way is what the slopes of F allow: far below the fog itself.
TEST_P(RealworldzFog, has_no_jump_where_the_viewer_leaves_the_bounding_sphere) {
  const RealworldzSettings& s = GetParam().settings;
  const double edge = s.bounding_radius - s.ground_radius;
  for (const Numbers& x : {place(0.3, 100), place(0.02, 0), Numbers{0, 2e5, 3e5}}) {
    const double below = fog(x, place(0, edge - 0.01)), above = fog(x, place(0, edge + 0.01));
    EXPECT_NEAR(below, above, 1e-4);
  }
}

TEST_P(RealworldzFog, is_none_at_the_viewer_where_the_zone_is_automatic) {
  RealworldzSettings s = GetParam().settings;
  s.auto_clear = true;
  EngineCaller kernels(*engine_or_none("double"));
  for (double height : {0.0, 500.0, 5000.0, 5e4}) {
    const Numbers v = place(0.7, height);
    EXPECT_EQ(kernels.call("realworldz.fog", {{"x", v}, {"viewer", v}}, {{"rw", realworldz_fields(s)}})[2], 0)
        << height;
  }
}

TEST_P(RealworldzFog, is_finite_for_a_viewer_at_the_planet_s_centre) {
  for (const Numbers& x : {Numbers{0, 0, 0}, place(0.3, 0), Numbers{0, 1e5, 0}}) {
    for (const char* engine : {"double", "simd"}) {
      EngineCaller kernels(*engine_or_none(engine));
      for (double f : kernels.call("realworldz.fog_anywhere", {{"x", x}, {"viewer", {0, 0, 0}}},
                                   {{"rw", realworldz_fields(GetParam().settings)}}))
        EXPECT_TRUE(std::isfinite(f)) << engine;
    }
  }
}

RealworldzSettings snow() {
  RealworldzSettings s;
  s.bounding_radius = 61e3, s.outer_radius = 61.2e3, s.inner_radius = 60.6e3, s.clear_width = 600, s.auto_clear = true;
  return s;
}
INSTANTIATE_TEST_SUITE_P(planets, RealworldzFog, testing::Values(Planet{"default", {}}, Planet{"snow", snow()}),
                         [](const auto& tested) { return std::string(tested.param.name); });

// ---- the sky ----

/// Optical depth of the sky's air in a direction, on the double engine.
/// @param densities  painted, from the ground up; empty: exponential
double sky_depth(double altitude, double mu, const Numbers& densities = {}) {
  EngineCaller kernels(*engine_or_none("double"));
  RealworldzSettings settings;
  settings.painted_density = !densities.empty();
  Numbers rgba(densities.empty() ? 8 : 4 * densities.size());
  for (std::size_t i = 0; i < densities.size(); ++i) rgba[4 * i] = densities[i];
  return kernels.read(kernels.run("realworldz.depth", {{"rw", realworldz_fields(settings)}},
                                  {{"densities", kernels.upload({int(rgba.size() / 4), 1}, rgba)},
                                   {"eyes", kernels.upload({1, 1}, Numbers{altitude, 0, 0, mu})}},
                                  {1, 1})[0])[0];
}

// Straight up, exp(-h/H) has an integral in closed form.
TEST(RealworldzRings, agree_with_the_column_in_closed_form_from_any_height) {
  for (double height : {0.0, 1e3, 1e4, 2e4}) {
    const double top = 15e3, expected = 2e-4 * 1500 * (std::exp(-std::min(height, top) / 1500) - std::exp(-top / 1500));
    EXPECT_NEAR(sky_depth(height, 1), expected, 1e-9) << height;
    // Down to the ground: what lies below; from space all of it.
    const double below = 2e-4 * 1500 * (1 - std::exp(-std::min(height, top) / 1500));
    EXPECT_NEAR(sky_depth(height, -1), below, 1e-9) << height;
  }
}

// Two ways along one line: from a place outwards and, seen from the other end, back.
TEST(RealworldzRings, see_the_same_air_from_both_ends_of_a_line) {
  // A line that misses the ground, its lowest point 200 m up: half of it from there, all of it from the top and from space.
  const double lowest = 60200, whole = 2 * sky_depth(200, 0);
  for (double r : {75e3, 90e3})
    EXPECT_NEAR(sky_depth(r - 60e3, -std::sqrt(1 - lowest * lowest / (r * r))), whole, 1e-8 * whole) << r;
  EXPECT_EQ(sky_depth(30e3, -0.1), 0) << "misses the air";
}

// Air painted as dense everywhere is a length of it; a painted exponential is the exponential, as far as 256 texels hold it.
TEST(RealworldzRings, take_a_painted_density_as_it_is) {
  EXPECT_NEAR(sky_depth(0, 1, Numbers(256, 1.0)), 2e-4 * 15e3, 1e-9);
  EXPECT_NEAR(sky_depth(5e3, 1, Numbers(256, 0.5)), 2e-4 * 0.5 * 10e3, 1e-9);
  // A layer from 6 km up alone: nothing of it below, all of it from under it.
  Numbers layer(256);
  std::fill(layer.begin() + 102, layer.end(), 1.0);  // 6 km of 15
  EXPECT_EQ(sky_depth(5e3, -1, layer), 0);
  EXPECT_NEAR(sky_depth(0, 1, layer), 2e-4 * 9e3, 2e-4 * 200);  // a quarter of the 0.8 km that three points stand for
  Numbers exponential;
  for (int i = 0; i < 256; ++i) exponential.push_back(std::exp(-i / 255.0 * 15e3 / 1500));
  // Linear between texels 0.039 scale heights apart: high by 0.039^2 / 12 = 1.3e-4.
  for (double mu : {1.0, 0.3, 0.0}) EXPECT_NEAR(sky_depth(2, mu, exponential) / sky_depth(2, mu), 1, 2e-4) << mu;
}

TEST(RealworldzTable, is_as_the_specification_has_it_and_its_columns_go_where_the_shader_looks) {
  const SkyTable painted = realworldz_starter();
  const SkyTable table = realworldz_resampled(painted);
  ASSERT_EQ(table.width, 512);
  // Without air only the Sun's bar is left; black is transparent.
  const double* const empty = painted.texel(200, 255);
  EXPECT_LT(empty[3], 1e-3);
  EXPECT_LT(empty[2], 1e-3);
  EXPECT_GT(painted.texel(0, 255)[3], 0.9);
  // The column painted for 18 degrees lands at u = 0.0244717: a mark there is found again.
  SkyTable marked = painted;
  for (int row = 0; row < marked.height; ++row) marked.texel(25, row)[0] = 9;  // x = 25.5 / 256
  const SkyTable found = realworldz_resampled(marked);
  int brightest = 0;
  for (int j = 0; j < found.width; ++j)
    if (found.texel(j, 0)[0] > found.texel(brightest, 0)[0]) brightest = j;
  const double half_angle = 25.5 / 256 * pi / 2;
  EXPECT_NEAR((brightest + 0.5) / 512, std::pow(std::sin(half_angle), 2), 1.0 / 512);
}

}  // namespace
}  // namespace airlight::test
