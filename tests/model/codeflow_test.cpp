// codeflow.org's sky. Golden values: computed in double by a program that shares nothing with this one.
#include <numbers>

#include "golden.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;

/// y up; azimuth 0 looks along -z [degrees].
Numbers dir(double azimuth, double elevation) {
  const double az = azimuth * std::numbers::pi / 180, el = elevation * std::numbers::pi / 180;
  return {std::cos(el) * std::sin(az), std::sin(el), -std::cos(el) * std::cos(az)};
}
Numbers sun(double e) { return {0, e / std::hypot(e, 1), -1 / std::hypot(e, 1)}; }

Golden pixel(const char* id, const char* variant, double e, double azimuth, double elevation, Numbers expected) {
  return {id,
          "codeflow.sky_pixel",
          {{"variant", variant}, {"view", dir(azimuth, elevation)}, {"sun", sun(e)}},
          std::move(expected)};
}

const Numbers eye{0, 0.99, 0};
const double three_degrees = std::cos(3 * std::numbers::pi / 180);

// The spot before its brightness is smoothstep(0, spotMax, phase(a, spotG)): the phase functions that give 0.446494 and at least 25.
const std::vector<Golden> values{
    {"G3_1_forward", "codeflow.phase", {{"alpha", Numbers{1}}, {"g", Numbers{0.63}}}, {14.9024}},
    {"G3_1_across", "codeflow.phase", {{"alpha", Numbers{0}}, {"g", Numbers{0.63}}}, {0.228603}},
    {"G3_1_backward", "codeflow.phase", {{"alpha", Numbers{-1}}, {"g", Numbers{-0.01}}}, {1.54568}},
    {"G3_3_up", "codeflow.atmospheric_depth", {{"position", eye}, {"dir", dir(0, 90)}}, {0.01}},
    {"G3_3_level", "codeflow.atmospheric_depth", {{"position", eye}, {"dir", dir(0, 0)}}, {0.141067}},
    {"G3_3_down", "codeflow.atmospheric_depth", {{"position", eye}, {"dir", dir(0, -90)}}, {1.99}},
    {"G3_4_0", "codeflow.horizon_extinction", {{"position", eye}, {"dir", dir(0, 0)}, {"radius", Numbers{0.84}}}, {1}},
    {"G3_4_15",
     "codeflow.horizon_extinction",
     {{"position", eye}, {"dir", dir(0, -15)}, {"radius", Numbers{0.84}}},
     {0.674219}},
    {"G3_4_25",
     "codeflow.horizon_extinction",
     {{"position", eye}, {"dir", dir(0, -25)}, {"radius", Numbers{0.84}}},
     {0.00119735}},
    {"G3_4_32",
     "codeflow.horizon_extinction",
     {{"position", eye}, {"dir", dir(0, -32)}, {"radius", Numbers{0.84}}},
     {0}},
    {"G3_5_eye",
     "codeflow.absorb",
     {{"dist", Numbers{0.3}}, {"color", Numbers{1, 1, 1}}, {"factor", Numbers{0.239}}},
     {0.735156, 0.4263, 0.280422}},
    {"G3_5_sun",
     "codeflow.absorb",
     {{"dist", Numbers{0.01}}, {"color", Numbers{1, 1, 1}}, {"factor", Numbers{0.028}}},
     {0.990624, 0.858139, 0.685457}},
    pixel("G3_6", "article", 1, 0, 10, {0.499625, 0.729608, 0.730762}),
    pixel("G3_7", "article", 1, 90, 30, {0.109196, 0.207204, 0.227932}),
    pixel("G3_8", "article", 1, 180, -3, {0.671345, 1.16371, 0.973488}),
    pixel("G3_9", "repository", 1, 0, 10, {0.499658, 0.729629, 0.730776}),
    pixel("G3_10", "article", 0.05, 0, 10, {0.918073, 0.566646, 0.382771}),
    pixel("G3_11", "article", 0.05, 90, 30, {0.0489957, 0.0632414, 0.054165}),
    pixel("G3_12", "article", 0.05, 180, -3, {0.209496, 0.218978, 0.153569}),
    pixel("G3_13", "repository", 0.05, 0, 10, {1.2136, 0.681508, 0.438457}),
};

class Codeflow : public testing::TestWithParam<GoldenCase> {};
TEST_P(Codeflow, says_what_the_source_says) { expect_golden(std::get<0>(GetParam()), std::get<1>(GetParam())); }
INSTANTIATE_TEST_SUITE_P(golden, Codeflow, on_all_engines(values), golden_name);

// G3.2: the spot three degrees from the Sun, before its brightness.
TEST(CodeflowSpot, is_what_the_source_says_at_three_degrees) {
  const auto spot = [](double g, double most) {
    const double t = std::min(
        answer("codeflow.phase", {{"alpha", Numbers{three_degrees}}, {"g", Numbers{g}}}, *engine_or_none("double"))[0] /
            most,
        1.0);
    return t * t * (3 - 2 * t);
  };
  EXPECT_NEAR(spot(0.9995, 15), 0.446494, 1.5e-6);  // 2e-6 of 1, print included
  EXPECT_NEAR(spot(0.995, 25), 1, 1e-12);
}

}  // namespace
}  // namespace airlight::test
