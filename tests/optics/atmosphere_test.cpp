// The built-in atmospheres against what is known of them, and their overrides.
#include "airlight/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "airlight/error.h"
#include "optics/coefficients.h"

namespace airlight {
namespace {

const Constituent& named(const Atmosphere& atmosphere, const std::string& name) {
  for (const Constituent& constituent : atmosphere.constituents) {
    if (constituent.name == name) return constituent;
  }
  throw std::out_of_range(name);
}

double scattering_depth(const Atmosphere& atmosphere, const std::string& name, double wavelength) {
  const Constituent& constituent = named(atmosphere, name);
  return constituent.scattering.at(wavelength) * path_length(constituent.profile, atmosphere.planet.top_altitude);
}

double absorption_depth(const Atmosphere& atmosphere, const std::string& name, double wavelength) {
  const Constituent& constituent = named(atmosphere, name);
  return constituent.absorption.at(wavelength) * path_length(constituent.profile, atmosphere.planet.top_altitude);
}

double depth(const Atmosphere& atmosphere, const std::string& name, double wavelength) {
  return scattering_depth(atmosphere, name, wavelength) + absorption_depth(atmosphere, name, wavelength);
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BuiltIn, all_are_valid_described_and_visible) {
  EXPECT_EQ(built_in_atmospheres().size(), 4u);
  for (const std::string_view name : built_in_atmospheres()) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    EXPECT_EQ(atmosphere.name, name);
    EXPECT_NO_THROW(validate(atmosphere)) << name;
    EXPECT_GT(describe_atmosphere(name).size(), 20u) << name;
    EXPECT_LE(wavelength_range(atmosphere).first, 360) << name;
    EXPECT_GE(wavelength_range(atmosphere).last, 830) << name;
  }
}

TEST(BuiltIn, unknown_names_get_a_suggestion) {
  EXPECT_NE(message_of([] { built_in_atmosphere("erth"); }).find("did you mean earth?"), std::string::npos);
  EXPECT_NE(message_of([] { built_in_atmosphere("venus"); }).find("mars-clear"), std::string::npos) << "lists them";
}

TEST(Earth, aerosol_is_the_one_ordered) {
  const Atmosphere earth = built_in_atmosphere("earth");
  EXPECT_NEAR(depth(earth, "aerosol", 550), 0.1, 1e-15);
  EXPECT_NEAR(scattering_depth(earth, "aerosol", 550), 0.095, 1e-15);
  EXPECT_NEAR(depth(earth, "aerosol", 400) / depth(earth, "aerosol", 800), std::pow(2, 1.3), 1e-12);
  EXPECT_EQ(std::get<HenyeyGreensteinPhase>(named(earth, "aerosol").phase).g, 0.7);
  EXPECT_NEAR(depth(built_in_atmosphere("earth-hazy"), "aerosol", 550), 0.4, 1e-15);
}

// Optical depth = column * cross-section, at the centre of a bin, where the file's value stands as it is.
TEST(Earth, ozone_column_reproduces_its_dobson_units) {
  const Atmosphere earth = built_in_atmosphere("earth");
  EXPECT_NEAR(absorption_depth(earth, "ozone", 605) / (300 * dobson_unit * 5.019e-25), 1, 1e-14);
  EXPECT_EQ(scattering_depth(earth, "ozone", 605), 0);
}

// Krueger & Minzner 1976 state 0.345 cm of ozone. Our table begins at 2 km and its lowest value continues to the
// ground.
TEST(Earth, ozone_profile_has_the_column_of_its_source) {
  const Atmosphere earth = built_in_atmosphere("earth");
  const Profile& profile = named(earth, "ozone").profile;
  const double dobson = 1e18 * path_length(profile, 120'000) / dobson_unit;
  EXPECT_NEAR(dobson, 345, 0.01 * 345);
  double highest = 0, where = 0;
  for (double altitude = 0; altitude < 80'000; altitude += 500) {
    if (density(profile, altitude) <= highest) continue;
    highest = density(profile, altitude);
    where = altitude;
  }
  EXPECT_NEAR(where, 22'000, 1) << "the layer's middle at mid-latitudes";
}

// Volume fractions of ozone in the US standard profile of Anderson et al. 1986 (AFGL-TR-86-0110), times the standard's
// number density of air: the same measurements, smoothed differently, within 2.1 %. A table shifted by one step of 2 km
// is 5 to 40 % off.
TEST(Earth, ozone_profile_is_that_of_the_afgl_standard) {
  struct Published {
    double altitude, fraction;
  };
  const Profile profile = named(built_in_atmosphere("earth"), "ozone").profile;
  for (const auto [altitude, fraction] : {Published{2'000, 3.237e-8},
                                          {10'000, 1.313e-7},
                                          {16'000, 8.701e-7},
                                          {20'000, 2.579e-6},
                                          {22'000, 3.647e-6},
                                          {24'000, 4.627e-6},
                                          {30'000, 6.553e-6},
                                          {40'000, 7.300e-6},
                                          {50'000, 3.100e-6}}) {
    const double expected = fraction * 2.5470e25 * density(StandardAtmosphereProfile{}, altitude);
    EXPECT_NEAR(1e18 * density(profile, altitude) / expected, 1, 0.025) << altitude;
  }
}

TEST(Earth, sun_seen_from_earth_is_half_a_degree_wide) {
  const Sun sun = built_in_atmosphere("earth").sun;
  EXPECT_NEAR(2 * sun.angular_radius * 180 / 3.14159265358979, 0.533, 1e-3);
  EXPECT_EQ(sun.irradiance.at(555), 1.8504) << "bin that begins at 550 nm";
}

// Bruneton 2017's demonstration: numbers of demo.cc, optical depths by hand.
TEST(EarthBruneton, is_the_demonstration) {
  const Atmosphere earth = built_in_atmosphere("earth-bruneton");
  EXPECT_EQ(earth.planet.ground_radius, 6'360'000);
  EXPECT_EQ(earth.planet.top_altitude, 60'000);
  EXPECT_EQ(earth.sun.irradiance.at(550), 1.8504) << "values at their wavelengths";
  EXPECT_EQ(earth.sun.irradiance.at(555), (1.8504 + 1.8341) / 2);
  EXPECT_EQ(earth.sun.limb_darkening, Spectrum(0.0));
  EXPECT_DOUBLE_EQ(named(earth, "molecules").scattering.at(1000), 1.24062e-6);
  EXPECT_NEAR(depth(earth, "aerosol", 700), 4.44e-6 * 1200, 1e-12);
  EXPECT_NEAR(scattering_depth(earth, "aerosol", 400) / depth(earth, "aerosol", 400), 0.9, 1e-15);
  // The tent's path is 15 km: maximum density 300 DU / 15 km, as in the demonstration.
  EXPECT_NEAR(named(earth, "ozone").absorption.at(600), 300 * 2.687e20 * 5.019e-25 / 15'000, 1e-18);
}

TEST(Mars, dust_has_the_optical_depth_and_the_colours_published) {
  const Atmosphere mars = built_in_atmosphere("mars-clear");
  for (const double nm : {360.0, 450.0, 550.0, 650.0, 830.0}) {
    EXPECT_NEAR(depth(mars, "dust", nm) + depth(mars, "dust-forward", nm), 0.3, 1e-14) << nm << ": extinction is grey";
  }
  const auto scattered = [&](double nm) {
    return scattering_depth(mars, "dust", nm) + scattering_depth(mars, "dust-forward", nm);
  };
  EXPECT_NEAR(scattered(388) / 0.3, 0.73, 1e-12);
  EXPECT_NEAR(scattered(650) / 0.3, 0.967, 1e-12);
  // Asymmetry of the sum of both lobes: 0.685 was measured at 650 nm; 0.700 is the mean of 400 to 800 nm.
  const auto asymmetry = [&](double nm) {
    return (0.094 * scattering_depth(mars, "dust", nm) + 0.889 * scattering_depth(mars, "dust-forward", nm)) /
           scattered(nm);
  };
  EXPECT_NEAR(asymmetry(650), 0.685, 1e-12);
  EXPECT_GT(asymmetry(440), 0.75);
  EXPECT_LT(asymmetry(830), 0.68);
}

// 610 Pa of carbon dioxide weigh 610 / 3.73 = 164 kg / m^2: optical depth = molecules * cross-section (Sneep & Ubachs
// 2005).
TEST(Mars, gas_has_the_weight_of_its_pressure) {
  const Atmosphere mars = built_in_atmosphere("mars-clear");
  const double molecules = 610 / 3.73 / (43.34 * 1.66053906660e-27);
  EXPECT_NEAR(scattering_depth(mars, "carbon dioxide", 550) / (molecules * 1.1637e-30), 1, 0.015);
  EXPECT_NEAR(mars.sun.irradiance.at(555) / 1.8504, 0.43, 0.005) << "at 1.524 astronomical units";
}

TEST(Overrides, change_what_they_name_and_nothing_else) {
  const Atmosphere earth = built_in_atmosphere("earth");
  EXPECT_EQ(with_overrides(earth, {}), earth);
  for (const std::string_view name : {"earth", "earth-bruneton"}) {
    const Atmosphere changed =
        with_overrides(built_in_atmosphere(name), {.aerosol_optical_depth = 0.25, .angstrom = 0.8, .ozone = 410});
    EXPECT_NO_THROW(validate(changed)) << name;
    EXPECT_NEAR(depth(changed, "aerosol", 550), 0.25, 1e-14) << name;
    EXPECT_NEAR(depth(changed, "aerosol", 400) / 0.25, std::pow(400 / 550.0, -0.8), 1e-12) << name;
    EXPECT_NEAR(
        scattering_depth(changed, "aerosol", 400) / depth(changed, "aerosol", 400),
        scattering_depth(built_in_atmosphere(name), "aerosol", 400) / depth(built_in_atmosphere(name), "aerosol", 400),
        1e-12);
    EXPECT_NEAR(absorption_depth(changed, "ozone", 605) / absorption_depth(built_in_atmosphere(name), "ozone", 605),
                410.0 / 300, 1e-12);
    EXPECT_EQ(named(changed, "molecules"), named(built_in_atmosphere(name), "molecules"));
  }
}

TEST(Overrides, angstrom_keeps_the_optical_depth_at_550_nm) {
  const Atmosphere changed = with_overrides(built_in_atmosphere("earth-hazy"), {.angstrom = 2.1});
  EXPECT_NEAR(depth(changed, "aerosol", 550), 0.4, 1e-14);
}

TEST(Overrides, of_nothing_leave_clean_air) {
  const Atmosphere changed = with_overrides(built_in_atmosphere("earth"), {.aerosol_optical_depth = 0, .ozone = 0});
  EXPECT_EQ(depth(changed, "aerosol", 550), 0);
  EXPECT_EQ(depth(changed, "ozone", 605), 0);
  EXPECT_NO_THROW(validate(changed));
}

TEST(Overrides, work_where_the_albedo_depends_on_wavelength) {
  Atmosphere earth = built_in_atmosphere("earth");
  const Spectrum albedo(TableSpectrum{{360, 830}, {0.9, 0.99}, Sampling::point, ""});
  const auto split = split_extinction(Spectrum(PowerSpectrum{550, 1e-4, -1}), albedo);
  earth.constituents[1].scattering = split.scattering;
  earth.constituents[1].absorption = split.absorption;
  const Atmosphere changed = with_overrides(earth, {.aerosol_optical_depth = 0.3, .angstrom = 2});
  EXPECT_NEAR(depth(changed, "aerosol", 550), 0.3, 1e-14);
  EXPECT_NEAR(depth(changed, "aerosol", 400) / 0.3, std::pow(400 / 550.0, -2), 1e-12);
  EXPECT_NEAR(scattering_depth(changed, "aerosol", 830) / depth(changed, "aerosol", 830), 0.99, 1e-12);
}

TEST(Overrides, refuse_what_cannot_be) {
  const Atmosphere earth = built_in_atmosphere("earth"), mars = built_in_atmosphere("mars-clear");
  const auto refusal = [](const Atmosphere& atmosphere, const AirOverrides& overrides) {
    return message_of([&] { with_overrides(atmosphere, overrides); });
  };
  EXPECT_EQ(refusal(earth, {.aerosol_optical_depth = -1}), "aerosol_optical_depth = -1: expected 0 .. 100");
  EXPECT_EQ(refusal(earth, {.angstrom = NAN}), "angstrom = nan: expected -2 .. 5");
  EXPECT_EQ(refusal(earth, {.ozone = 1e9}), "ozone = 1e+09: expected 0 .. 10000 Dobson units");
  EXPECT_EQ(
      refusal(mars, {.ozone = 300}),
      "ozone: atmosphere mars-clear has no constituent \"ozone\" to change; it has carbon dioxide, dust, dust-forward");
}

TEST(WavelengthRange, is_common_to_all_spectra) {
  Atmosphere earth = built_in_atmosphere("earth");
  earth.planet.albedo = Spectrum(TableSpectrum{{400, 700}, {0.1, 0.2}, Sampling::point, ""});
  EXPECT_EQ(wavelength_range(earth).first, 400);
  EXPECT_EQ(wavelength_range(earth).last, 700);
}

}  // namespace
}  // namespace airlight
