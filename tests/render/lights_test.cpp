// Light of several sources adds up.
#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"
#include "render/haze_picture.h"
#include "scenes.h"

namespace airlight::test {
namespace {

Sky lit(double ratio) {
  Atmosphere air = built_in_atmosphere("earth");
  air.sun.irradiance = air.sun.irradiance.scaled(ratio);
  return Sky(air, "skyview");
}

/// A strip of rows with the light of which sums are asked.
struct Light {
  std::vector<float> rgb, surface, inscatter, sky_irradiance, transmittance, depth;
};

class Lights : public testing::Test {
 protected:
  const std::shared_ptr<const Land> land = mountains();
  const Sky sun = lit(1), brighter = lit(2), dimmer = lit(0.4);
  const Direction low = direction(100 * deg, 3 * deg), high = direction(-70 * deg, 35 * deg);

  Light picture(const Sky& sky, const Direction& towards, std::vector<MoreLight> more = {}) const {
    // Past the lower sun, so that its disc is in the picture.
    SceneView view = view_from(*land, 0, 0, 900, 90, 0, towards);
    view.more_lights = std::move(more);
    Light all;
    SceneRenderer(sky, land, {}, view, {}).render([&](const SceneRows& r) {
      const auto add = [](std::vector<float>& to, const std::vector<float>& from) {
        to.insert(to.end(), from.begin(), from.end());
      };
      add(all.rgb, r.rgb), add(all.surface, r.surface), add(all.inscatter, r.inscatter);
      add(all.sky_irradiance, r.sky_irradiance), add(all.transmittance, r.transmittance), add(all.depth, r.depth);
      return true;
    });
    return all;
  }

  /// Sums are of doubles, and become floats once: half a unit of each.
  static void expect_sum(const std::vector<float>& whole, const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(whole.size(), a.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const double scale = std::abs(double(a[i])) + std::abs(double(b[i]));
      ASSERT_NEAR(whole[i], double(a[i]) + double(b[i]), 2e-6 * scale) << i;  // the colours' weights cancel a little
    }
  }
};

TEST_F(Lights, two_equal_suns_are_one_of_twice_the_light) {
  const Light two = picture(sun, low, {{&sun, low}}), one = picture(brighter, low);
  for (const auto part :
       {&Light::rgb, &Light::surface, &Light::inscatter, &Light::sky_irradiance, &Light::transmittance}) {
    ASSERT_EQ((two.*part).size(), (one.*part).size());
    for (std::size_t i = 0; i < (one.*part).size(); ++i)
      // Kernels answer in floats, which doubling leaves alone but where tables are summed in another order.
      ASSERT_NEAR((two.*part)[i], (one.*part)[i], 1e-5 * std::abs(double((one.*part)[i]))) << i;
  }
  EXPECT_EQ(two.depth, one.depth);
}

TEST_F(Lights, a_picture_is_the_sum_of_those_by_each_light) {
  const Light both = picture(sun, low, {{&dimmer, high}}), first = picture(sun, low), second = picture(dimmer, high);
  expect_sum(both.rgb, first.rgb, second.rgb);
  expect_sum(both.surface, first.surface, second.surface);
  expect_sum(both.inscatter, first.inscatter, second.inscatter);
  expect_sum(both.sky_irradiance, first.sky_irradiance, second.sky_irradiance);
  EXPECT_EQ(both.depth, first.depth);
  // Each of them has a say.
  double a = 0, b = 0;
  for (std::size_t i = 0; i < first.rgb.size(); ++i) a += double(first.surface[i]), b += double(second.surface[i]);
  EXPECT_GT(a, 0);
  EXPECT_GT(b, 0);
}

TEST_F(Lights, haze_over_black_is_the_sum_of_that_by_each_light) {
  const HazeView view = haze_view(Camera{
      .projection = Projection::perspective, .width = 16, .height = 9, .azimuth = 90 * deg, .field_of_view = 60 * deg});
  std::vector<float> distance(16 * 9, 20'000);
  std::fill_n(distance.begin(), 70, std::numeric_limits<float>::infinity());
  const auto hazed = [&](const Sky& sky, const Direction& towards, std::vector<AirLight> more) {
    HazeSettings settings{.altitude = 500, .sun = towards};
    settings.more_lights = std::move(more);
    std::vector<float> rgba;
    for (std::size_t i = 0; i < distance.size(); ++i) rgba.insert(rgba.end(), {0, 0, 0, 1});
    HazePicture(sky, view, settings).rows(0, distance, rgba);
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 0;
    return rgba;
  };
  expect_sum(hazed(sun, low, {{&dimmer, high}}), hazed(sun, low, {}), hazed(dimmer, high, {}));
}

TEST_F(Lights, systems_of_colours_know_their_sun_alone) {
  const Sky published(built_in_atmosphere("earth"), "hoffman_preetham");
  SceneView view = view_from(*land, 0, 0, 900, 90, 0, low);
  view.more_lights = {{&published, high}};
  SceneOptions plainly;
  plainly.air_shadows = false;
  EXPECT_THROW(SceneRenderer(published, land, {}, view, plainly), InputError);
}

}  // namespace
}  // namespace airlight::test
