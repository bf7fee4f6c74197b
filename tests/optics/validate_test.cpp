// Values that an atmosphere may not have; those that TOML can express are in tests/scenefile.
#include "optics/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Case {
  const char* expected;
  std::function<void(Atmosphere&)> spoil;
};

TEST(Validate, names_key_value_and_range) {
  const std::vector<Case> cases{
      {"planet.ground_radius = -3: expected 1000 .. 1e+09 m", [](Atmosphere& a) { a.planet.ground_radius = -3; }},
      {"planet.ground_radius = nan", [](Atmosphere& a) { a.planet.ground_radius = NAN; }},
      {"planet.top_altitude = -5: expected 1 .. 1e+09 m above the ground",
       [](Atmosphere& a) { a.planet.top_altitude = -5; }},
      {"planet.albedo = 1.5: expected 0 .. 1", [](Atmosphere& a) { a.planet.albedo = 1.5; }},
      {"sun.irradiance = inf", [](Atmosphere& a) { a.sun.irradiance = infinity; }},
      {"sun.angular_radius = 0: expected 1e-06 .. 1.5 rad", [](Atmosphere& a) { a.sun.angular_radius = 0; }},
      {"constituent[0].name", [](Atmosphere& a) { a.constituents[0].name = ""; }},
      {"constituent[1].name = \"molecules\"", [](Atmosphere& a) { a.constituents[1].name = "molecules"; }},
      {"constituent[1].profile.scale_height = 0",
       [](Atmosphere& a) { a.constituents[1].profile = ExponentialProfile{0}; }},
      {"constituent[1].profile.layers[1].bottom = 50: expected at least 100 m",
       [](Atmosphere& a) {
         a.constituents[1].profile = LayersProfile{{{0, 100, 1}, {50, 200, 1}}};
       }},
      {"constituent[1].profile.altitudes[1] = 0 after 0: expected strictly increasing",
       [](Atmosphere& a) {
         a.constituents[1].profile = TableProfile{{0, 0}, {1, 1}, false};
       }},
      {"constituent[1].scattering at",
       [](Atmosphere& a) {
         a.constituents[1].scattering = Spectrum(PowerSpectrum{550, 2000, 0});
       }},
      {"constituent[1].scattering at 360 nm",  // 1 / m at the ground, but the layer is denser
       [](Atmosphere& a) {
         a.constituents[1].profile = LayersProfile{{{5000, 6000, 1e5}}};
         a.constituents[1].scattering = Spectrum(PowerSpectrum{550, 1, 0});
       }},
      {"constituent[1].phase.g = 1", [](Atmosphere& a) { a.constituents[1].phase = HenyeyGreensteinPhase{1}; }},
      {"constituent[1].phase.angles[1] = 180",
       [](Atmosphere& a) {
         a.constituents[1].phase = TablePhase{{0, 180}, {1, 1}};
       }},
      {"constituent[1].phase.values: integral over the sphere",
       [](Atmosphere& a) {
         a.constituents[1].phase = TablePhase{{0, std::numbers::pi}, {1, 1}};
       }},
      {"planet.albedo.values[1] = 2: expected 0 .. 1",
       [](Atmosphere& a) {
         a.planet.albedo = Spectrum(TableSpectrum{{400, 500}, {0, 2}, Sampling::point, ""});
       }},
      {"planet.albedo.values: 1 values: expected 2, as many as wavelengths",
       [](Atmosphere& a) {
         a.planet.albedo = Spectrum(TableSpectrum{{400, 500}, {0}, Sampling::point, ""});
       }},
      {"planet.albedo.wavelengths[2] = 425: expected 420 nm, for bins are evenly spaced",
       [](Atmosphere& a) {
         a.planet.albedo = Spectrum(TableSpectrum{{400, 410, 425}, {0, 0, 0}, Sampling::bins, ""});
       }},
      {"atmosphere: no wavelength lies inside the data of every spectrum",
       [](Atmosphere& a) {
         a.planet.albedo = Spectrum(TableSpectrum{{900, 950}, {0, 0}, Sampling::point, ""});
       }},
      {"constituent[2].absorption.path_length", [](Atmosphere& a) { a.planet.top_altitude = 25'000; }},
  };
  for (const Case& bad : cases) {
    Atmosphere atmosphere = built_in_atmosphere("earth");
    bad.spoil(atmosphere);
    try {
      validate(atmosphere);
      ADD_FAILURE() << "accepted: " << bad.expected;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(std::string("atmosphere earth: ") + bad.expected), 0u) << error.what();
    }
  }
}

TEST(Validate, welcomes_odd_planets) {
  Atmosphere bare;
  bare.planet = {1000, 10, 0.0};
  bare.sun.irradiance = 1.0;
  EXPECT_NO_THROW(validate(bare)) << "no air at all";
  bare.planet = {1e8, 1e6, 1.0};
  EXPECT_NO_THROW(validate(bare)) << "a giant";
}

TEST(Validate, sphere_integral_of_a_uniform_table_is_exact) {
  const double p = 1 / (4 * std::numbers::pi);
  EXPECT_NEAR(sphere_integral({{0, 1, std::numbers::pi}, {p, p, p}}), 1, 1e-15);
  // p = angle / pi: 2 pi / pi * integral of angle * sin = 2 * pi.
  EXPECT_NEAR(sphere_integral({{0, 0.5, 2, std::numbers::pi}, {0, 0.5 / std::numbers::pi, 2 / std::numbers::pi, 1}}),
              2 * std::numbers::pi, 1e-14);
}

}  // namespace
}  // namespace airlight
