#include "reference/monte_carlo.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "airlight/error.h"
#include "atmospheres.h"
#include "reference/adding_doubling.h"
#include "reference/air.h"
#include "reference/layers.h"
#include "reference/random_picture.h"
#include "reference/walk.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

/// Results are given to a few standard errors; this one is passed by chance in 1 of 1e5 comparisons.
constexpr double far = 4.5;

/// Fixed, the same on every machine.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * double(random_()) * 0x1p-32; }

 private:
  std::mt19937 random_;
};

/// Rays of all kinds: from the ground to space, up, along the horizon, down, past the limb; sun 80 degrees up to 5
/// below.
Ray random_ray(Draw& draw, int kind, double planet_radius) {
  Ray ray;
  ray.altitude = kind == 3 ? draw.between(20e3, 400e3) : std::pow(10, draw.between(0, 4.6));
  const double dip = std::acos(planet_radius / (planet_radius + ray.altitude)) / degree;
  const double limb = planet_radius + draw.between(1e3, 0.5 * std::min(ray.altitude, 60e3));
  const double elevation = kind == 0   ? draw.between(1, 90)
                           : kind == 1 ? draw.between(-1, 1) - dip
                           : kind == 2 ? draw.between(-90, -dip - 1)
                                       : -std::acos(limb / (planet_radius + ray.altitude)) / degree;
  ray.view = towards(elevation, draw.between(0, 360));
  ray.sun = towards(draw.between(0, 1) < 0.4 ? draw.between(-5, 5) : draw.between(5, 80));
  if (draw.between(0, 1) < 0.25) ray.distance = std::pow(10, draw.between(2, 5));
  return ray;
}

/// Collects (value - truth) / standard error.
struct Scores {
  std::vector<double> all;
  void add(double value, double truth, double error) { all.push_back((value - truth) / error); }
  /// Prints and checks that they look like a unit normal.
  void expect_normal(const char* what) const {
    double mean = 0, squares = 0, worst = 0;
    for (const double z : all) mean += z / double(all.size());
    for (const double z : all) {
      squares += (z - mean) * (z - mean) / double(all.size() - 1);
      worst = std::max(worst, std::abs(z));
    }
    std::printf("%s: %zu z-scores, mean %.3f, standard deviation %.3f, largest %.2f\n", what, all.size(), mean,
                std::sqrt(squares), worst);
    EXPECT_LT(std::abs(mean), 0.15) << what;
    EXPECT_GT(std::sqrt(squares), 0.85) << what;
    EXPECT_LT(std::sqrt(squares), 1.15) << what;
    EXPECT_LT(worst, 5) << what;
  }
};

TEST(Layers, have_the_columns_of_the_quadratures_air) {
  for (const char* name : {"earth", "earth-hazy", "earth-bruneton", "mars-clear"}) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    const Air air(atmosphere, 1);
    const Layers layers(atmosphere);
    Draw draw(3);
    for (int i = 0; i < 300; ++i) {
      const double radius =
          air.planet_radius() + 0.9 * atmosphere.planet.top_altitude * std::pow(draw.between(0, 1), 3);
      const double dip = std::acos(air.planet_radius() / radius);
      const double elevation = i % 2 ? draw.between(-dip, pi / 2) : draw.between(-dip, 0.1);
      std::vector<double> a(air.constituents(), 0.0), b = a;
      air.add_columns(radius * std::cos(elevation), radius * std::sin(elevation),
                      std::numeric_limits<double>::infinity(), a);
      layers.add_columns_to_space({0, 0, radius}, {std::cos(elevation), 0, std::sin(elevation)},
                                  air.planet_radius() - 1, b);
      double difference = 0;
      for (std::size_t c = 0; c < a.size(); ++c)
        difference += std::abs(a[c] - b[c]) *
                      (atmosphere.constituents[c].scattering.at(400) + atmosphere.constituents[c].absorption.at(400));
      // 1e-6 of the vertical column in each layer; a grazing line may run a hundred times its thickness.
      EXPECT_LT(difference, 1e-4) << name << " radius " << radius << " elevation " << elevation / degree;
    }
  }
}

// The first order alone, left to chance, against quadrature: geometry, columns, phase functions, disc, ground, weights,
// and whether standard errors are honest. Each ray is asked with several seeds and one wavelength each, which makes
// scores independent.
TEST(MonteCarlo, first_order_agrees_with_quadrature) {
  Scores scores;
  Draw draw(4);
  for (const char* name : {"earth-bruneton", "mars-clear"}) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    const double wavelengths[] = {400, 480, 560, 680};
    const SingleScattering quadrature(atmosphere, {.tolerance = 1e-5});
    std::vector<std::unique_ptr<MonteCarlo>> solvers;
    for (const unsigned seed : {1, 2, 3, 4})
      solvers.push_back(std::make_unique<MonteCarlo>(
          atmosphere, wavelengths, MonteCarloSettings{.seed = seed, .max_order = 1, .random_first_order = true}));
    for (int i = 0; i < 72; ++i) {
      const Ray ray = random_ray(draw, i % 4, atmosphere.planet.ground_radius);
      const RayLight truth = quadrature.along(ray, wavelengths);
      for (std::size_t w = 0; w < 4; ++w) {
        const RandomLight light = solvers[w]->radiance(ray, {.walks = 4096});
        const double expected = truth.path_radiance[w] + truth.ground_radiance[w];
        if (expected < 1e-12) continue;  // night, or past the air
        // Where strata leave less than this, what the solvers themselves are worth counts: the quadrature was asked for
        // 1e-5, the layers' densities are within 2e-5.
        const double own = 3e-5 * expected;
        scores.add(light.total.mean[w], expected, std::hypot(light.total.standard_error[w], own));
      }
    }
  }
  EXPECT_GE(scores.all.size(), 500u);
  scores.expect_normal("first order, random against quadrature");
}

// What the guide, resampling, and the mixture of colours do to chances, weights must undo: the same light without them.
TEST(MonteCarlo, guided_walks_find_the_light_of_unguided_ones) {
  const double wavelengths[] = {400, 560, 700};
  Scores scores;
  Draw draw(5);
  for (const char* name : {"earth-bruneton", "mars-clear"}) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    const MonteCarlo guided(atmosphere, wavelengths, {.seed = 6, .random_first_order = true}),
        plain(atmosphere, wavelengths, {.seed = 7, .random_first_order = true, .guided = false});
    for (int i = 0; i < 24; ++i) {
      Ray ray = random_ray(draw, i % 4, atmosphere.planet.ground_radius);
      ray.sun = towards(draw.between(3, 60));  // unguided walks hardly find twilight
      const RandomLight a = guided.radiance(ray, {.walks = 2048}), b = plain.radiance(ray, {.walks = 4096});
      const std::size_t w = i % 3;
      if (a.total.mean[w] == 0 && b.total.mean[w] == 0) continue;
      scores.add(a.total.mean[w], b.total.mean[w], std::hypot(a.total.standard_error[w], b.total.standard_error[w]));
    }
  }
  double mean = 0;
  for (const double z : scores.all) {
    EXPECT_LT(std::abs(z), far);
    mean += z / double(scores.all.size());
  }
  EXPECT_LT(std::abs(mean), 3 / std::sqrt(double(scores.all.size())));
}

// Air that absorbs nothing over white ground under even light: radiance is 1 everywhere. Every error of weights,
// densities or roulette shows, the more the longer the walks.
TEST(MonteCarlo, furnace) {
  const double depths[] = {0.1, 1, 5};
  for (const double depth : depths) {
    Atmosphere atmosphere =
        with(vacuum(6.371e6, 50e3), ExponentialProfile{5000}, 0.7 * depth / 5000, 0, RayleighPhase{});
    atmosphere = with(atmosphere, ExponentialProfile{5000}, 0.3 * depth / 5000, 0, HenyeyGreensteinPhase{0.7});
    atmosphere.planet.albedo = 1.0;
    const MonteCarlo solver(atmosphere, {&wavelength, 1}, {.uniform_light = true});
    for (const Ray& ray : {Ray{.altitude = 2, .view = towards(20)}, Ray{.altitude = 2, .view = towards(-5)},
                           Ray{.altitude = 400e3, .view = towards(-60)}}) {
      const RandomLight light = solver.radiance(ray, {.walks = 4096});
      EXPECT_NEAR(light.total.mean[0], 1, far * light.total.standard_error[0]) << depth;
      EXPECT_LT(light.total.standard_error[0], 0.02);
    }
    const RandomLight light = solver.sky_irradiance({.altitude = 2}, {.walks = 4096});
    EXPECT_NEAR(light.total.mean[0] / pi, 1, far * light.total.standard_error[0] / pi) << depth;
  }
}

// Thousands of scatterings in each walk. AIRLIGHT_LONG_TESTS=1: ten times as many walks.
TEST(MonteCarlo, furnace_of_optical_depth_50) {
  Atmosphere atmosphere = with(vacuum(6.371e6, 1e3), layer(0, 1e3), 50e-3, 0);
  atmosphere.planet.albedo = 1.0;
  const MonteCarlo solver(atmosphere, {&wavelength, 1}, {.uniform_light = true});
  const RandomLight light = solver.radiance({.altitude = 2, .view = towards(60)},
                                            {.walks = std::getenv("AIRLIGHT_LONG_TESTS") ? 20480 : 2048});
  EXPECT_NEAR(light.total.mean[0], 1, far * light.total.standard_error[0]);
  EXPECT_LT(light.total.standard_error[0], 0.05);
}

Atmosphere mixture() {
  Atmosphere a = with(with(with(vacuum(), ExponentialProfile{8000}, 1.2e-5, 0, RayleighPhase{0.03}),
                           ExponentialProfile{1200}, 6e-5, 1e-5, HenyeyGreensteinPhase{0.7}),
                      TentProfile{25000, 15000}, 0, 3e-6);
  a.constituents[0].scattering = Spectrum(Spectrum::Law(PowerSpectrum{550, 1.2e-5, -4}));
  return a;
}

// Standard errors against the spread of 40 independent runs.
TEST(MonteCarlo, errors_are_honest) {
  const double wavelengths[] = {420, 600};
  const Ray rays[] = {{.altitude = 2, .view = towards(20, 30), .sun = towards(40)},
                      {.altitude = 2, .view = towards(10, 60), .sun = towards(-4)},
                      {.altitude = 9e3, .view = towards(-20, 60), .sun = towards(5)}};
  constexpr unsigned runs = 40;
  struct Run {
    double mean = 0, squares = 0, claimed = 0;
  } asked[std::size(rays)];
  for (unsigned seed = 1; seed <= runs; ++seed) {
    const MonteCarlo solver(mixture(), wavelengths, {.seed = seed, .random_first_order = true});
    for (std::size_t i = 0; i < std::size(rays); ++i) {
      const RandomLight light = solver.radiance(rays[i], {.walks = 1024});
      const double value = light.total.mean[0], apart = value - asked[i].mean;
      asked[i].mean += apart / seed;
      asked[i].squares += apart * (value - asked[i].mean);
      asked[i].claimed += light.total.standard_error[0] * light.total.standard_error[0] / runs;
    }
  }
  double ratios = 0;
  for (const Run& run : asked) {
    const double ratio = std::sqrt(run.squares / (runs - 1) / run.claimed);
    std::printf("spread of %u runs over the claimed standard error: %.2f\n", runs, ratio);
    ratios += ratio / std::size(rays);
  }
  // The standard deviation of 3 x 39 numbers is known to 1 / sqrt(2 x 117) = 7 %.
  EXPECT_NEAR(ratios, 1, 0.2);
}

TEST(MonteCarlo, threads_change_nothing) {
  const double wavelengths[] = {420, 600};
  const MonteCarlo solver(mixture(), wavelengths);
  const Ray ray{.altitude = 2, .view = towards(20, 30), .sun = towards(10)};
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return solver.radiance(ray, {.target_error = 0.01});
  };
  const RandomLight one = run(1), three = run(3);
  EXPECT_EQ(one.walks, three.walks);
  EXPECT_EQ(one.total.mean, three.total.mean);
  EXPECT_EQ(one.total.standard_error, three.total.standard_error);
}

TEST(MonteCarlo, seeds_and_rays_have_random_numbers_of_their_own) {
  const Ray ray{.altitude = 2, .view = towards(20, 30), .sun = towards(10)};
  Ray neighbour = ray;
  neighbour.view = towards(20, 30.0000001);
  const auto radiance = [](unsigned seed, const Ray& r) {
    return MonteCarlo(mixture(), {&wavelength, 1}, {.seed = seed}).radiance(r, {.walks = 64}).total.mean[0];
  };
  EXPECT_EQ(radiance(1, ray), radiance(1, ray));
  EXPECT_NE(radiance(1, ray), radiance(2, ray));
  EXPECT_GT(std::abs(radiance(1, ray) / radiance(1, neighbour) - 1), 1e-6);
}

TEST(MonteCarlo, orders_add_up_and_end_at_max_order) {
  const Ray ray{.altitude = 2, .view = towards(20, 30), .sun = towards(30)};
  const RandomLight all = MonteCarlo(mixture(), {&wavelength, 1}).radiance(ray, {.walks = 1024});
  double sum = 0;
  for (const Estimate& order : all.orders) sum += order.mean[0];
  EXPECT_NEAR(sum / all.total.mean[0], 1, 1e-12);
  // The same, cut short; a batch's random numbers part after its first walk.
  const RandomLight three = MonteCarlo(mixture(), {&wavelength, 1}, {.max_order = 3}).radiance(ray, {.walks = 1024});
  EXPECT_NEAR(three.orders[2].mean[0], all.orders[2].mean[0],
              far * std::hypot(three.orders[2].standard_error[0], all.orders[2].standard_error[0]));
  EXPECT_EQ(three.orders[3].mean[0], 0);
  EXPECT_GT(all.orders[3].mean[0], 0);
}

// Helmholtz: a slab's reflected radiance over incident irradiance is the same with sun and view exchanged
// (Chandrasekhar 1950, section 52). The planet is so large that 10 km of air are plane.
TEST(MonteCarlo, reflected_light_is_reciprocal) {
  Atmosphere slab = with(with(vacuum(1e9, 10e3), layer(0, 6e3), 1e-4, 1e-5, HenyeyGreensteinPhase{0.6}),
                         ExponentialProfile{3e3}, 1e-4, 0, RayleighPhase{0.03});
  const MonteCarlo solver(slab, {&wavelength, 1}, {.point_sun = true});
  for (const auto& [a, b] : {std::pair{80.0, 25.0}, std::pair{60.0, 15.0}, std::pair{40.0, 30.0}}) {
    const auto reflected = [&](double view, double sun) {
      const RandomLight light =
          solver.radiance({.altitude = 20e3, .view = towards(-view), .sun = towards(sun, 70)}, {.walks = 16384});
      const double s = std::sin(sun * degree);
      return std::pair{light.total.mean[0] / s, light.total.standard_error[0] / s};
    };
    // Of the sky's frame: looking down at the azimuth 0 is looking back along light that leaves towards 180.
    const auto [there, error] = reflected(a, b);
    const auto [back, back_error] = reflected(b, a);
    EXPECT_NEAR(there / back, 1, far * std::hypot(error, back_error) / back) << a << " " << b;
    EXPECT_LT(error / there, 0.01);
  }
}

/// Integral over the unit cube by a lattice with random shifts, each shift an independent estimate with its error.
template <class Function>
std::pair<double, double> lattice(int points, Draw& draw, Function f) {
  constexpr int shifts = 8;
  // Roberts' generalisation of the golden ratio to four dimensions.
  constexpr double steps[] = {0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101};
  double mean = 0, squares = 0;
  for (int shift = 1; shift <= shifts; ++shift) {
    double offset[4], x[4], sum = 0;
    for (double& o : offset) o = draw.between(0, 1);
    for (int i = 0; i < points; ++i) {
      for (int k = 0; k < 4; ++k) {
        const double moved = offset[k] + i * steps[k];
        x[k] = moved - std::floor(moved);
      }
      sum += f(x) / points;
    }
    const double apart = sum - mean;
    mean += apart / shift;
    squares += apart * (sum - mean);
  }
  return {mean, std::sqrt(squares / (shifts - 1) / shifts)};
}

// A whole planet: sunlight that falls on its sphere of air = light that passes + light thrown back + light absorbed by
// ground and air. A small planet with much air, so that its round edge counts. One walk for each place and direction;
// AIRLIGHT_LONG_TESTS=1: sixteen times as many.
TEST(MonteCarlo, energy_balance_of_a_whole_planet) {
  const double R = 1e6, top = 150e3, height = 25e3, scattering = 2e-5, absorption = 4e-6, albedo = 0.4;
  Atmosphere planet =
      with(vacuum(R, top), ExponentialProfile{height}, scattering, absorption, HenyeyGreensteinPhase{0.5});
  planet.planet.albedo = albedo;
  const WalkRules rules(planet, {&wavelength, 1}, {.kept_orders = 1, .point_sun = true, .random_first_order = true});
  Walker walker(rules);
  Random random(1, 1);
  constexpr double endless = std::numeric_limits<double>::infinity();
  const auto sun = [](double cosine) { return Vector{0, std::sqrt((1 - cosine) * (1 + cosine)), cosine}; };
  const auto direct = [&](double radius, double sun_cosine) {
    double column = 0;
    const bool lit = rules.layers.add_columns_to_space({0, 0, radius}, sun(sun_cosine), R, {&column, 1});
    return lit ? std::exp(-(scattering + absorption) * column) : 0;
  };
  const auto radiance = [&](double radius, double view_cosine, double azimuth, double sun_cosine) {
    const double sine = std::sqrt((1 - view_cosine) * (1 + view_cosine));
    const Place place{{0, 0, radius}, {sine * std::sin(azimuth), sine * std::cos(azimuth), view_cosine}};
    const WalkStart start{place, sun(sun_cosine), R, endless, true, 1};
    double light = 0;
    walker.walk(start, walker.first_flight(start), random(), 1, random, {&light, 1});
    return light;
  };
  // The sun's cosines over the whole planet, with most places where it shines.
  const auto with_suns = [](const double* x, const auto& f) {
    const double cosine = x[0] < 0.1 ? 20 * x[0] - 1 : 1.5 * std::sqrt((x[0] - 0.1) / 0.9) - 0.5;
    const double density = 0.05 + (cosine > -0.5 ? 0.9 * 2 * (cosine + 0.5) / (1.5 * 1.5) : 0);
    return f(cosine) / density;
  };
  Draw draw(9);
  const int points = std::getenv("AIRLIGHT_LONG_TESTS") ? 480000 : 30000;
  const double incident = pi * (R + top) * (R + top);

  const auto ground = lattice(points, draw, [&](const double* x) {
    return with_suns(x, [&](double cosine) {
      const double sky = pi * radiance(R, std::sqrt(x[1]), pi * x[2], cosine);  // by Lambert's law
      return 2 * pi * R * R * (1 - albedo) * (sky + std::max(cosine, 0.0) * direct(R, cosine));
    });
  });
  const auto air = lattice(points, draw, [&](const double* x) {
    return with_suns(x, [&](double cosine) {
      const double share = -std::expm1(-top / height), radius = R - height * std::log1p(-x[1] * share);  // by density
      const double light = 4 * pi * radiance(radius, 2 * x[2] - 1, pi * x[3], cosine) + direct(radius, cosine);
      return 2 * pi * radius * radius * height * share * absorption * light;
    });
  });
  const auto out = lattice(points, draw, [&](const double* x) {
    return with_suns(x, [&](double cosine) {
      return 2 * pi * (R + top) * (R + top) * pi * radiance(R + top, -std::sqrt(x[1]), pi * x[2], cosine);
    });
  });
  const auto passed = lattice(10000, draw, [&](const double* x) {
    const double square = R * R + x[0] * (2 * R + top) * top;  // of the distance from the axis, by area
    Line line;
    rules.layers.trace({std::sqrt(square), 0, -2 * (R + top)}, {0, 0, 1}, R, endless, line);
    return pi * (2 * R + top) * top * std::exp(-(scattering + absorption) * line.columns.back());
  });
  const double sum = (ground.first + air.first + out.first + passed.first) / incident;
  const double error = std::hypot(ground.second, air.second, std::hypot(out.second, passed.second)) / incident;
  std::printf("energy: ground %.4f, air %.4f, out %.4f, passed %.4f; sum %.5f +- %.5f\n", ground.first / incident,
              air.first / incident, out.first / incident, passed.first / incident, sum, error);
  EXPECT_LT(error, 1e-3);
  EXPECT_NEAR(sum, 1, std::max(1e-3, 3 * error));
}

// Two layers and a bright ground, flat but for 1e9 m of radius, against a solver that knows neither walks nor spheres.
TEST(MonteCarlo, flat_air_agrees_with_adding_and_doubling) {
  Atmosphere flat = with(vacuum(1e9, 10e3), layer(2e3, 10e3), 0.25 / 8e3, 0, RayleighPhase{0.03});
  flat = with(with(flat, layer(0, 2e3), 0.3 / 2e3, 0.03 / 2e3, HenyeyGreensteinPhase{0.7}), layer(0, 2e3), 0.1 / 2e3, 0,
              RayleighPhase{0.03});
  flat.planet.albedo = 0.5;
  flat.sun.irradiance = 1;
  const Scatterer molecules{0.25, RayleighPhase{0.03}}, haze{0.3, HenyeyGreensteinPhase{0.7}},
      few{0.1, RayleighPhase{0.03}};
  const AddingDoubling truth(PlaneParallelAir{{Layer{{molecules}, 0}, Layer{{haze, few}, 0.03}}, 0.5});
  const MonteCarlo solver(flat, {&wavelength, 1}, {.point_sun = true});
  Scores scores;
  for (const double sun : {70.0, 35.0, 12.0})
    for (const double view : {75.0, 40.0, 15.0})
      for (const double azimuth : {20.0, 110.0, 170.0})
        for (const bool from_space : {false, true}) {
          const Ray ray{.altitude = from_space ? 20e3 : 0,
                        .view = towards(from_space ? -view : view, azimuth),
                        .sun = towards(sun)};
          const RandomLight light = solver.radiance(ray, {.walks = 8192});
          const double expected =
              truth.radiance(from_space ? Level::space : Level::ground, {&ray.view, 1}, ray.sun).front();
          // 15 degrees above the horizon, 10 km of air span 40 km and bend by 4e-5 of the zenith angle; 1e-4 of light.
          scores.add(light.total.mean[0], expected, std::hypot(light.total.standard_error[0], 1e-4 * expected));
          EXPECT_LT(light.total.standard_error[0], 0.01 * expected);
        }
  const RandomLight sky = solver.sky_irradiance({.sun = towards(35)}, {.walks = 16384});
  scores.add(sky.total.mean[0], truth.fluxes(std::sin(35 * degree)).diffuse, sky.total.standard_error[0]);
  double mean = 0;
  for (const double z : scores.all) {
    EXPECT_LT(std::abs(z), far);
    mean += z / double(scores.all.size());
  }
  std::printf("%zu z-scores against adding-doubling, mean %.2f\n", scores.all.size(), mean);
  EXPECT_LT(std::abs(mean), 3 / std::sqrt(double(scores.all.size())));
}

// Interrupted after one pass of three, stored, read again: the same picture to the last bit, with an honest error.
TEST(RandomPicture, goes_on_where_it_was_interrupted) {
  const auto question = [] {
    PictureQuestion q{mixture(), 6, 4, {}, {450, 600}, {{0, 1, 0}, {0, 1, 0}}};
    q.ray = [](int x, int y) -> std::optional<Ray> {
      if (x == 5) return std::nullopt;
      return Ray{.altitude = 2, .view = towards(15 + 20 * y, 30 * x), .sun = towards(30)};
    };
    return q;
  };
  const auto look = [](double) {};
  RandomPicture whole(question()), begun(question()), rest(question()),
      other({mixture(), 5, 4, {}, {450}, {{0, 1, 0}}});
  for (int i = 0; i < 30; ++i) whole.add_pass(look);
  for (int i = 0; i < 3; ++i) begun.add_pass(look);
  EXPECT_THROW(begun.add_pass([](double) { throw WorkError("stop"); }), WorkError);
  std::stringstream stored;
  begun.save(stored);
  const std::string text = stored.str();
  EXPECT_TRUE(rest.load(stored));
  for (int i = 3; i < 30; ++i) rest.add_pass(look);
  const MonteCarlo solver(mixture(), question().wavelengths, {.seed = 99});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x) {
      EXPECT_EQ(whole.xyz(x, y), rest.xyz(x, y));
      if (x == 5) {
        EXPECT_EQ(whole.xyz(x, y)[1], 0);
        continue;
      }
      const RandomLight light = solver.radiance(*question().ray(x, y), {.walks = 2048});
      const double truth = light.total.mean[0] + light.total.mean[1];
      EXPECT_NEAR(whole.xyz(x, y)[1], truth, truth * far * (whole.error(x, y) + 0.01));
      EXPECT_GT(whole.error(x, y), 0);
    }
  EXPECT_LT(whole.median_error(), 0.1);
  std::istringstream cut(text.substr(0, text.size() / 2)), size(text);
  EXPECT_FALSE(rest.load(cut));
  EXPECT_FALSE(other.load(size));
}

TEST(MonteCarlo, names_what_is_wrong) {
  const MonteCarlo solver(mixture(), {&wavelength, 1});
  const auto message = [&](const Ray& ray, const Budget& budget) -> std::string {
    try {
      solver.radiance(ray, budget);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(message({.distance = -1}, {.walks = 1}).find("distance"), std::string::npos);
  EXPECT_NE(message({}, {.target_error = -0.5}).find("target_error is -0.5"), std::string::npos);
  EXPECT_NE(message({}, {}).find("budget"), std::string::npos);
}

}  // namespace
}  // namespace airlight::reference
