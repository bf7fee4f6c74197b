// Published systems on land: what they say of surfaces and of the air before them, put together as their sources have it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "scenes.h"

namespace airlight::test {
namespace {

const std::vector<double> nominal{650, 570, 475};

struct Picture {
  SceneRows layers;
  double mean() const {
    double sum = 0;
    for (const float v : layers.rgb) sum += v;
    return sum / double(layers.rgb.size());
  }
};

SceneOptions plainly() {
  SceneOptions options;
  options.air_shadows = false;
  options.sun_disc = false;
  return options;
}

class OnLand : public testing::Test {
 protected:
  const std::shared_ptr<const Land> land = mountains();
  const Direction sun = direction(100 * deg, 30 * deg);
  const SceneView view = view_from(*land, 0, 0, 300, 60, -3, sun);

  static Sky sky(Parameters parameters, const char* model = "hoffman_preetham") {
    return Sky(built_in_atmosphere("earth"), model, make_engine("simd"), parameters);
  }
  Picture draw(const Sky& sky, SceneOptions options = plainly()) const { return draw(sky, options, view); }
  Picture draw(const Sky& sky, const SceneOptions& options, const SceneView& seen) const {
    Picture all;
    SceneRenderer(sky, land, {}, seen, options).render([&](const SceneRows& r) {
      const auto add = [&](std::vector<float> SceneRows::*layer) {
        (all.layers.*layer).insert((all.layers.*layer).end(), (r.*layer).begin(), (r.*layer).end());
      };
      for (auto layer :
           {&SceneRows::rgb, &SceneRows::surface, &SceneRows::transmittance, &SceneRows::inscatter, &SceneRows::depth,
            &SceneRows::normal, &SceneRows::albedo, &SceneRows::sun_visibility, &SceneRows::sky_irradiance})
        add(layer);
      return true;
    });
    return all;
  }
  Picture draw(Parameters parameters) const { return draw(sky(std::move(parameters))); }
};

// L0 = albedo / pi max(0, n.s) E_sun shadow, written again from the layers that Embree and the land's colours make; no skylight.
TEST_F(OnLand, lambert_lit_by_one_sunlight) {
  const Sky air = sky({{"renderer", "pixel"}});
  const Picture picture = draw(air);
  const SceneRows& l = picture.layers;
  const Ray ray{.altitude = 0, .view = {0, 0, 1}, .sun = view.camera.from_scene(sun)};
  std::vector<double> sunlight(3);
  air.evaluate(Quantity::sun_irradiance, {&ray, 1}, nominal, sunlight);
  const double unit = model_info("hoffman_preetham").colours->luminance;
  int lit = 0;
  for (std::size_t p = 0; p < l.depth.size(); ++p) {
    if (!std::isfinite(l.depth[p])) continue;
    double cosine = 0;
    for (std::size_t c = 0; c < 3; ++c) cosine += double(l.normal[3 * p + c]) * sun[c];
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = unit * double(l.albedo[3 * p + c]) / std::numbers::pi * std::max(cosine, 0.0) *
                              double(l.sun_visibility[p]) * sunlight[c];
      EXPECT_NEAR(l.surface[3 * p + c], expected, 1e-5 * unit) << "layers are floats";
      EXPECT_EQ(l.sky_irradiance[3 * p + c], 0);
    }
    lit += cosine > 0;
  }
  EXPECT_GT(lit, 300);
}

// The air before each pixel is what a ray as long says, and the picture L0 F_ex + L_in.
TEST_F(OnLand, hazed_as_rays_of_the_same_length) {
  const Sky air = sky({{"renderer", "pixel"}, {"preset", "overcast"}});
  const SceneRenderer renderer(air, land, {}, view, plainly());
  for (const double v : {0.3, 0.5, 0.7, 0.95}) {
    const SceneRenderer::Answer seen = renderer.at(0.4, v);
    const Ray ray{.altitude = 0, .view = seen.view, .sun = seen.sun, .distance = seen.distance};
    std::vector<double> light(3), left(3);
    air.evaluate(Quantity::path_radiance, {&ray, 1}, nominal, light);
    air.evaluate(Quantity::transmittance, {&ray, 1}, nominal, left);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(seen.inscatter[c], light[c], 1e-5);
      if (std::isfinite(seen.distance)) {
        EXPECT_NEAR(seen.transmittance[c], left[c], 1e-5);
      }
    }
  }
  const SceneRows l = draw(air).layers;
  for (std::size_t i = 0; i < l.rgb.size(); ++i)
    ASSERT_NEAR(l.rgb[i], l.surface[i] * l.transmittance[i] + l.inscatter[i], 1e-5 * std::abs(l.rgb[i]));
}

double mean_difference(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.layers.rgb.size(); ++i)
    sum += std::abs(double(a.layers.rgb[i]) - double(b.layers.rgb[i]));
  return sum / double(a.layers.rgb.size()) / b.mean();
}

// Between corners the vertex renderer is linear: its error on land falls as triangles shrink, from 24 pixels to 1.5. Tiles of the mesh are
// split as wholes, so that most triangles are smaller than asked, and the error falls by less than the square of that.
TEST_F(OnLand, vertices_miss_what_lies_between_them) {
  SceneView close = view;
  close.camera.camera.width = 192, close.camera.camera.height = 108;
  const auto error = [&](double pixels) {
    SceneOptions options = plainly();
    options.triangle_pixels = pixels;
    const Parameters hazy{{"preset", "sunset"}, {"beta_mie", std::vector<double>{2e-5}}};
    Parameters exact = hazy;
    exact["renderer"] = "pixel";
    const Picture vertex = draw(sky(hazy), options, close), pixel = draw(sky(exact), options, close);
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < pixel.layers.rgb.size(); ++i) {
      if (!std::isfinite(pixel.layers.depth[i / 3])) continue;
      sum += std::abs(double(vertex.layers.rgb[i]) - double(pixel.layers.rgb[i]));
      all += double(pixel.layers.rgb[i]);
    }
    return sum / all;
  };
  const double coarse = error(24), fine = error(1.5);
  EXPECT_GT(coarse, 2 * fine) << "corners alone are asked";
  EXPECT_LT(fine, 2e-4);
}

TEST_F(OnLand, textures_meet_the_formula) {
  // The source allows 1 % of the peak for each look-up; here it is 1 % of a picture's mean.
  EXPECT_LT(mean_difference(draw({{"renderer", "texture"}}), draw({{"renderer", "pixel"}})), 0.01);
}

// L0 F_ex + L_in is the picture; each term is also a view of its own.
TEST_F(OnLand, shows_its_terms) {
  for (const char* renderer : {"pixel", "vertex"}) {
    const auto show = [&](const char* what) { return draw({{"renderer", renderer}, {"show", what}}).layers.rgb; };
    const std::vector<float> all = show("all"), bare = show("L0"), left = show("F_ex"), dimmed = show("L0_F_ex"),
                             light = show("L_in");
    const double white = model_info("hoffman_preetham").colours->luminance / 20;  // of a display exposed by the preset
    const std::vector<float> depth = draw({{"renderer", renderer}}).layers.depth;
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_NEAR(dimmed[i] + light[i], all[i], 1e-5 * all[i]);
      if (std::isfinite(depth[i / 3])) {
        ASSERT_NEAR(bare[i] * left[i] / white, dimmed[i], 2e-4 * bare[i]);
      }
    }
  }
}

TEST_F(OnLand, air_of_nothing_leaves_the_land_as_it_is) {
  const std::vector<double> none{0};
  for (const char* renderer : {"vertex", "texture", "pixel"}) {
    const SceneRows l = draw({{"renderer", renderer}, {"beta_rayleigh", none}, {"beta_mie", none}}).layers;
    for (std::size_t i = 0; i < l.rgb.size(); ++i) ASSERT_EQ(l.rgb[i], l.surface[i]) << renderer;
  }
}

TEST_F(OnLand, takes_the_sky_s_light_where_it_is_asked_to) {
  const Sky air = sky({{"renderer", "pixel"}, {"ambient", std::vector<double>{1}}});
  const Ray ray{.altitude = 0, .view = {0, 0, 1}, .sun = view.camera.from_scene(sun)};
  std::vector<double> skylight(3);
  air.evaluate(Quantity::sky_irradiance, {&ray, 1}, nominal, skylight);
  const double unit = model_info("hoffman_preetham").colours->luminance;
  const SceneRows with = draw(air).layers, without = draw({{"renderer", "pixel"}}).layers;
  for (std::size_t p = 0; p < with.depth.size(); ++p) {
    if (!std::isfinite(with.depth[p])) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t i = 3 * p + c;
      EXPECT_LE(with.sky_irradiance[i], 1.001 * unit * skylight[c]) << "level and open land sees it all";
      EXPECT_NEAR(with.surface[i] - without.surface[i],
                  double(with.albedo[i]) / std::numbers::pi * double(with.sky_irradiance[i]), 1e-5 * unit);
    }
  }
}

TEST_F(OnLand, eight_bits_move_a_colour_by_a_step_at_most) {
  const Picture rounded = draw({{"renderer", "pixel"}, {"clamp8bit", std::vector<double>{1}}}),
                whole = draw({{"renderer", "pixel"}});
  const double step = model_info("hoffman_preetham").colours->luminance / 20 / 255;
  double most = 0;
  for (std::size_t i = 0; i < whole.layers.rgb.size(); ++i) {
    const double light = whole.layers.inscatter[i];
    if (light > 250 * step) continue;  // white stays white
    const double off = std::abs(double(rounded.layers.inscatter[i]) - light);
    EXPECT_LE(off, 0.5001 * step);
    most = std::max(most, off);
  }
  EXPECT_GT(most, 0.3 * step) << "eight bits are seen";
}

// A disc of the sunlight at the ground: its pixels add up to the frame's one sunlight.
TEST_F(OnLand, the_disc_is_of_the_light_that_arrives) {
  const Direction low = direction(60 * deg, 20 * deg);
  const SceneView at_sun = view_from(*land, 0, 0, 300, 60, 20, low);
  const Sky air = sky({{"renderer", "pixel"}});
  double sum = 0, pixels = 0;
  for (const bool disc : {true, false}) {
    SceneOptions options = plainly();
    options.sun_disc = disc;
    SceneRenderer(air, land, {}, at_sun, options).render([&](const SceneRows& r) {
      for (std::size_t i = 1; i < r.rgb.size(); i += 3) sum += disc ? double(r.rgb[i]) : -double(r.rgb[i]);
      pixels += double(r.rgb.size() / 3);
      return true;
    });
  }
  const Ray ray{.altitude = 0, .view = {0, 0, 1}, .sun = at_sun.camera.from_scene(low)};
  std::vector<double> sunlight(3);
  air.evaluate(Quantity::sun_irradiance, {&ray, 1}, nominal, sunlight);
  // A pixel in the middle of a lens of 60 degrees, 48 wide.
  const double pixel = std::pow(2 * std::tan(30 * deg) / 48, 2);
  EXPECT_NEAR(sum * pixel / model_info("hoffman_preetham").colours->luminance, sunlight[1], 0.02 * sunlight[1]);
}

TEST_F(OnLand, other_systems_put_their_haze_before_land) {
  for (const char* model : {"jetlag", "realworldz"}) {
    const SceneRows l = draw(sky({}, model)).layers;
    double land_pixels = 0, light = 0;
    for (std::size_t i = 0; i < l.rgb.size(); ++i) {
      ASSERT_TRUE(std::isfinite(l.rgb[i]) && l.rgb[i] >= 0) << model;
      ASSERT_NEAR(l.rgb[i], l.surface[i] * l.transmittance[i] + l.inscatter[i], 1e-5 * l.rgb[i]);
      if (!std::isfinite(l.depth[i / 3])) continue;
      EXPECT_GE(l.transmittance[i], 0);
      EXPECT_LE(l.transmittance[i], 1);
      light += l.surface[i] > 0;
      ++land_pixels;
    }
    EXPECT_GT(light, 0.3 * land_pixels) << model << " lights the land";
  }
  EXPECT_THROW(draw(sky({}, "codeflow")), InputError) << "knows the sky alone";
}

// The published way, at corners, and each pixel: not the same, and not far apart where triangles are small against the zone that fog clears.
TEST_F(OnLand, realworldz_fogs_corners_or_pixels) {
  SceneOptions options = plainly();
  options.triangle_pixels = 24;
  const double difference =
      mean_difference(draw(sky({}, "realworldz"), options), draw(sky({{"fog", "pixel"}}, "realworldz"), options));
  EXPECT_GT(difference, 1e-6) << "corners are asked";
  EXPECT_LT(difference, 0.01);
}

TEST_F(OnLand, shadows_in_the_air_are_refused) {
  SceneOptions options = plainly();
  options.air_shadows = true;
  EXPECT_THROW(draw(sky({}), options), InputError);
}

}  // namespace
}  // namespace airlight::test
