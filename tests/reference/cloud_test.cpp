#include "reference/cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "atmospheres.h"
#include "reference/adding_doubling.h"
#include "reference/monte_carlo.h"

namespace airlight::reference {
namespace {

/// Passed by chance in 1 of 1e5 comparisons.
constexpr double far = 4.5;
constexpr double endless = std::numeric_limits<double>::infinity();

/// Mean of random numbers, and its standard error.
template <class Draw>
std::pair<double, double> mean_of(int count, Draw draw) {
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double value = draw();
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, std::sqrt((squares / count - mean * mean) / count)};
}

/// A slab of even density above a planet, so wide that its sides do not matter, and the same over an `even` share of a
/// higher bound: three of four collisions are null.
Cloud slab(double planet_radius, double bottom, double top, double depth, double even = 1) {
  constexpr double half = 300e3;
  return {.box = {{-half, -half, planet_radius + bottom}, {half, half, planet_radius + top}},
          .density = [even](const Vector&) { return even; },
          .extinction = depth / (top - bottom) / even};
}

// Along x the density rises from 0 to 1 and ends: the optical depth to x is a parabola.
TEST(Cloud, collisions_and_transmittance_follow_the_optical_depth) {
  const double extinction = 3e-3, length = 1000;
  const Cloud cloud{.box = {{0, -1, -1}, {length, 1, 1}},
                    .density = [&](const Vector& p) { return p[0] / length; },
                    .extinction = extinction};
  Random random(1, 1);
  for (const double to : {200.0, 600.0, 5000.0})
    for (const bool backwards : {false, true}) {
      const Place from{{backwards ? length + 50 : -50, 0, 0}, {backwards ? -1.0 : 1.0, 0, 0}};
      const double inside = std::min(to - 50, length);
      const double depth = 0.5 * extinction / length *
                           (backwards ? length * length - (length - inside) * (length - inside) : inside * inside);
      const auto [transmittance, error] = mean_of(40000, [&] { return draw_transmittance(cloud, from, to, random); });
      EXPECT_NEAR(transmittance, std::exp(-depth), far * error) << to;
      const auto [missed, chance_error] =
          mean_of(40000, [&] { return std::isinf(draw_collision(cloud, from, to, random)); });
      EXPECT_NEAR(missed, std::exp(-depth), far * chance_error) << to;
    }
  EXPECT_EQ(draw_transmittance(cloud, {{0, 2, 0}, {1, 0, 0}}, endless, random), 1) << "beside the box";
}

// Where collisions happen is drawn with density extinction * exp(-depth): the mean place has a closed form.
TEST(Cloud, collisions_in_even_density_are_exponential) {
  const Cloud cloud{.box = {{0, 0, 0}, {1e9, 1, 1}}, .density = [](const Vector&) { return 0.25; }, .extinction = 4e-3};
  Random random(2, 1);
  const auto [mean, error] = mean_of(40000, [&] {
    return draw_collision(cloud, {{0, 0.5, 0.5}, {1, 0, 0}}, endless, random);
  });
  EXPECT_NEAR(mean, 1000, far * error);
}

TEST(Cloud, grids_are_linear_between_their_corners) {
  const Box box{{-1, 2, 10}, {3, 5, 20}};
  const std::array<int, 3> counts{3, 4, 6};
  const auto f = [](double x, double y, double z) { return 0.1 + 0.02 * x + 0.01 * y * z / 20 + 0.003 * x * y; };
  std::vector<double> values;
  for (int k = 0; k < counts[2]; ++k)
    for (int j = 0; j < counts[1]; ++j)
      for (int i = 0; i < counts[0]; ++i) values.push_back(f(-1 + 2.0 * i, 2 + j, 10 + 2.0 * k));
  const DensityGrid grid(box, counts, values);
  Random random(3, 1);
  for (int i = 0; i < 100; ++i) {
    const Vector p{-1 + 4 * random(), 2 + 3 * random(), 10 + 10 * random()};
    EXPECT_NEAR(grid(p), f(p[0], p[1], p[2]), 1e-12);
  }
  EXPECT_THROW(DensityGrid(box, counts, std::vector<double>(5)), InputError);
  values[7] = 1.5;
  EXPECT_THROW(DensityGrid(box, counts, values), InputError);
}

// Sunlight scattered once by a cloud of even density in vacuum, looked at from below and from above: the integral of two
// exponentials. Flat but for 1e9 m of radius.
TEST(Cloud, light_scattered_once_has_a_closed_form) {
  const double radius = 1e9, depth = 1.5, albedo = 0.9, g = 0.6;
  Atmosphere none = vacuum(radius, 10e3);
  none.planet.albedo = 0.0;
  none.sun.irradiance = 1;
  Cloud cloud = slab(radius, 1e3, 3e3, depth, 0.25);
  cloud.single_scattering_albedo = albedo;
  cloud.phase = HenyeyGreensteinPhase{g};
  const MonteCarlo solver(none, {&wavelength, 1},
                          {.max_order = 1, .point_sun = true, .cloud = std::make_shared<Cloud>(cloud)});
  const Direction sun = towards(35);
  const double mu_s = sun[2];
  for (const bool above : {false, true})
    for (const double elevation : {80.0, 40.0}) {
      const Direction view = towards(above ? -elevation : elevation, 50);
      const double mu = std::abs(view[2]), cosine = dot(view, sun);
      const double phase = (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5) / (4 * std::numbers::pi);
      const double expected = albedo * phase / mu *
                              (above ? -std::expm1(-depth * (1 / mu + 1 / mu_s)) / (1 / mu + 1 / mu_s)
                                     : (std::exp(-depth / mu_s) - std::exp(-depth / mu)) / (1 / mu - 1 / mu_s));
      const RandomLight light =
          solver.radiance({.altitude = above ? 8e3 : 2, .view = view, .sun = sun}, {.walks = 16384});
      EXPECT_NEAR(light.total.mean[0], expected, far * light.total.standard_error[0]) << elevation << above;
      EXPECT_LT(light.total.standard_error[0], 0.02 * expected);
    }
}

// All orders through a cloud of depth 1 over bright ground, and of depth 50, against adding and doubling.
TEST(Cloud, light_of_all_orders_agrees_with_adding_and_doubling) {
  const double radius = 1e9;
  for (const double depth : {1.0, 50.0}) {
    Atmosphere air = with(vacuum(radius, 10e3), layer(5e3, 10e3), 0.2 / 5e3, 0, RayleighPhase{0.03});
    air.planet.albedo = 0.4;
    air.sun.irradiance = 1;
    Cloud cloud = slab(radius, 1e3, 2e3, depth, 0.5);
    cloud.phase = HenyeyGreensteinPhase{0.7};
    cloud.single_scattering_albedo = 0.999;
    const AddingDoubling truth(
        PlaneParallelAir{{Layer{{Scatterer{0.2, RayleighPhase{0.03}}}, 0},
                          Layer{{Scatterer{0.999 * depth, HenyeyGreensteinPhase{0.7}}}, 0.001 * depth}},
                         0.4});
    const MonteCarlo solver(air, {&wavelength, 1}, {.point_sun = true, .cloud = std::make_shared<Cloud>(cloud)});
    for (const bool above : {false, true}) {
      const Direction view = towards(above ? -50 : 50, 120), sun = towards(40);
      const RandomLight light =
          solver.radiance({.altitude = above ? 20e3 : 2, .view = view, .sun = sun}, {.walks = 8192});
      const double expected = truth.radiance(above ? Level::space : Level::ground, {&view, 1}, sun).front();
      EXPECT_NEAR(light.total.mean[0], expected, far * light.total.standard_error[0]) << depth << above;
      // One walk in a hundred comes through the thick one.
      EXPECT_LT(light.total.standard_error[0], (depth > 10 ? 0.12 : 0.05) * expected) << depth << above;
    }
  }
}

// The same air twice: as a constituent, whose columns are known, and as a cloud, walked through by null collisions. On
// a small round planet, four wavelengths at once, with the sun's disc; from the ground, above and in twilight.
TEST(Cloud, a_constituent_given_as_a_cloud_gives_the_same_light) {
  const double wavelengths[] = {420, 500, 580, 660}, radius = 500e3, top = 40e3, height = 6e3, extinction = 4e-5;
  Atmosphere clear = with(vacuum(radius, top), ExponentialProfile{8e3}, 1.2e-5, 0, RayleighPhase{0.03});
  clear.constituents[0].scattering = Spectrum(Spectrum::Law(PowerSpectrum{550, 1.2e-5, -4}));
  const Atmosphere hazy =
      with(clear, ExponentialProfile{height}, 0.9 * extinction, 0.1 * extinction, HenyeyGreensteinPhase{0.7});
  Cloud cloud{.box = {{-600e3, -600e3, -600e3}, {600e3, 600e3, 600e3}},
              .density =
                  [=](const Vector& p) {
                    const double altitude = length(p) - radius;
                    return altitude > top ? 0.0 : std::min(std::exp(-altitude / height), 1.0);
                  },
              .extinction = extinction,
              .single_scattering_albedo = 0.9,
              .phase = HenyeyGreensteinPhase{0.7}};
  const MonteCarlo known(hazy, wavelengths, {.seed = 1, .random_first_order = true}),
      walked(clear, wavelengths, {.seed = 2, .cloud = std::make_shared<Cloud>(cloud)});
  const Ray rays[] = {{.altitude = 2, .view = towards(25, 30), .sun = towards(40)},
                      {.altitude = 2, .view = towards(8, 60), .sun = towards(-3)},
                      {.altitude = 9e3, .view = towards(-20, 60), .sun = towards(10)},
                      {.altitude = 90e3, .view = towards(-29.5, 60), .sun = towards(30)},
                      {.altitude = 100, .view = towards(2, 10), .sun = towards(20), .distance = 8e3}};
  for (const Ray& ray : rays) {
    const RandomLight a = known.radiance(ray, {.walks = 8192}), b = walked.radiance(ray, {.walks = 8192});
    for (std::size_t w = 0; w < 4; ++w) {
      const double error = std::hypot(a.total.standard_error[w], b.total.standard_error[w]);
      EXPECT_NEAR(a.total.mean[w], b.total.mean[w], far * error) << ray.altitude << " at " << wavelengths[w];
      EXPECT_LT(error, 0.1 * a.total.mean[w]);
    }
  }
}

// Droplets that absorb nothing, white ground, even light: radiance 1 everywhere, inside the cloud too.
TEST(Cloud, furnace_of_optical_depth_50) {
  const double radius = 6.371e6;
  Atmosphere air = with(vacuum(radius, 50e3), ExponentialProfile{8e3}, 1e-5, 0, RayleighPhase{});
  air.planet.albedo = 1.0;
  const MonteCarlo solver(air, {&wavelength, 1},
                          {.uniform_light = true, .cloud = std::make_shared<Cloud>(slab(radius, 1e3, 2e3, 50, 0.5))});
  for (const double altitude : {2.0, 1500.0, 5e3}) {
    const RandomLight light =
        solver.radiance({.altitude = altitude, .view = towards(altitude > 2e3 ? -40 : 40)}, {.walks = 512});
    EXPECT_NEAR(light.total.mean[0], 1, far * light.total.standard_error[0] + 1e-9) << altitude;
    EXPECT_LT(light.total.standard_error[0], 0.1) << altitude;
  }
}

TEST(Cloud, names_what_is_wrong) {
  const auto message = [](const Cloud& cloud) -> std::string {
    try {
      MonteCarlo(vacuum(), {&wavelength, 1}, {.cloud = std::make_shared<Cloud>(cloud)})
          .radiance({.altitude = 2, .view = towards(60), .sun = towards(30)}, {.walks = 64});
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  Cloud cloud = slab(6.371e6, 1e3, 2e3, 5);
  EXPECT_EQ(message(cloud), "");
  cloud.density = [](const Vector&) { return 1.5; };
  EXPECT_NE(message(cloud).find("density is 1.5"), std::string::npos);
  cloud.density = {};
  EXPECT_NE(message(cloud).find("density is missing"), std::string::npos);
  cloud = slab(6.371e6, 1e3, 2e3, 5);
  cloud.extinction = 0;
  EXPECT_NE(message(cloud).find("extinction is 0"), std::string::npos);
  cloud = slab(6.371e6, 2e3, 1e3, 5);
  cloud.extinction = 1;
  EXPECT_NE(message(cloud).find("along z"), std::string::npos);
}

}  // namespace
}  // namespace airlight::reference
