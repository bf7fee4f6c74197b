// The layers of a picture fit together.
#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"
#include "scenes.h"
#include "sky/channel_colours.h"

namespace airlight::test {
namespace {

SceneRows whole(const SceneRenderer& renderer) {
  SceneRows all;
  renderer.render([&](const SceneRows& r) {
    all.end = r.end;
    const auto add = [](std::vector<float>& to, const std::vector<float>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    add(all.rgb, r.rgb), add(all.surface, r.surface), add(all.transmittance, r.transmittance),
        add(all.inscatter, r.inscatter);
    add(all.depth, r.depth), add(all.position, r.position), add(all.normal, r.normal), add(all.albedo, r.albedo);
    add(all.sun_visibility, r.sun_visibility), add(all.sky_irradiance, r.sky_irradiance);
    return true;
  });
  return all;
}

class Layers : public testing::Test {
 protected:
  const Sky sky{built_in_atmosphere("earth"), "skyview"};
  const std::shared_ptr<const Land> land = mountains();
  const Direction sun = direction(100 * deg, 20 * deg);
  const SceneView view = view_from(*land, 0, 0, 300, 30, 0, sun);
};

TEST_F(Layers, recombine_to_the_picture) {
  for (const int samples : {1, 4}) {
    SceneOptions options;
    options.samples = samples;
    const SceneRows rows = whole(SceneRenderer(sky, land, {}, view, options));
    ASSERT_EQ(rows.end, view.camera.camera.height);
    int ground = 0;
    for (std::size_t i = 0; i < rows.rgb.size(); ++i) {
      const float rgb = rows.surface[i] * rows.transmittance[i] + rows.inscatter[i];
      ASSERT_NEAR(rgb, rows.rgb[i], 1e-5 * std::abs(rows.rgb[i])) << i;
      ASSERT_TRUE(std::isfinite(rows.transmittance[i]));
      ground += rows.surface[i] > 0;
    }
    EXPECT_GT(ground, 500);
  }
}

TEST_F(Layers, depth_position_and_normal_belong_together) {
  const SceneRows rows = whole(SceneRenderer(sky, land, {}, view, {}));
  const Position eye = view.camera.eye;
  for (std::size_t p = 0; p < rows.depth.size(); ++p) {
    if (!std::isfinite(rows.depth[p])) {
      EXPECT_EQ(rows.albedo[3 * p], 0);
      continue;
    }
    const float* at = &rows.position[3 * p];
    const double distance = std::hypot(double(at[0]) - eye[0], double(at[1]) - eye[1], double(at[2]) - eye[2]);
    ASSERT_NEAR(distance, rows.depth[p], 0.01 + 1e-5 * distance);  // positions are floats
    const float* n = &rows.normal[3 * p];
    ASSERT_NEAR(std::hypot(double(n[0]), double(n[1]), double(n[2])), 1, 1e-4);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_GT(rows.albedo[3 * p + c], 0);
      ASSERT_LT(rows.albedo[3 * p + c], 1.2);  // a colour, not a spectrum, may leave 0 .. 1 a little
    }
  }
}

TEST(SunVisibility, of_a_plain_is_what_the_planet_leaves_of_the_disc) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const auto land = plain();
  for (const double elevation : {-0.4, -0.1, 0.0, 0.15, 0.5}) {
    const Direction sun = direction(40 * deg, elevation * deg);
    const SceneRenderer renderer(sky, land, {}, view_from(*land, 0, 0, 50, 30, -20, sun), {});
    const SceneRows rows = whole(renderer);
    for (std::size_t p = 0; p < rows.depth.size(); p += 7) {
      if (!(rows.depth[p] < 2000)) continue;
      const Position at{double(rows.position[3 * p]), double(rows.position[3 * p + 1]),
                        double(rows.position[3 * p + 2])};
      const Direction up = land->frame().up(at);
      const double mu_s = up[0] * sun[0] + up[1] * sun[1] + up[2] * sun[2];
      const double above = disc_above_sphere(mu_s, 0, land->frame().radius(), sky.atmosphere().sun.angular_radius);
      // The horizon's height on the disc is found to 1/64, and triangles' chords lie below the sphere.
      ASSERT_NEAR(rows.sun_visibility[p], above, 0.04) << elevation;
    }
  }
}

TEST_F(Layers, more_samples_give_the_same_picture_smoother) {
  const SceneRows one = whole(SceneRenderer(sky, land, {}, view, {}));
  SceneOptions options;
  options.samples = 16;
  const SceneRows many = whole(SceneRenderer(sky, land, {}, view, options));
  double a = 0, b = 0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i) a += double(one.rgb[i]), b += double(many.rgb[i]);
  EXPECT_NEAR(a / b, 1, 0.02);  // 1300 pixels, of which those on edges differ
}

TEST_F(Layers, a_number_of_samples_that_is_no_square_is_refused) {
  SceneOptions odd;
  odd.samples = 3;
  EXPECT_THROW(SceneRenderer(sky, land, {}, view, odd), InputError);
}

// Half of the planet lies in the night, and from space is seen to: ground has the skylight of its own Sun, not of the eye's.
TEST(Layers_from_space, ground_is_lit_by_its_own_sky) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const auto land = plain();
  SceneCamera camera;
  camera.camera = {.projection = Projection::perspective,
                   .width = 32,
                   .height = 32,
                   .elevation = -90 * deg,
                   .field_of_view = 30 * deg};
  camera.altitude = 2e7;
  const Direction sun = direction(90 * deg, 20 * deg);
  SceneOptions options;
  options.air_shadows = false;
  const SceneRows rows = whole(SceneRenderer(sky, land, {}, {place_camera(camera, *land), sun}, options));
  const std::array<double, 4> quad = sky.realtime_wavelengths();
  const ChannelColours weights = srgb_weights(sky.atmosphere(), quad);
  int day = 0, night = 0;
  for (std::size_t p = 0; p < rows.depth.size(); ++p) {
    if (!std::isfinite(rows.depth[p])) continue;
    const Direction up = land->frame().up({rows.position[3 * p], rows.position[3 * p + 1], rows.position[3 * p + 2]});
    const double mu_s = up[0] * sun[0] + up[1] * sun[1] + up[2] * sun[2];
    const Ray ray{.sun = {std::sqrt(1 - mu_s * mu_s), 0, mu_s}};
    double skylight[4], green = 0;
    sky.evaluate(Quantity::sky_irradiance, {&ray, 1}, quad, skylight);
    for (std::size_t k = 0; k < 4; ++k) green += weights[k][1] * skylight[k];
    const bool lit = mu_s > std::sin(3 * deg), dark = mu_s < std::sin(-20 * deg);
    if (lit) {
      // Within what Suns 1.5 degrees apart leave between them.
      EXPECT_NEAR(rows.sky_irradiance[3 * p + 1], green, 0.02 * green) << std::asin(mu_s) / deg;
    }
    if (dark) {
      EXPECT_LT(rows.sky_irradiance[3 * p + 1], 1);  // [lx]; the eye's own sky would give thousands
    }
    day += lit;
    night += dark;
  }
  EXPECT_GT(night, 50);
  EXPECT_GT(day, 300);
}

}  // namespace
}  // namespace airlight::test
