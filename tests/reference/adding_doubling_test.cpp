// What must hold whatever the numbers are.
#include "adding_doubling.h"

#include <gtest/gtest.h>

#include <numbers>

#include "airlight/error.h"
#include "atmospheres.h"
#include "reference/adding_doubling_legendre.h"
#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

TablePhase tabulated(const Phase& source, int count) {
  TablePhase table;
  for (int i = 0; i < count; ++i) {
    table.angles.push_back(i == count - 1 ? pi : pi * i / (count - 1));
    table.values.push_back(phase(source, 1 - std::cos(table.angles.back())));
  }
  return table;
}

// The moments must sum to the function that they were taken from, also for those found by closed forms.
TEST(AddingDoubling, moments_sum_to_the_phase_function) {
  for (const Phase& p :
       {Phase(RayleighPhase{0.0}), Phase(RayleighPhase{0.04}), Phase(IsotropicPhase{}),
        Phase(HenyeyGreensteinPhase{0.6}), Phase(CornetteShanksPhase{0.6}),
        Phase(DoubleHenyeyGreensteinPhase{0.6, -0.4, 0.8}), Phase(tabulated(RayleighPhase{0.0}, 400))}) {
    const std::vector<double> moments = legendre_moments(p, 100);
    // 0.6^100 is beyond rounding; a table of 400 angles is wrong by (pi / 400)^2 / 8.
    const double tolerance = p.index() == 5 ? 2e-5 : 1e-12;
    for (const double angle : {0.0, 0.7, 1.6, 2.5, pi}) {
      const std::vector<double> legendre = legendre_functions(0, 100, std::cos(angle));
      double sum = 0;
      for (int l = 0; l < 100; ++l) sum += (2 * l + 1) * moments[l] * legendre[l] / (4 * pi);
      EXPECT_NEAR(sum / phase(p, 1 - std::cos(angle)), 1, tolerance) << p.index() << " at " << angle;
    }
  }
}

// P_l of the angle between two directions, from both directions' own functions: l = 7 needs all terms up to 7.
TEST(AddingDoubling, harmonics_obey_the_addition_theorem) {
  const double a = 0.3, b = -0.8, azimuth = 1.1;
  const double cosine = a * b + std::sqrt((1 - a * a) * (1 - b * b)) * std::cos(azimuth);
  double sum = 0;
  for (int m = 0; m <= 7; ++m)
    sum += (m ? 2 : 1) * legendre_functions(m, 8, a)[7] * legendre_functions(m, 8, b)[7] * std::cos(m * azimuth);
  EXPECT_NEAR(sum, legendre_functions(0, 8, cosine)[7], 1e-14);
  EXPECT_NEAR(legendre_functions(0, 8, 0.5)[3], -0.4375, 1e-15);  // P_3 = (5 mu^3 - 3 mu) / 2
}

// Without absorption all light goes up or into the ground, at any depth.
TEST(AddingDoubling, conservative_air_loses_nothing) {
  for (const double depth : {1e-3, 0.3, 5.0, 64.0, 1e4})
    for (const Phase& p : {Phase(RayleighPhase{}), Phase(HenyeyGreensteinPhase{0.85})})
      for (const double sun : {0.02, 0.5, 1.0}) {
        const AddingDoubling solver({{layer(depth, 1, p)}, 0});
        const auto [direct, diffuse, upward] = solver.fluxes(sun);
        // Doubling starts with an error of 1e-16 of a layer's light, which a deep slab scatters depth^2 times.
        EXPECT_NEAR((direct + diffuse + upward) / sun, 1, depth > 100 ? 1e-7 : 1e-11) << depth << ' ' << sun;
      }
}

TEST(AddingDoubling, a_white_ground_sends_everything_back) {
  const AddingDoubling solver({{layer(3, 1, CornetteShanksPhase{0.7})}, 1});
  EXPECT_NEAR(solver.fluxes(0.6).upward, 0.6, 1e-10);  // as above
}

// The ground is a further layer's mirror: downward light at a ground of albedo A is that over black, plus what the air
// throws back of it, in a geometric series.
TEST(AddingDoubling, ground_and_air_reflect_in_turns) {
  const auto arriving = [](double albedo) {
    const auto f = AddingDoubling({{layer(0.5, 0.9, RayleighPhase{})}, albedo}).fluxes(0.4);
    return f.direct + f.diffuse;
  };
  // 1 / arriving is linear in the albedo.
  EXPECT_NEAR(2 / arriving(0.4), 1 / arriving(0.1) + 1 / arriving(0.7), 1e-12);
}

// Light that leaves towards v for a sun at s is that towards s for a sun at v, per light on the ground's plane.
TEST(AddingDoubling, reflected_light_is_reciprocal) {
  const AddingDoubling solver({{layer(0.4, 0.8, CornetteShanksPhase{0.7}), layer(1, 0.99, RayleighPhase{})}, 0.3});
  for (const auto& [a, b, azimuth] : {std::array{0.3, 0.9, 0.5}, std::array{0.05, 0.6, 2.5}}) {
    const double there = radiances(solver, Level::space, {a}, b, azimuth)[0] / b;
    const double back = radiances(solver, Level::space, {b}, a, azimuth)[0] / a;
    EXPECT_NEAR(there / back, 1, 1e-9)
        << a;  // a listener's row against a sender's column: rounding, and the thin start
  }
}

// How air is cut into layers, and how one constituent is split, is bookkeeping.
TEST(AddingDoubling, cuts_and_mixtures_change_nothing) {
  const Phase haze = HenyeyGreensteinPhase{0.7};
  const AddingDoubling whole({{{{{0.3, RayleighPhase{}}, {0.6, haze}}, 0.1}}, 0.2});
  const Layer third{{{0.1, RayleighPhase{}}, {0.2, haze}}, 0.1 / 3},
      rest{{{0.2, RayleighPhase{}}, {0.4, haze}}, 0.2 / 3};
  const Layer twice{{{0.3, RayleighPhase{}}, {0.25, haze}, {0.35, haze}}, 0.1};
  const Layer nothing;
  const std::vector<double> cosines{1e-6, 0.01, 0.3, 0.9, 1};
  for (const Level level : {Level::ground, Level::space}) {
    const auto expected = radiances(whole, level, cosines, 0.5, 0.8);
    for (const std::vector<Layer>& layers : {std::vector{third, rest}, std::vector{rest, third}, std::vector{twice},
                                             std::vector{nothing, third, nothing, rest, nothing}}) {
      const auto found = radiances(AddingDoubling({layers, 0.2}), level, cosines, 0.5, 0.8);
      for (std::size_t i = 0; i < cosines.size(); ++i)
        EXPECT_NEAR(found[i] / expected[i], 1, 5e-9) << cosines[i];  // the thin start, worst in the horizon
    }
  }
}

TEST(AddingDoubling, the_upper_layer_lies_above) {
  // An absorber hides what lies below it: from space the bright layer shines only when it is the upper one.
  const Layer bright = layer(0.5, 1, IsotropicPhase{}), dark = layer(3, 0, IsotropicPhase{});
  EXPECT_GT(radiances(AddingDoubling({{bright, dark}, 0}), Level::space, {0.7}, 0.7)[0],
            20 * radiances(AddingDoubling({{dark, bright}, 0}), Level::space, {0.7}, 0.7)[0]);
}

TEST(AddingDoubling, sky_irradiance_is_the_integral_of_radiance) {
  const AddingDoubling solver({{layer(0.3, 0.95, RayleighPhase{0.03})}, 0.5});
  const GaussRule rule(24);
  std::vector<Direction> views;
  constexpr int azimuths = 8;  // Rayleigh light has two terms
  for (const double mu : rule.nodes)
    for (int k = 0; k < azimuths; ++k) views.push_back(at(mu * mu, 2 * pi * k / azimuths));
  const auto radiance = solver.radiance(Level::ground, views, at(0.4, 1.0));
  double sum = 0;
  for (std::size_t i = 0; i < views.size(); ++i)  // mu = x^2, since exp(-depth / mu) is steep at the horizon
    sum += radiance[i] * views[i][2] * 2 * rule.nodes[i / azimuths] * rule.weights[i / azimuths] * 2 * pi / azimuths;
  EXPECT_NEAR(sum / solver.fluxes(0.4).diffuse, 1, 1e-6);  // the solver's own 32 nodes on thin air
}

// Doubling starts with light scattered twice at most: the third order is left out, one part in the depth squared.
TEST(AddingDoubling, the_start_is_of_second_order) {
  const auto lost = [](double thinnest) {
    const auto f = AddingDoubling({{layer(1, 1, HenyeyGreensteinPhase{0.5})}, 0}, {.thinnest = thinnest}).fluxes(0.7);
    return f.direct + f.diffuse + f.upward - 0.7;
  };
  for (const double start : {1.0 / 4096, 1.0 / 16384, 1.0 / 65536}) {
    const double order = std::log2(lost(start) / lost(start / 2));
    EXPECT_GT(order, 1.9) << start;
    EXPECT_LT(order, 2.1) << start;
  }
}

// Half as many nodes again: what integrals over directions are wrong by. The horizon is the hardest place.
TEST(AddingDoubling, more_streams_change_little) {
  for (const Phase& p : {Phase(RayleighPhase{}), Phase(CornetteShanksPhase{0.8})})
    for (const double depth : {0.02, 0.5, 10.0}) {
      const PlaneParallelAir air{{layer(depth, 0.95, p)}, 0.3};
      const AddingDoubling coarse(air, {.streams = 32}), fine(air, {.streams = 48});
      for (const Level level : {Level::ground, Level::space}) {
        const std::vector<double> cosines{1e-6, 0.01, 0.2, 0.5, 0.9, 1};
        const auto a = radiances(coarse, level, cosines, 0.5, 0.4), b = radiances(fine, level, cosines, 0.5, 0.4);
        for (std::size_t i = 0; i < cosines.size(); ++i)
          EXPECT_NEAR(a[i] / b[i], 1, 2e-5) << p.index() << ' ' << depth << ' ' << cosines[i];
      }
    }
}

// A peak too sharp for the nodes: delta-M and exact single scattering leave this much beside the sun's aureole.
TEST(AddingDoubling, sharp_peaks_are_cut_with_little_loss) {
  const PlaneParallelAir air{{layer(0.5, 0.98, HenyeyGreensteinPhase{0.85})}, 0.1};
  const AddingDoubling cut(air, {.streams = 12}), whole(air, {.streams = 48});
  EXPECT_NEAR(cut.truncated(), std::pow(0.85, 24), 1e-15);  // 2 %
  const auto a = cut.fluxes(0.6), b = whole.fluxes(0.6);
  EXPECT_NEAR(a.diffuse / b.diffuse, 1, 1e-4);
  EXPECT_NEAR(a.upward / b.upward, 1, 1e-3);
  for (const double azimuth : {0.0, 1.0, 3.0}) {
    const auto c = radiances(cut, Level::ground, {0.1, 0.3, 0.6, 0.9}, 0.6, azimuth);
    const auto d = radiances(whole, Level::ground, {0.1, 0.3, 0.6, 0.9}, 0.6, azimuth);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(c[i] / d[i], 1, 0.01) << azimuth << ' ' << i;
  }
}

TEST(AddingDoubling, a_table_is_the_function_that_it_holds) {
  const Phase haze = HenyeyGreensteinPhase{0.6};
  const auto a = radiances(AddingDoubling({{layer(1, 0.9, haze)}, 0.1}), Level::ground, {0.1, 0.5, 1}, 0.5, 1.2);
  const auto b =
      radiances(AddingDoubling({{layer(1, 0.9, tabulated(haze, 600))}, 0.1}), Level::ground, {0.1, 0.5, 1}, 0.5, 1.2);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i] / b[i], 1, 1e-4);  // straight lines between 600 angles of a curved peak
}

// Air so thin that light is scattered once, on a planet so large that it is flat: another solver, in its own geometry.
TEST(AddingDoubling, thin_air_is_single_scattering) {
  constexpr double depth = 1e-5;
  const Phase haze = HenyeyGreensteinPhase{0.7};
  const Direction sun = towards(35, 70);
  for (const auto& [elevation, azimuth] : {std::pair{50.0, 100.0}, {20.0, 300.0}, {-30.0, 20.0}, {-80.0, 200.0}}) {
    const bool up = elevation > 0;
    Atmosphere flat = with(vacuum(1e12, 1e3), LayersProfile{{{0, 1e3, 1}}}, 0.8 * depth / 1e3, 0.2 * depth / 1e3, haze);
    flat.sun.irradiance = 1.0;
    flat.planet.albedo = up ? 0.0 : 0.3;  // what bright ground sends into the sky is light of the second order
    const Direction view = towards(elevation, azimuth);
    const RayLight light =
        SingleScattering(flat, by_point_sun).along({up ? 0 : 2e3, view, sun}, std::span(&wavelength, 1));
    const AddingDoubling solver({{layer(depth, 0.8, haze)}, up ? 0 : 0.3});
    // Of the light scattered once, a share of some depths is scattered again.
    EXPECT_NEAR(solver.radiance(up ? Level::ground : Level::space, {&view, 1}, sun)[0] /
                    (light.path_radiance[0] + light.ground_radiance[0]),
                1, 10 * depth)
        << elevation;
  }
}

TEST(AddingDoubling, bad_input_is_named) {
  const auto message = [](PlaneParallelAir air) -> std::string {
    try {
      AddingDoubling solver(std::move(air));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({{layer(1, 1, IsotropicPhase{})}, 1.5}).find("surface_albedo = 1.5: expected 0 .. 1"),
            std::string::npos);
  EXPECT_NE(message({{layer(-1, 1, IsotropicPhase{})}, 0}).find("layers[0].scatterers[0].optical_depth = -1"),
            std::string::npos);
  EXPECT_NE(message({{{}, layer(1, 1, HenyeyGreensteinPhase{1.2})}, 0}).find("layers[1].scatterers[0].phase.g = 1.2"),
            std::string::npos);
  const AddingDoubling solver({{layer(1, 1, IsotropicPhase{})}, 0});
  const Direction up{0, 0, 1};
  EXPECT_THROW(solver.radiance(Level::ground, {&up, 1}, towards(-1)), InputError);
  EXPECT_THROW(solver.fluxes(0), InputError);
}

}  // namespace
}  // namespace airlight::reference
