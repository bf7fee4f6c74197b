// Hoffman & Preetham's haze and dome. Golden values: computed in double by a program that shares nothing with this one.
#include <algorithm>
#include <array>
#include <numbers>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "golden.h"
#include "model/virtual_dome.h"

namespace airlight::test {
namespace {

using Numbers = std::vector<double>;
constexpr double degree = std::numbers::pi / 180;
const double half = std::numbers::sqrt2 / 2;

Numbers n(double v) { return {v}; }
Numbers at(double elevation) { return {std::cos(elevation * degree), 0, std::sin(elevation * degree)}; }

Golden sky(const char* id, Numbers view, Numbers expected) {
  return {id,
          "hoffman_preetham.sky",
          {{"preset", "clear"}, {"sunlight", "dome"}, {"view", std::move(view)}, {"sun", at(60)}},
          std::move(expected),
          0};
}

const std::vector<Golden> values{
    {"G1_1",
     "hoffman_preetham.beta_rayleigh",
     {{"lambda_m", Numbers{650e-9, 570e-9, 475e-9}}},
     {6.95265e-06, 1.17572e-05, 2.43797e-05},
     0},
    {"G1_2",
     "hoffman_preetham.beta_mie_thesis",
     {{"lambda_m", Numbers{650e-9, 570e-9, 475e-9}}, {"K", Numbers{0.685, 0.679, 0.670}}, {"turbidity", n(2)}},
     {0.0057406, 0.00739969, 0.0105143},
     0},
    {"G1_3_printed",
     "hoffman_preetham.phase_hg",
     {{"g", n(-0.75)}, {"cos_view_sun", n(1)}, {"mode", "printed"}},
     {15.5972},
     0},
    {"G1_3_normalized",
     "hoffman_preetham.phase_hg",
     {{"g", n(-0.75)}, {"cos_view_sun", n(1)}, {"mode", "normalized"}},
     {2.22817},
     0},
    {"G1_4_printed",
     "hoffman_preetham.phase_hg",
     {{"g", n(-0.75)}, {"cos_view_sun", n(-0.5)}, {"mode", "printed"}},
     {0.0693017},
     0},
    {"G1_4_normalized", "hoffman_preetham.phase_hg", {{"g", n(-0.75)}, {"cos_view_sun", n(-0.5)}}, {0.00990024}, 0},
    {"G1_5", "hoffman_preetham.phase_rayleigh", {{"cos_view_sun", n(0.5)}}, {0.0746039}, 0},
    {"G1_6", "hoffman_preetham.extinction", {{"s_m", n(1e4)}}, {0.914364, 0.871472, 0.768129}, 0},
    {"G1_7",
     "hoffman_preetham.inscatter",
     {{"cos_view_sun", n(0.5)}, {"s_m", n(1e4)}},
     {0.00587096, 0.00908297, 0.0168227},
     0},
    {"G1_8",
     "hoffman_preetham.inscatter",
     {{"cos_view_sun", n(0.5)}, {"s_m", n(1e4)}, {"mode", "printed"}},
     {0.0113275, 0.0144124, 0.0218367},
     0},
    {"G1_9",
     "hoffman_preetham.shade",
     {{"preset", "clear"}, {"L0", Numbers{0.2, 0.3, 0.1}}, {"cos_view_sun", n(0.5)}, {"s_m", n(1e4)}},
     {0.188744, 0.270524, 0.0936356},
     0},
    {"G1_10_0", "hoffman_preetham.dome_R_integral", {{"zenith_deg", n(0)}}, {7999.97}, 0},
    {"G1_10_60", "hoffman_preetham.dome_R_integral", {{"zenith_deg", n(60)}}, {15940.5}, 0},
    {"G1_10_85", "hoffman_preetham.dome_R_integral", {{"zenith_deg", n(85)}}, {81106.4}, 0},
    {"G1_10_90", "hoffman_preetham.dome_R_integral", {{"zenith_deg", n(90)}}, {282838}, 0},
    {"G1_11_0", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(0)}, {"species", "rayleigh"}}, {7997.8}, 0},
    {"G1_11_60", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(60)}, {"species", "rayleigh"}}, {15949.3}, 0},
    {"G1_11_85", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(85)}, {"species", "rayleigh"}}, {81050.5}, 0},
    {"G1_11_90", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(90)}, {"species", "rayleigh"}}, {282949}, 0},
    {"G1_12_0", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(0)}, {"species", "mie"}}, {1199.93}, 0},
    {"G1_12_60", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(60)}, {"species", "mie"}}, {2398.81}, 0},
    {"G1_12_85", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(85)}, {"species", "mie"}}, {13445.4}, 0},
    {"G1_12_90", "hoffman_preetham.dome_R_fit", {{"zenith_deg", n(90)}, {"species", "mie"}}, {109229}, 0},
    {"G1_13_0", "hoffman_preetham.air_mass", {{"zenith_deg", n(0)}}, {0.999494}, 0},
    {"G1_13_60", "hoffman_preetham.air_mass", {{"zenith_deg", n(60)}}, {1.99276}, 0},
    {"G1_13_90", "hoffman_preetham.air_mass", {{"zenith_deg", n(90)}}, {36.5103}, 0},
    {"G1_14",
     "hoffman_preetham.sun_attenuation_rgb",
     {{"zenith_deg", n(45)}, {"turbidity", n(2)}},
     {0.830292, 0.772607, 0.651012},
     0},
    {"G1_14_ozone",
     "hoffman_preetham.sun_attenuation_rgb",
     {{"zenith_deg", n(45)}, {"ozone", n(1)}},
     {0.803251, 0.728123, 0.647323},
     0},
    sky("G1_16", {0, 0, 1}, {0.00881897, 0.0116254, 0.017302}),
    sky("G1_17", {half, 0, half}, {0.0259282, 0.0292621, 0.0354699}),
    sky("G1_18", {-std::cos(2 * degree), 0, std::sin(2 * degree)}, {0.039923, 0.0489173, 0.0523277}),
};

class HoffmanPreetham : public testing::TestWithParam<GoldenCase> {};
TEST_P(HoffmanPreetham, says_what_the_source_says) { expect_golden(std::get<0>(GetParam()), std::get<1>(GetParam())); }
INSTANTIATE_TEST_SUITE_P(golden, HoffmanPreetham, on_all_engines(values), golden_name);

// ---- through Sky ----

class HoffmanPreethamSky : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    engine = engine_or_none(GetParam());
    if (!engine) GTEST_SKIP() << "no engine " << GetParam() << " on this machine";
  }
  Numbers ask(Quantity quantity, const Ray& ray, const Parameters& parameters) const {
    const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine, parameters);
    Numbers out(3);
    sky.evaluate(quantity, std::vector<Ray>{ray}, Numbers{650, 570, 475}, out);
    return out;
  }
  std::shared_ptr<Engine> engine;
};

// G1.15 and G1.16 asked of the common interface: sunlight at the ground through the dome, and the sky.
TEST_P(HoffmanPreethamSky, answers_as_the_named_functions_do) {
  const Numbers sun = ask(Quantity::sun_irradiance, {.sun = {half, 0, half}}, {{"sunlight", "dome"}});
  const Numbers expected{0.903784, 0.856024, 0.742234};
  const Numbers sky =
      ask(Quantity::radiance, {.view = {0, 0, 1}, .sun = {0.5, 0, std::cos(30 * degree)}}, {{"sunlight", "dome"}});
  const Numbers zenith{0.00881897, 0.0116254, 0.017302};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sun[c], expected[c], 3e-4 * expected[c]);
    EXPECT_NEAR(sky[c], zenith[c], 3e-4 * zenith[c]);
  }
}

// dL_in/ds = beta_ang E - beta_ex L_in: what two halves of a path add is what the whole adds, and transmittances multiply. The same holds
// of any formula that solves the equation.
TEST_P(HoffmanPreethamSky, air_adds_up_along_a_path) {
  Ray ray{.view = {0.6, 0, 0.8}, .sun = {0, 0.6, 0.8}, .distance = 10e3};
  const Numbers light1 = ask(Quantity::radiance, ray, {}), left1 = ask(Quantity::transmittance, ray, {});
  ray.distance = 20e3;
  const Numbers light2 = ask(Quantity::radiance, ray, {}), left2 = ask(Quantity::transmittance, ray, {});
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(left2[c], left1[c] * left1[c], 1e-5) << "float holds 1e-7 of 1";
    EXPECT_NEAR(light2[c], light1[c] + left1[c] * light1[c], 1e-5 * light2[c]);
  }
}

// The points of a picture with depth are the same question: L = L0 F_ex + L_in. Sunlight comes from a table there: a float rounds differently.
TEST_P(HoffmanPreethamSky, hazes_points_as_rays) {
  const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine, {{"renderer", "pixel"}});
  const Direction sun{0, 0.6, 0.8}, view{0.6, 0, 0.8};
  const std::vector<Sight> points{{.view = view, .distance = 10e3}, {.view = view}};
  Numbers light(6), left(6);
  sky.haze(0, sun, points, Numbers{650, 570, 475}, nullptr, light, left);
  for (std::size_t i = 0; i < 2; ++i) {
    const Ray ray{.view = view, .sun = sun, .distance = points[i].distance};
    const Numbers expected = ask(Quantity::radiance, ray, {}), through = ask(Quantity::transmittance, ray, {});
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(light[3 * i + c], expected[c], 1e-6 * expected[c]);
      EXPECT_NEAR(left[3 * i + c], through[c], 1e-6);
    }
  }
}

// Skylight on level ground: the sum over the sky's own rays, 256 directions against 60 rings of 120. The sum's directions miss a part of the
// aureole, 2 % of the whole with the sun 20 degrees high.
TEST_P(HoffmanPreethamSky, lights_level_ground_as_all_its_rays_do) {
  const Direction sun = direction(0, 20 * degree);
  const Numbers got = ask(Quantity::sky_irradiance, {.view = {0, 0, 1}, .sun = sun}, {});
  constexpr int rings = 60, spokes = 120;
  std::vector<Ray> rays;
  for (int i = 0; i < rings; ++i) {
    const double z = (i + 0.5) / rings;  // rings of equal solid angle
    for (int k = 0; k < spokes; ++k) {
      const double azimuth = (k + 0.5) * 2 * std::numbers::pi / spokes, across = std::sqrt(1 - z * z);
      rays.push_back({.view = {across * std::sin(azimuth), across * std::cos(azimuth), z}, .sun = sun});
    }
  }
  const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine);
  Numbers light(3 * rays.size()), sum(3);
  sky.evaluate(Quantity::radiance, rays, Numbers{650, 570, 475}, light);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += light[3 * i + c] * rays[i].view[2] * 2 * std::numbers::pi / double(rays.size());
  }
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], sum[c], 0.02 * sum[c]);
}

// The wires of the dome are white where they are, and end two degrees below the horizon.
TEST_P(HoffmanPreethamSky, draws_the_dome_s_wires_and_skirt) {
  const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine, {{"show", "wireframe"}});
  const Camera camera{.projection = Projection::perspective, .width = 200, .height = 200, .field_of_view = 20 * degree};
  std::vector<float> pixels;
  sky.render(camera, direction(180 * degree, 40 * degree), {.sun_disc = false, .wavelengths = {}},
             [&](int, int, std::span<const float> rgba) {
               pixels.insert(pixels.end(), rgba.begin(), rgba.end());
               return true;
             });
  const double white = 1.33e5 / 20;
  int wires[2] = {0, 0}, below = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const std::size_t x = i / 4 % 200, y = i / 4 / 200;
    const Direction v = view_direction(camera, (double(x) + 0.5) / 200, (double(y) + 0.5) / 200);
    const double elevation = std::asin(v[2]) / degree;
    if (elevation < -2.1) {
      EXPECT_EQ(pixels[i], 0) << elevation;
      ++below;
    } else if (std::abs(elevation + 1) < 0.8 || std::abs(elevation - 4) < 3) {
      wires[elevation > 0] += pixels[i] > 0.99 * white;
    }
  }
  EXPECT_GT(below, 1000);
  EXPECT_GT(wires[0], 30) << "the skirt's";
  EXPECT_GT(wires[1], 300) << "the rings crowd towards the horizon";
}

INSTANTIATE_TEST_SUITE_P(engines, HoffmanPreethamSky, testing::Values("double", "simd", "gl"),
                         [](const auto& tested) { return std::string(tested.param); });

// Both phase functions integrate to 1 over the sphere; the printed one to (1 - g) / (1 + g), 7 for g = -0.75. The midpoint rule with points
// that crowd towards the peak is right to 1e-6.
TEST(HoffmanPreethamPhase, integrates_to_what_the_specification_says) {
  const auto integral = [](const char* mode) {
    double sum = 0;
    constexpr int points = 2000;
    for (int i = 0; i < points; ++i) {
      // Points crowd towards the peak: cos = 1 - 2 t^2.
      const double t = (i + 0.5) / points;
      sum += 4 * t *
             answer("hoffman_preetham.phase_hg", {{"g", n(-0.75)}, {"cos_view_sun", n(1 - 2 * t * t)}, {"mode", mode}},
                    *engine_or_none("double"))[0];
    }
    return 2 * std::numbers::pi * sum / points;
  };
  EXPECT_NEAR(integral("normalized"), 1, 1e-5);
  EXPECT_NEAR(integral("printed"), 7, 7e-5);
}

// The specification allows 0.35 % between the surface and the integral, for Earth and for planets it was not made for.
TEST(VirtualDome, is_fitted_for_other_planets_too) {
  for (const DomeAir air : {DomeAir{}, DomeAir{.height = 1200}, DomeAir{.height = 500}, DomeAir{.height = 16000},
                            DomeAir{.height = 11100, .radius = 3.39e6}, DomeAir{.height = 15900, .radius = 6.052e6},
                            DomeAir{.height = 16000, .radius = 2e6}, DomeAir{.height = 500, .radius = 1e8}}) {
    const DomeFit fit = fit_dome(air);
    for (int i = 0; i <= 360; ++i) {
      const double zenith = i * 0.25 * degree, path = dome_path(air, zenith);
      ASSERT_NEAR(fit.at(zenith), path, 0.0035 * path)
          << "height " << air.height << ", radius " << air.radius << ", " << i * 0.25 << " degrees";
    }
  }
}

// ---- renderers ----

/// The sky over a preset's own sun, which stands in the north.
struct Shot {
  Parameters parameters;
  double elevation = 60;
  Camera camera{.width = 128, .height = 64};
  bool disc = false;

  std::vector<float> draw(Engine& on) const {
    const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", std::shared_ptr<Engine>(&on, [](Engine*) {}),
                  parameters);
    std::vector<float> pixels;
    sky.render(camera, direction(0, elevation * degree), {.sun_disc = disc, .wavelengths = {}},
               [&](int, int, std::span<const float> rgba) {
                 pixels.insert(pixels.end(), rgba.begin(), rgba.end());
                 return true;
               });
    return pixels;
  }
};

/// Mean and largest difference of two pictures, of the brightest.
struct Apart {
  double mean = 0, most = 0;
};
Apart apart(const std::vector<float>& a, const std::vector<float>& b, double from_sun = 0, const Shot& shot = {}) {
  double brightest = 0, sum = 0, count = 0;
  Apart result;
  for (const float v : b) brightest = std::max(brightest, double(v));
  const Direction sun = direction(0, shot.elevation * degree);
  for (std::size_t i = 0; i < a.size(); i += 4) {
    const std::size_t x = i / 4 % std::size_t(shot.camera.width), y = i / 4 / std::size_t(shot.camera.width);
    const Direction v =
        view_direction(shot.camera, (double(x) + 0.5) / shot.camera.width, (double(y) + 0.5) / shot.camera.height);
    // Below the horizon the mesh repeats it and the formula goes on: that is no error of either.
    if (v[2] < 0 || v[0] * sun[0] + v[1] * sun[1] + v[2] * sun[2] > std::cos(from_sun)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = std::abs(double(a[i + c]) - b[i + c]) / brightest;
      result.most = std::max(result.most, d);
      sum += d, ++count;
    }
  }
  result.mean = sum / count;
  return result;
}

TEST_P(HoffmanPreethamSky, pictures_of_all_engines_agree) {
  for (const char* renderer : {"vertex", "texture", "pixel"}) {
    const Shot shot{.parameters = {{"renderer", renderer}}, .disc = true};
    // Which triangle a pixel lies on, and the disc's soft edge, are decided in float; both sides agree on the border.
    EXPECT_LT(apart(shot.draw(*engine), shot.draw(*engine_or_none("double"))).mean, 3e-6) << renderer;
  }
}

// Between corners the mesh is linear: away from the sun's peak the error falls with the square of the triangles' size (64 x 33 corners,
// then 128 x 65), and the coarse mesh shows facets around the sun that the formula has not.
TEST(HoffmanPreethamVertex, meets_the_formula_as_the_mesh_grows_finer) {
  Engine& engine = *engine_or_none("double");
  const auto error = [&](double columns, double rings, double from_sun) {
    const Shot shot{.parameters = {{"renderer", "vertex"}, {"dome_columns", n(columns)}, {"dome_rings", n(rings)}}};
    Shot formula = shot;
    formula.parameters = {{"renderer", "pixel"}};
    return apart(shot.draw(engine), formula.draw(engine), from_sun, shot);
  };
  const Apart coarse = error(64, 33, 0.3), fine = error(128, 65, 0.3);
  const double order = std::log2(coarse.mean / fine.mean);
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 2.3);
  EXPECT_LT(coarse.mean, 2e-3) << "of the brightest";
  EXPECT_GT(error(64, 33, 0).most, 3 * coarse.most) << "facets around the sun";
}

// The specification: within 1 % of the peak value from 0 to 100 km for beta_mie up to 5e-4.
TEST(HoffmanPreethamTexture, meets_the_formula_within_one_percent_of_its_peak) {
  for (const char* name : {"double", "simd"}) {
    Engine& engine = *engine_or_none(name);
    EngineCaller kernels(engine);
    for (const double beta_mie : {2e-6, 5e-5, 5e-4}) {
      const Values own = model_parameters(find_model("hoffman_preetham"), {{"beta_mie", n(beta_mie)}}, "");
      const Fields air = find_model("hoffman_preetham").fields("hoffman_preetham", {0, 0, 0, &own});
      const auto texture = [&](const char* pass, Shape shape) {
        return kernels.run(
            pass, {{"hoffman_preetham", air}, {"size", {{"width", n(shape.width)}, {"height", n(shape.height)}}}}, {},
            shape)[0];
      };
      const Table left = texture("hoffman_preetham.extinction_texture", {256, 1, 1});
      const Table light = texture("hoffman_preetham.inscatter_texture", {256, 128, 1});
      constexpr int distances = 200, angles = 91;
      std::vector<double> paths;
      for (int i = 0; i < distances; ++i) {
        for (int j = 0; j < angles; ++j)
          paths.insert(paths.end(), {100e3 * i / (distances - 1), 1 - std::cos(2 * j * degree), 0, 0});
      }
      const Shape shape{angles, distances, 1};
      const auto got = kernels.run(
          "hoffman_preetham.texture_rays", {},
          {{"extinction_texture", left}, {"inscatter_texture", light}, {"paths", kernels.upload(shape, paths)}}, shape);
      const auto added = kernels.read(got[0]), through = kernels.read(got[1]);
      double peak = 0, worst = 0, worst_left = 0;
      for (std::size_t i = 0; i < shape.texels(); ++i) {
        const auto exact = kernels.call("hoffman_preetham.terms",
                                        {{"rayleigh_path", n(paths[4 * i])},
                                         {"mie_path", n(paths[4 * i])},
                                         {"one_minus_cos", n(paths[4 * i + 1])},
                                         {"sunlight", {1, 1, 1}}},
                                        {{"air", air}});
        if (name == std::string("simd") && i % 97) continue;  // its own textures; the formula is double's to 1e-6
        for (std::size_t c = 0; c < 3; ++c) {
          peak = std::max(peak, exact[c]);
          worst = std::max(worst, std::abs(added[4 * i + c] - exact[c]));
          worst_left = std::max(worst_left, std::abs(through[4 * i + c] - exact[3 + c]));
        }
      }
      EXPECT_LT(worst, 0.01 * peak) << "beta_mie " << beta_mie << " on " << name;
      EXPECT_LT(worst_left, 0.01) << "beta_mie " << beta_mie << " on " << name;
    }
  }
}

// ---- presets: what the specification says that a viewer must be able to check ----

std::array<double, 3> seen(const char* preset, double azimuth, double elevation) {
  const ModelInfo model = model_info("hoffman_preetham");
  const auto found = std::ranges::find(model.presets, preset, &Preset::name);
  const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine_or_none("double"), {{"preset", preset}});
  const Ray ray{.view = direction(azimuth * degree, elevation * degree),
                .sun = direction(0, *found->sun_elevation * degree)};
  std::array<double, 3> rgb{};
  sky.evaluate(Quantity::radiance, std::span(&ray, 1), Numbers{650, 570, 475}, rgb);
  return rgb;
}

TEST(HoffmanPreethamPresets, look_as_they_are_meant_to) {
  const auto high = seen("clear", 180, 40), low = seen("clear", 180, 1);
  EXPECT_GT(high[2], 1.3 * high[0]) << "a clear sky is blue away from the sun";
  EXPECT_LT(low[2] / low[0], 0.7 * high[2] / high[0]) << "and whiter at the horizon";
  const auto grey = seen("overcast", 120, 30);
  EXPECT_NEAR(grey[0] / grey[1], 1, 0.05);
  EXPECT_NEAR(grey[2] / grey[1], 1, 0.05);
  const auto glow = seen("sunset", 5, 3), opposite = seen("sunset", 180, 3);
  EXPECT_GT(glow[0], glow[1]);
  EXPECT_GT(glow[1], glow[2]);
  EXPECT_GT(glow[0], 3 * opposite[0]) << "directional";
  const auto mars = seen("mars", 180, 30);
  EXPECT_GT(mars[0], mars[1]);
  EXPECT_GT(mars[1], mars[2]);
}

// ---- the ends of ranges ----

TEST(HoffmanPreethamEnds, air_of_nothing_is_clear_and_nothing_is_not_finite) {
  Numbers light(3), left(3);
  for (const char* name : {"double", "simd"}) {
    const Sky vacuum(built_in_atmosphere("earth"), "hoffman_preetham", engine_or_none(name),
                     {{"beta_rayleigh", n(0)}, {"beta_mie", n(0)}});
    const std::vector<Ray> ray{{.view = {0, 0, 1}, .sun = {0, 0, 1}}};
    const Numbers wavelengths{650, 570, 475};
    vacuum.evaluate(Quantity::radiance, ray, wavelengths, light);
    vacuum.evaluate(Quantity::transmittance, ray, wavelengths, left);
    EXPECT_EQ(light, Numbers(3, 0.0));
    EXPECT_EQ(left, Numbers(3, 1.0));
    std::vector<Ray> rays;
    for (const Direction view : {Direction{0, 0, 1}, {0, 0, -1}, {0, 1, 0}})
      for (const double sign : {1.0, -1.0})
        for (const double distance : {0.0, 1e-3, 1e9, std::numeric_limits<double>::infinity()})
          rays.push_back({.view = view, .sun = {sign * view[0], sign * view[1], sign * view[2]}, .distance = distance});
    Numbers out(3 * rays.size());
    for (const ParameterInfo& key : model_info("hoffman_preetham").parameters) {
      if (key.kind == ParameterInfo::Kind::word) continue;
      for (const double v : {key.low, key.high}) {
        const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine_or_none(name),
                      {{std::string(key.name), n(v)}});
        for (const Quantity quantity : {Quantity::radiance, Quantity::transmittance, Quantity::sun_irradiance}) {
          sky.evaluate(quantity, rays, wavelengths, out);
          for (const double x : out)
            EXPECT_TRUE(std::isfinite(x) && x >= 0) << key.name << " = " << v << " on " << name;
        }
      }
    }
  }
}

TEST(HoffmanPreethamEnds, other_wavelengths_are_refused) {
  const Sky sky(built_in_atmosphere("earth"), "hoffman_preetham", engine_or_none("double"));
  Numbers out(1);
  try {
    sky.evaluate(Quantity::radiance, std::vector<Ray>{{}}, Numbers{550}, out);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "model hoffman_preetham: wavelength 550 nm: expected one of 650, 570, 475 nm, which it has for red, "
                 "green and blue");
  }
}

TEST(HoffmanPreethamEnds, textures_say_what_they_do_not_hold) {
  const Shot shot{.parameters = {{"renderer", "texture"}, {"dome", "per_species"}}};
  EXPECT_THROW(shot.draw(*engine_or_none("double")), InputError);
}

}  // namespace
}  // namespace airlight::test
