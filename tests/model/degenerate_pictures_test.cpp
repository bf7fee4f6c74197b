// Whole pictures where a formula divides by nothing: no air, the sun exactly along the view, an eye on an axis, on a light, in the middle of a
// planet. Every pixel is a finite number, and none is negative.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/sky.h"
#include "golden.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;
constexpr double degree = std::numbers::pi / 180;

Numbers n(double value) { return {value}; }

struct Case {
  const char* name;
  const char* model;
  Parameters parameters = {};
  double altitude = 0;
  double sun_elevation = 20;
  double view_elevation = 20;  ///< both look north: the middle of the middle pixel is the sun where they are equal
  bool on_double = true;       ///< off: a table of Rama's takes seconds
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Case cases[] = {
    {"hoffman_preetham_no_air", "hoffman_preetham", {{"beta_rayleigh", n(0)}, {"beta_mie", n(0)}}},
    {"hoffman_preetham_no_air_from_textures",
     "hoffman_preetham",
     {{"renderer", "texture"}, {"beta_rayleigh", n(0)}, {"beta_mie", n(0)}}},
    {"hoffman_preetham_no_air_at_pixels",
     "hoffman_preetham",
     {{"renderer", "pixel"}, {"beta_rayleigh", n(0)}, {"beta_mie", n(0)}, {"dome", "per_species"}}},
    {"hoffman_preetham_sharpest_peak", "hoffman_preetham", {{"renderer", "pixel"}, {"g", n(-0.999)}}},
    {"hoffman_preetham_sharpest_peak_from_textures", "hoffman_preetham", {{"renderer", "texture"}, {"g", n(-0.999)}}},
    {"hoffman_preetham_sun_on_the_horizon", "hoffman_preetham", {{"sunlight", "dome"}}, 0, 0, 0},
    {"hoffman_preetham_sun_in_the_zenith", "hoffman_preetham", {}, 0, 90, 90},
    {"hoffman_preetham_sun_below", "hoffman_preetham", {{"renderer", "pixel"}}, 0, -90, -90},
    {"hoffman_preetham_wires", "hoffman_preetham", {{"show", "wireframe"}}, 0, 90, 90},
    {"hoffman_preetham_wires_below", "hoffman_preetham", {{"show", "wireframe"}}, 0, -90, -90},
    {"codeflow_no_light", "codeflow", {{"intensity", n(0)}, {"cube_size", n(64)}}},
    {"codeflow_sun_along_the_view", "codeflow", {{"cube_size", n(64)}}},
    {"codeflow_sun_in_the_zenith", "codeflow", {{"cube_size", n(64)}}, 0, 90, 90},
    {"jetlag_sun_along_the_view", "jetlag", {{"frames", n(1)}}},
    {"jetlag_sun_in_the_zenith", "jetlag", {{"mode", "clear"}}, 0, 90, 90},
    {"jetlag_on_top_of_the_air", "jetlag", {{"mode", "clear"}}, 20e3, 0, 0},
    {"realworldz_sun_along_the_view", "realworldz"},
    {"realworldz_no_air", "realworldz", {{"k", n(0)}}},
    {"realworldz_in_the_planet_s_centre", "realworldz", {{"autoC", n(1)}}, -60e3},
    {"realworldz_on_the_outer_shell", "realworldz", {}, 6e3},
    {"rama_on_the_axis", "rama", {{"x", n(0)}, {"source", "own"}}, 8000, 20, 90},
    {"rama_along_the_axis", "rama", {{"x", n(0)}, {"source", "own"}}, 8000, 20, 0},
    {"rama_on_a_strip_of_light", "rama", {{"x", n(10)}, {"phi", n(0)}, {"source", "own"}}, 0, 20, 90},
    {"rama_on_a_southern_strip", "rama", {{"x", n(-10)}, {"phi", n(120)}, {"source", "own"}}, 0, 20, 0},
    {"rama_no_air", "rama", {{"air", n(0)}, {"source", "own"}}},
    {"rama_air_that_scatters_nothing", "rama", {{"beta", Numbers{0, 0, 0}}}, 8000, 20, 0, false},
};

class DegeneratePicture : public testing::TestWithParam<Case> {};

TEST_P(DegeneratePicture, is_finite) {
  const Case& c = GetParam();
  for (const char* engine : {"double", "simd"}) {
    if (!c.on_double && engine == std::string("double")) continue;
    const Sky sky(built_in_atmosphere("earth"), c.model, engine_or_none(engine), c.parameters);
    // Odd sizes: one pixel's middle is the picture's.
    const Camera camera{.projection = Projection::perspective,
                        .width = 25,
                        .height = 15,
                        .altitude = c.altitude,
                        .azimuth = 0,
                        .elevation = c.view_elevation * degree,
                        .field_of_view = 100 * degree};
    sky.render(camera, direction(0, c.sun_elevation * degree), {.sun_disc = true, .wavelengths = {}},
               [&](int, int, std::span<const float> rgba) {
                 for (const float v : rgba) EXPECT_TRUE(std::isfinite(v) && v >= 0) << c.name << " on " << engine;
                 return true;
               });
  }
}
INSTANTIATE_TEST_SUITE_P(published, DegeneratePicture, testing::ValuesIn(cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

// A picture's eye is never below the ground; the function that shades asks for no such thing.
TEST(DegenerateViewer, in_the_middle_of_the_planet_sees_fog_all_round) {
  for (const char* engine : {"double", "simd"}) {
    const auto fog = answer("realworldz.fog_F1_F2_Ffinal", {{"x", Numbers{0, 60e3, 0}}, {"viewer", Numbers{0, 0, 0}}},
                            *engine_or_none(engine));
    for (const double v : fog) EXPECT_TRUE(std::isfinite(v)) << engine;
  }
}

}  // namespace
}  // namespace airlight::test
