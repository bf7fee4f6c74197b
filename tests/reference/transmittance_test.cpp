#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"
#include "atmospheres.h"

namespace airlight::reference {
namespace {

// Tolerances: 1e-9 relative is 100 times what the columns' shells aim at; longer rays have larger columns.

TEST(Transmittance, of_uniform_gas_is_exp_of_the_chord) {
  const Atmosphere a = with(vacuum(), layer(0, 100e3), 2e-6, 3e-6);
  EXPECT_NEAR(optical_depth(a, {.view = towards(90)}), 5e-6 * 100e3, 1e-9);
  EXPECT_NEAR(optical_depth(a, {.altitude = 400e3, .view = towards(-90)}), 5e-6 * 100e3, 1e-9);
  EXPECT_NEAR(optical_depth(a, {.view = towards(10), .distance = 7e3}), 5e-6 * 7e3, 1e-11);
  // Past the limb 20 km above the ground: twice the half chord in the sphere of the top.
  const double b = 6.371e6 + 20e3, r = 6.371e6 + 400e3, top = 6.371e6 + 100e3;
  EXPECT_NEAR(optical_depth(a, {.altitude = 400e3, .view = towards(-std::acos(b / r) / degree)}),
              5e-6 * 2 * std::sqrt((top - b) * (top + b)), 1e-8);
}

TEST(Transmittance, of_an_exponential_column_is_exp_of_one_scale_height) {
  const Atmosphere a = with(vacuum(), ExponentialProfile{8000}, 1e-5, 0);
  const double column = 8000 * (1 - std::exp(-100.0 / 8));
  EXPECT_NEAR(optical_depth(a, {.view = towards(90)}), 1e-5 * column, 1e-11);
  EXPECT_NEAR(optical_depth(a, {.altitude = 8000, .view = towards(-90)}), 1e-5 * 8000 * (1 - std::exp(-1.0)), 1e-11);
}

// Chapman 1931: the horizontal column of an exponential atmosphere is H rho Ch(X, 90 deg), X = radius / H, Ch = X e^X
// K1(X). The Bessel function comes from the library where e^X does not overflow, else from its asymptotic series
// (DLMF 10.40.2).
TEST(Transmittance, of_a_grazing_ray_follows_chapmans_function) {
  const auto chapman = [](double x) {
    if (x < 500) return x * std::exp(x) * std::cyl_bessel_k(1.0, x);
    return std::sqrt(std::numbers::pi * x / 2) * (1 + 3 / (8 * x) - 15 / (128 * x * x) + 105 / (1024 * x * x * x));
  };
  for (const double scale_height : {2000.0, 8000.0, 60e3, 300e3}) {
    const Atmosphere a =
        with(vacuum(6.371e6, 40 * scale_height), ExponentialProfile{scale_height}, 1e-2 / scale_height, 0);
    for (const double altitude : {0.0, 0.7 * scale_height}) {
      const double expected = 1e-2 * std::exp(-altitude / scale_height) * chapman((6.371e6 + altitude) / scale_height);
      EXPECT_NEAR(optical_depth(a, {.altitude = altitude, .view = towards(0)}) / expected, 1, 1e-8)
          << "scale height " << scale_height << " altitude " << altitude;
    }
  }
}

// A sheet of 1 m: its optical depth is the path inside, which plain root differences give with 1e-4 of it.
TEST(Transmittance, sees_a_thin_layer) {
  const Atmosphere a = with(vacuum(), layer(20e3, 20e3 + 1), 0, 1e-2);
  EXPECT_NEAR(optical_depth(a, {.view = towards(90)}), 1e-2, 1e-11);
  EXPECT_NEAR(optical_depth(a, {.view = towards(30)}) / (1e-2 / std::sin(30 * degree)), 1, 0.01);
  const double r = 6.371e6, in = std::sqrt(20e3 * (2 * r + 20e3)), out = std::sqrt((20e3 + 1) * (2 * r + 20e3 + 1));
  EXPECT_NEAR(optical_depth(a, {.view = towards(0)}), 1e-2 * (out - in), 1e-8);
}

const Ray short_and_long_rays[] = {
    {.altitude = 0, .view = towards(5, 30), .sun = towards(20), .distance = 90e3},
    {.altitude = 400e3, .view = towards(-19.5, 100), .sun = towards(3, 60), .distance = 3000e3},
    {.altitude = 9e3, .view = towards(-2, 200), .sun = towards(-4), .distance = 300e3},
    {.altitude = 30e3, .view = towards(-0.5), .sun = towards(-5, 70), .distance = 800e3},
};
Atmosphere absorbing_mixture() {
  return with(with(with(vacuum(), ExponentialProfile{8000}, 1.2e-5, 0, RayleighPhase{0.03}), ExponentialProfile{1200},
                   6e-5, 1e-5, HenyeyGreensteinPhase{0.7}),
              TentProfile{25000, 15000}, 0, 3e-6);
}

TEST(Transmittance, is_multiplicative_along_a_ray) {
  for (const Ray& ray : short_and_long_rays) {
    Ray first = ray;
    first.distance = 0.37 * ray.distance;
    EXPECT_NEAR(transmittance(absorbing_mixture(), first) *
                    transmittance(absorbing_mixture(), moved(ray, first.distance, 6.371e6)),
                transmittance(absorbing_mixture(), ray), 1e-9);
  }
}

TEST(Transmittance, is_the_same_both_ways) {
  for (const Ray& ray : short_and_long_rays) {
    Ray back = moved(ray, ray.distance, 6.371e6);
    for (double& component : back.view) component = -component;
    back.distance = ray.distance;
    EXPECT_NEAR(transmittance(absorbing_mixture(), back), transmittance(absorbing_mixture(), ray), 1e-9);
  }
}

TEST(Transmittance, is_one_outside_the_air) {
  const Atmosphere a = absorbing_mixture();
  EXPECT_EQ(transmittance(a, {.altitude = 400e3, .view = towards(10)}), 1);
  EXPECT_EQ(transmittance(a, {.altitude = 400e3, .view = towards(-60), .distance = 200e3}), 1);
  EXPECT_EQ(transmittance(a, {.altitude = 1e9, .view = towards(-80)}), 1);
  EXPECT_EQ(transmittance(vacuum(), {.view = towards(45)}), 1);
}

// Below the datum the air of altitude 0 continues, and the ground lies 1 m under the eye.
TEST(Transmittance, below_the_datum_has_the_air_of_altitude_zero) {
  const Atmosphere a = with(vacuum(), ExponentialProfile{8000}, 1e-5, 0);
  const double column = 8000 * (1 - std::exp(-100.0 / 8));
  EXPECT_NEAR(optical_depth(a, {.altitude = -400, .view = towards(90)}), 1e-5 * (column + 400), 1e-11);
  EXPECT_NEAR(optical_depth(a, {.altitude = -400, .view = towards(-90)}), 1e-5 * 1, 1e-13);
  EXPECT_NEAR(optical_depth(a, {.altitude = -400, .view = towards(-30)}), 1e-5 * 2, 1e-11);
}

TEST(Transmittance, ends_at_the_ground) {
  const Atmosphere a = with(vacuum(), layer(0, 100e3), 1e-5, 0);
  EXPECT_NEAR(optical_depth(a, {.altitude = 1000, .view = towards(-90), .distance = 1e6}), 1e-2, 1e-12);
  EXPECT_EQ(transmittance(a, {.altitude = 0, .view = towards(-1e-3)}), 1);
}

TEST(Transmittance, refuses_rays_that_are_none) {
  const SingleScattering solver(absorbing_mixture());
  const auto refuse = [&](const Ray& ray, const std::string& key) {
    try {
      solver.along(ray, {&wavelength, 1});
      ADD_FAILURE() << key << " accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
    }
  };
  refuse({.altitude = NAN}, "altitude");
  refuse({.altitude = -6.371e6}, "altitude");
  refuse({.view = {0, 0, 0}}, "view");
  refuse({.sun = {NAN, 0, 1}}, "sun");
  refuse({.distance = -1}, "distance");
  refuse({.distance = NAN}, "distance");
}

}  // namespace
}  // namespace airlight::reference
