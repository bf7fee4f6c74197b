// codeflow.org's sky. Golden values: computed in double by a program that shares nothing with this one.
#include <functional>
#include <numbers>

#include "airlight/error.h"
#include "airlight/sky.h"
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

// ---- the cube map ----

std::vector<float> draw(const Sky& on, const Camera& camera, const Direction& to_sun) {
  std::vector<float> pixels;
  on.render(camera, to_sun, {}, [&](int, int, std::span<const float> rgba) {
    pixels.insert(pixels.end(), rgba.begin(), rgba.end());
    return true;
  });
  return pixels;
}

struct Frame {
  Camera camera{.projection = Projection::perspective, .width = 32, .height = 18};
  Direction sun{0, 0.6, 0.8};
  Parameters parameters{{"cube_size", Numbers{64}}};
};
/// Renders ten frames on an engine of their own. @returns how often the cube map was drawn
long redraws(const std::function<void(int, Frame&)>& change) {
  const std::shared_ptr<Engine> engine = make_engine("simd");
  for (int i = 0; i < 10; ++i) {
    Frame frame;
    change(i, frame);
    draw(Sky(built_in_atmosphere("earth"), "codeflow", engine, frame.parameters), frame.camera, frame.sun);
  }
  return engine->passes_run("codeflow.cube");
}

TEST(CodeflowCube, is_redrawn_only_when_the_sky_changes) {
  EXPECT_EQ(redraws([](int, Frame&) {}), 1) << "still camera and sun";
  EXPECT_EQ(redraws([](int i, Frame& f) {
              f.camera.azimuth = 0.1 * i;
              f.camera.altitude = 2 + i;
              f.camera.field_of_view = 1 + 0.05 * i;
            }),
            1)
      << "moving camera";
  EXPECT_EQ(redraws([](int i, Frame& f) {
              if (i >= 5) f.parameters["intensity"] = Numbers{2};
            }),
            2)
      << "one slider moved";
  EXPECT_EQ(redraws([](int i, Frame& f) { f.sun = {0, std::cos(0.1 * i), std::sin(0.1 * i)}; }), 10) << "the sun moves";
  EXPECT_EQ(redraws([](int i, Frame& f) {
              if (i >= 5) f.parameters["exposure"] = Numbers{2};
            }),
            1)
      << "how the picture is shown";
}

// A pixel of a picture is one look into the cube map; the same direction asked as a ray is marched. Faces of 512 texels have texels of
// 0.2 degrees, over which this sky, its Sun's disc apart, bends by up to 1.3 thousandths of its brightness where the horizon fades; at the
// seams of faces no more than inside, since each face's border holds the sky beyond its edge.
TEST(CodeflowCube, holds_the_sky_in_all_directions_and_at_its_seams) {
  const std::shared_ptr<Engine> engine = make_engine("simd");
  const Sky on(built_in_atmosphere("earth"), "codeflow", engine);
  const Direction to_sun{0.48, 0.6, 0.64};
  const Camera camera{.width = 256, .height = 128};
  const std::vector<float> pixels = draw(on, camera, to_sun);
  const double unit = model_info("codeflow").colours->luminance;
  std::vector<Ray> rays;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < pixels.size() / 4; ++i) {
    const Direction view = view_direction(camera, (double(i % 256) + 0.5) / 256, (double(i / 256) + 0.5) / 128);
    if (view[0] * to_sun[0] + view[1] * to_sun[1] + view[2] * to_sun[2] > std::cos(0.1)) continue;
    rays.push_back({.view = view, .sun = to_sun});
    which.push_back(i);
  }
  std::vector<double> marched(3 * rays.size());
  on.evaluate(Quantity::radiance, rays, {}, marched);
  double brightest = 0;
  for (const double v : marched) brightest = std::max(brightest, v);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(pixels[4 * which[i] + c] / unit, marched[3 * i + c], 2e-3 * brightest)
          << "view " << rays[i].view[0] << ' ' << rays[i].view[1] << ' ' << rays[i].view[2];
    }
  }
}

// ---- what may be asked ----

template <class Work>
std::string complaint(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CodeflowSky, answers_for_the_colour_of_the_sky_alone) {
  const Sky on(built_in_atmosphere("earth"), "codeflow", engine_or_none("double"));
  Numbers out(3);
  const auto ask = [&](Quantity quantity, const Ray& ray, const Numbers& wavelengths) {
    return complaint([&] { on.evaluate(quantity, std::vector<Ray>{ray}, wavelengths, out); });
  };
  EXPECT_EQ(ask(Quantity::radiance, {}, {}), "");
  EXPECT_EQ(ask(Quantity::radiance, {}, {550, 600, 650}),
            "model codeflow: wavelength 550 nm: expected none; it answers in relative red, green and blue");
  EXPECT_EQ(ask(Quantity::transmittance, {}, {}), "model codeflow says nothing on transmittance");
  EXPECT_EQ(ask(Quantity::sun_irradiance, {}, {}), "model codeflow says nothing on sun_irradiance");
  EXPECT_EQ(complaint([&] { on.surface({}, 0.5, {}, {}, {}, {}); }),
            "model codeflow says nothing on light that surfaces reflect");
  EXPECT_EQ(ask(Quantity::radiance, {.distance = 100}, {}),
            "ray 0: distance = 100: expected infinity: model codeflow knows the sky alone");
}

TEST(CodeflowSky, refuses_parameters_out_of_their_range) {
  const auto with = [](const Parameters& parameters) {
    return complaint([&] { Sky(built_in_atmosphere("earth"), "codeflow", engine_or_none("double"), parameters); });
  };
  EXPECT_EQ(with({{"intensity", Numbers{-1}}}), "codeflow.intensity = -1: expected 0 .. 10");
  EXPECT_EQ(with({{"cube_size", Numbers{100.5}}}), "codeflow.cube_size = 100.5: expected a whole number");
  EXPECT_EQ(with({{"intensty", Numbers{1}}}), "codeflow.intensty: unknown key; did you mean intensity?");
  EXPECT_EQ(with({{"variant", "articel"}}), "codeflow.variant = \"articel\": unknown; did you mean article?");
}

// Parameters at the ends of their ranges, the Sun along the view and opposite, straight up and down.
TEST(CodeflowSky, is_finite_at_the_ends_of_its_ranges) {
  std::vector<Ray> rays;
  for (const Direction view : {Direction{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0.6, 0, 0.8}})
    for (const double sign : {1.0, -1.0})
      rays.push_back({.view = view, .sun = {sign * view[0], sign * view[1], sign * view[2]}});
  Numbers out(3 * rays.size());
  const std::shared_ptr<Engine> engine = engine_or_none("simd");
  for (const ParameterInfo& key : model_info("codeflow").parameters) {
    if (key.kind == ParameterInfo::Kind::word) continue;
    for (const double v : {key.low, key.high}) {
      Sky(built_in_atmosphere("earth"), "codeflow", engine, {{std::string(key.name), Numbers{v}}})
          .evaluate(Quantity::radiance, rays, {}, out);
      for (const double light : out) EXPECT_TRUE(std::isfinite(light) && light >= 0) << key.name << " = " << v;
    }
  }
}

}  // namespace
}  // namespace airlight::test
