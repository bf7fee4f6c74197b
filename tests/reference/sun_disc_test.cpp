#include <gtest/gtest.h>

#include <cmath>

#include "atmospheres.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

Atmosphere airless(double exponent, double radius = 0.004675) {
  Atmosphere a = vacuum();
  a.sun.angular_radius = radius;
  a.sun.limb_darkening = exponent;
  return a;
}
Atmosphere air(double exponent, double radius = 0.004675) {
  return with(airless(exponent, radius), ExponentialProfile{8000}, 1.2e-5, 1e-5);
}

TEST(SunDisc, unobstructed_gives_the_whole_irradiance) {
  for (const double exponent : {0.0, 0.3, 0.55, 1.0})
    for (const double elevation : {90.0, 30.0, 0.3})
      EXPECT_NEAR(sun_irradiance(airless(exponent), {.sun = towards(elevation)}), 2, 1e-12);
}

// On the ground the horizon is straight. Uniform disc: a circle's segment; exponent 1: weights 1 - x^2.
// An observer's rounding (1e-9 m) lowers the horizon by up to 2e-8 rad: 2e-6 of the disc.
TEST(SunDisc, cut_by_the_horizon_gives_the_segment_above_it) {
  for (const double x : {-0.99, -0.7, 0.0, 0.4, 0.95}) {
    const Ray ray{.sun = towards(std::asin(-x * std::sin(0.004675)) / degree)};
    EXPECT_NEAR(sun_irradiance(airless(0), ray) / 2, (std::acos(x) - x * std::sqrt(1 - x * x)) / pi, 2e-6) << x;
    EXPECT_NEAR(sun_irradiance(airless(1), ray) / 2, 0.75 * (2.0 / 3 - x + x * x * x / 3), 2e-6) << x;
  }
  EXPECT_EQ(sun_irradiance(airless(0), {.sun = towards(-0.27)}), 0);
}

// From 400 km the horizon is 19.8 degrees down and bends over the disc. The visible share, row by row of equal y: where
// the horizon cuts a row is found by bisection, nothing is averaged.
TEST(SunDisc, cut_by_a_high_observers_horizon_gives_what_rows_add_up_to) {
  const double dip = std::acos(6.371 / 6.771), s = std::sin(0.004675);
  for (const double offset : {-0.8, 0.0, 0.5}) {
    const double elevation = -dip + offset * 0.004675;
    double visible = 0, all = 0;
    constexpr int rows = 2000;
    for (int i = 0; i < rows; ++i) {
      const double y = std::sin(((i + 0.5) / rows - 0.5) * pi), half = std::sqrt(1 - y * y);
      double low = -half, high = half;
      const auto above = [&](double x) {
        return std::sin(elevation) * std::sqrt(1 - s * s * (x * x + y * y)) + s * x * std::cos(elevation) >
               -std::sin(dip);
      };
      if (!above(high)) low = high;
      if (above(low)) high = low;
      for (int k = 0; k < 50; ++k) (above(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
      visible += half * (half - high);
      all += half * 2 * half;
    }
    EXPECT_NEAR(sun_irradiance(airless(0), {.altitude = 400e3, .sun = towards(elevation / degree)}) / 2, visible / all,
                1e-6)
        << offset;
  }
}

// The disc's mean as a sum over rings and sectors of point suns: nothing of the one-dimensional integral is used.
// Exponents 0 and 2 make the ring integral a polynomial's.
TEST(SunDisc, mean_transmittance_is_that_of_a_sum_over_the_disc) {
  const SingleScattering point(air(0), by_point_sun);
  const GaussRule rings(8);
  const double s = std::sin(0.004675);
  for (const double elevation : {90.0, 89.9, 45.0, 10.0, 2.0, 0.5}) {
    const Direction sun = towards(elevation),
                    up = towards(elevation + 90);  // `up` is normal to the sun, in its vertical plane
    double uniform = 0, darkened = 0;
    constexpr int sectors = 32;
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < sectors; ++k) {
        const double q = rings.nodes[i], r = s * std::sqrt(q), angle = 2 * pi * k / sectors;
        const double c = std::sqrt(1 - r * r), x = r * std::cos(angle), y = r * std::sin(angle);
        const Ray ray{.sun = {c * sun[0] + x * up[0] + y, c * sun[1] + x * up[1], c * sun[2] + x * up[2]}};
        const double irradiance = point.sun_irradiance(ray, {&wavelength, 1})[0] * rings.weights[i] / sectors;
        uniform += irradiance;
        darkened += irradiance * 2 * (1 - q);
      }
    EXPECT_NEAR(sun_irradiance(air(0), {.sun = sun}) / uniform, 1, 1e-7) << elevation;
    EXPECT_NEAR(sun_irradiance(air(2), {.sun = sun}) / darkened, 1, 1e-7) << elevation;
  }
}

// The difference falls as the square of the radius (the mean's second-order term).
TEST(SunDisc, tends_to_a_point_sun) {
  for (const Ray& ray :
       {Ray{.view = towards(20, 40), .sun = towards(3)}, Ray{.view = towards(60, 40), .sun = towards(-4)}}) {
    const double point = path_radiance(air(0.5), ray, by_point_sun);
    const double wide = std::abs(path_radiance(air(0.5, 0.004), ray) / point - 1);
    const double narrow = std::abs(path_radiance(air(0.5, 0.0004), ray) / point - 1);
    EXPECT_LT(narrow, wide / 50);
    EXPECT_LT(narrow, 1e-4);
    EXPECT_GT(wide, 1e-6) << "the disc has no effect at all";
  }
}

TEST(SunDisc, sunlight_on_the_ground_is_dimmed_like_the_view_to_the_sun) {
  for (const double elevation : {90.0, 20.0, 1.0}) {
    const Ray ray{.view = towards(elevation), .sun = towards(elevation)};
    EXPECT_NEAR(sun_irradiance(air(0), ray, by_point_sun), 2 * transmittance(air(0), ray), 1e-10);
  }
  // From orbit, past the limb at 15 km.
  const double elevation = -std::acos((6.371e6 + 15e3) / (6.371e6 + 400e3)) / degree;
  const Ray ray{.altitude = 400e3, .view = towards(elevation), .sun = towards(elevation)};
  EXPECT_NEAR(sun_irradiance(air(0), ray, by_point_sun), 2 * transmittance(air(0), ray), 1e-10);
}

}  // namespace
}  // namespace airlight::reference
