#include <gtest/gtest.h>

#include <cmath>

#include "atmospheres.h"
#include "reference/phase.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

// A plane-parallel slab: the planet is so large (1e10 m) that curvature over 1 km of air counts less than 1e-6.
// Single scattering of a homogeneous slab, e.g. Liou 2002, section 6.2; irradiance 2, isotropic phase function.
TEST(SingleScattering, of_a_uniform_slab_is_the_closed_form) {
  const double tau = 0.4, albedo = 0.9;
  const Atmosphere a = with(vacuum(1e10, 1000), layer(0, 1000), albedo * tau / 1000, (1 - albedo) * tau / 1000);
  const double factor = 2.0 * albedo / (4 * pi);
  for (const double sun : {90.0, 50.0, 15.0})
    for (const double view : {80.0, 40.0, 12.0}) {
      const double mu = std::sin(view * degree), mu_s = std::sin(sun * degree);
      const double down = factor * mu_s / (mu_s - mu) * (std::exp(-tau / mu_s) - std::exp(-tau / mu));
      const double up = factor * mu_s / (mu_s + mu) * (1 - std::exp(-tau / mu - tau / mu_s));
      const Direction s = towards(sun, 130);
      EXPECT_NEAR(path_radiance(a, {.view = towards(view), .sun = s}, by_point_sun) / down, 1, 1e-6)
          << sun << " " << view;
      EXPECT_NEAR(path_radiance(a, {.altitude = 1000, .view = towards(-view), .sun = s}, by_point_sun) / up, 1, 1e-6)
          << sun << " " << view;
    }
}

// Air so thin that it dims nothing: radiance = irradiance * phase function * scattering * the lit length, to the
// optical depth.
TEST(SingleScattering, of_thin_air_counts_the_lit_length) {
  const double sigma = 1e-13;
  for (const Phase& law : {Phase(RayleighPhase{0.03}), Phase(HenyeyGreensteinPhase{0.6})}) {
    const Atmosphere a = with(vacuum(), layer(0, 100e3), sigma, 0, law);
    const Direction view = towards(30, 20), sun = towards(40, 75);
    const double one_minus_cos = 1 - (view[0] * sun[0] + view[1] * sun[1] + view[2] * sun[2]);
    EXPECT_NEAR(path_radiance(a, {.view = view, .sun = sun, .distance = 50e3}) /
                    (2.0 * phase(law, one_minus_cos) * sigma * 50e3),
                1, 1e-6);
    // Straight up with the sun 5 degrees down: lit above the planet's shadow, R (1 / cos(5 deg) - 1) = 24.33 km high.
    const double shadow = 6.371e6 * (1 / std::cos(5 * degree) - 1);
    const Ray up{.view = towards(90), .sun = towards(-5)};
    EXPECT_NEAR(
        path_radiance(a, up, by_point_sun) / (2.0 * phase(law, 1 - std::cos(95 * degree)) * sigma * (100e3 - shadow)),
        1, 1e-6);
    Ray below = up;
    below.distance = shadow - 1;
    EXPECT_EQ(path_radiance(a, below, by_point_sun), 0);
    below.distance = shadow + 1;
    EXPECT_GT(path_radiance(a, below, by_point_sun), 0);
  }
}

Atmosphere mixture() {
  return with(with(with(vacuum(), ExponentialProfile{8000}, 1.2e-5, 0, RayleighPhase{0.03}), ExponentialProfile{1200},
                   6e-5, 1e-5, HenyeyGreensteinPhase{0.7}),
              TentProfile{25000, 15000}, 0, 3e-6);
}
const Ray rays[] = {
    {.altitude = 0, .view = towards(5, 30), .sun = towards(20), .distance = 90e3},
    {.altitude = 400e3, .view = towards(-19.5, 100), .sun = towards(3, 60), .distance = 3000e3},
    {.altitude = 9e3, .view = towards(-2, 20), .sun = towards(-4), .distance = 300e3},
    {.altitude = 30e3, .view = towards(-0.5), .sun = towards(-5, 70), .distance = 800e3},
    {.altitude = 400e3, .view = towards(-22, 10), .sun = towards(-16, 0)},
    {.altitude = 100, .view = towards(70, 10), .sun = towards(-0.2, 0)},
};

// L(a, c) = L(a, b) + T(a, b) L(b, c): the second half is asked in the frame of b, so every angle is another number.
TEST(SingleScattering, adds_up_along_a_ray) {
  const SingleScattering solver(mixture());
  for (const Ray& ray : rays) {
    Ray first = ray;
    first.distance = std::isinf(ray.distance) ? 50e3 : 0.37 * ray.distance;
    const RayLight near = solver.along(first, {&wavelength, 1});
    const RayLight far = solver.along(moved(ray, first.distance, 6.371e6), {&wavelength, 1});
    const double whole = solver.along(ray, {&wavelength, 1}).path_radiance[0];
    // The sun's horizon moves by rounding of positions (1e-9 m) only.
    EXPECT_NEAR((near.path_radiance[0] + near.transmittance[0] * far.path_radiance[0]) / whole, 1, 1e-7)
        << ray.altitude;
  }
}

TEST(SingleScattering, is_symmetric_about_the_suns_plane) {
  for (Ray ray : rays) {
    const double one = path_radiance(mixture(), ray);
    ray.view[0] = -ray.view[0];
    ray.sun[0] = -ray.sun[0];
    EXPECT_DOUBLE_EQ(path_radiance(mixture(), ray), one);
  }
}

TEST(SingleScattering, is_proportional_to_the_suns_irradiance) {
  Atmosphere bright = mixture();
  bright.sun.irradiance = 6.0;
  for (const Ray& ray : rays) {
    EXPECT_DOUBLE_EQ(path_radiance(bright, ray), 3 * path_radiance(mixture(), ray));
    EXPECT_DOUBLE_EQ(sun_irradiance(bright, ray), 3 * sun_irradiance(mixture(), ray));
  }
}

// Wavelengths are solved together; each must be what it is alone.
TEST(SingleScattering, does_not_mix_wavelengths) {
  Atmosphere a = mixture();
  a.constituents[0].scattering = Spectrum(Spectrum::Law(PowerSpectrum{550, 1.2e-5, -4}));
  const double wavelengths[] = {400, 550, 700};
  const SingleScattering solver(a);
  for (const Ray& ray : rays) {
    const RayLight together = solver.along(ray, wavelengths);
    for (int w = 0; w < 3; ++w) {
      const RayLight alone = solver.along(ray, {&wavelengths[w], 1});
      EXPECT_DOUBLE_EQ(together.transmittance[w], alone.transmittance[0]);
      EXPECT_NEAR(together.path_radiance[w] / alone.path_radiance[0], 1, 1e-7);
    }
  }
}

// The definition, summed by midpoints in plain radius arithmetic, with nothing of src/reference but the phase function
// left out: finds wrong geometry, sun paths and bookkeeping, up to the sum's own error.
double brute_force(const Atmosphere& a, const Ray& ray, double length) {
  const double R = a.planet.ground_radius, top = R + a.planet.top_altitude;
  const auto extinction = [&](double radius) {
    double sum = 0;
    for (const Constituent& c : a.constituents)
      sum += (c.scattering.at(550) + c.absorption.at(550)) * density(c.profile, radius - R);
    return sum;
  };
  const double cosine = ray.view[0] * ray.sun[0] + ray.view[1] * ray.sun[1] + ray.view[2] * ray.sun[2];
  constexpr int steps = 3000, sun_steps = 600;
  double depth = 0, radiance = 0;
  for (int i = 0; i < steps; ++i) {
    const double ds = length / steps, s = (i + 0.5) * ds;
    const double x = s * ray.view[0], y = s * ray.view[1], z = R + ray.altitude + s * ray.view[2];
    const double radius = std::sqrt(x * x + y * y + z * z);
    if (radius > top) continue;
    const double before = depth + 0.5 * ds * extinction(radius);
    depth += ds * extinction(radius);
    const double p = x * ray.sun[0] + y * ray.sun[1] + z * ray.sun[2];
    if (p < 0 && radius * radius - p * p < R * R) continue;
    const double to_top = -p + std::sqrt(p * p + top * top - radius * radius);
    double sun_depth = 0;
    for (int k = 0; k < sun_steps; ++k) {
      const double d = (k + 0.5) * to_top / sun_steps;
      sun_depth += to_top / sun_steps * extinction(std::sqrt(radius * radius + 2 * d * p + d * d));
    }
    double source = 0;
    for (const Constituent& c : a.constituents)
      source += c.scattering.at(550) * density(c.profile, radius - R) * phase(c.phase, 1 - cosine);
    radiance += ds * source * std::exp(-before - sun_depth);
  }
  return a.sun.irradiance.at(550) * radiance;
}

TEST(SingleScattering, agrees_with_a_brute_force_sum) {
  const Ray cases[] = {
      {.altitude = 0, .view = towards(20, 30), .sun = towards(35), .distance = 250e3},
      {.altitude = 400e3, .view = towards(-19.5, 100), .sun = towards(3, 60), .distance = 3500e3},
      {.altitude = 9e3, .view = towards(-2, 200), .sun = towards(-1), .distance = 300e3},
      {.altitude = 2, .view = towards(15, 10), .sun = towards(-3), .distance = 400e3},
  };
  for (const Ray& ray : cases)
    // Midpoints: an error of (step / scale height)^2 / 24 a step, and the terminator within one step of 3000.
    EXPECT_NEAR(path_radiance(mixture(), ray, by_point_sun) / brute_force(mixture(), ray, ray.distance), 1, 1e-3)
        << ray.altitude;
}

TEST(GroundRadiance, is_lambertian_and_dimmed_on_both_ways) {
  const auto ground = [](const Atmosphere& a, const Ray& ray) {
    return SingleScattering(a).along(ray, {&wavelength, 1}).ground_radiance[0];
  };
  // No air, sun overhead the nadir's neighbour: albedo / pi * irradiance * cos(sun zenith), 1/cos over the disc cancels
  // exactly.
  const Ray down{.altitude = 400e3, .view = towards(-90), .sun = towards(30)};
  EXPECT_NEAR(ground(vacuum(), down), 0.3 / pi * 2.0 * 0.5, 1e-9);
  const Atmosphere a = with(vacuum(1e10, 1000), layer(0, 1000), 0, 4e-4);
  // Disc and point differ by T'' / T * radius^2 / 10 = 2e-6.
  EXPECT_NEAR(ground(a, down) / (0.3 / pi * 2.0 * 0.5 * std::exp(-0.4 - 0.4 / 0.5)), 1, 1e-5);
  Ray segment = down;
  segment.distance = 500e3;
  EXPECT_EQ(ground(a, segment), 0) << "a segment ends in air";
  EXPECT_EQ(ground(a, {.altitude = 10, .view = towards(5), .sun = towards(30)}), 0);
  EXPECT_EQ(ground(a, {.altitude = 400e3, .view = towards(-90), .sun = towards(-1)}), 0) << "night";
}

}  // namespace
}  // namespace airlight::reference
