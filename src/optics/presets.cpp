// The atmospheres that are built in. Every constant has its source beside it.
#include <array>
#include <cmath>

#include "airlight/atmosphere.h"
#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/coefficients.h"
#include "optics/rayleigh_air.h"

namespace airlight {
namespace {

Spectrum shipped(const std::string& file, Sampling sampling) {
  return Spectrum(shipped_spectrum(file, sampling).value());
}

// IAU 2015 resolution B3: nominal solar radius 695 700 km; 1 astronomical unit = 149 597 870.7 km.
constexpr double sun_angular_radius = 695'700.0 / 149'597'870.7;

Sun sun_at(double astronomical_units) {
  return {shipped("solar_irradiance.csv", Sampling::bins).scaled(1 / (astronomical_units * astronomical_units)),
          sun_angular_radius / astronomical_units, Spectrum(HestrofferMagnanSpectrum{})};
}

// ---- Earth ----

constexpr double earth_top = 120'000;  // the air above holds 2e-7 of the column

// The optical depth at 550 nm is over the column up to the top; one scale height, so the law is the coefficient's.
Constituent continental_aerosol(double optical_depth) {
  // At 550 nm, single-scattering albedo 0.95 and asymmetry 0.7 lie between and at OPAC's clean (0.97, 0.71) and average
  // (0.93, 0.70) continental aerosols (Hess, Koepke & Schult 1998, Bull. Amer. Meteor. Soc. 79, 831); Ångström's own
  // mean exponent was 1.3 (1929, Geogr. Ann. 11, 156); a scale height of 1.5 km lies between Elterman's 1.2 km (1968)
  // and OPAC's well-mixed layer of 2 km.
  const Profile profile = ExponentialProfile{1500};
  const double extinction = optical_depth / path_length(profile, earth_top);
  const auto [scattering, absorption] = split_extinction(Spectrum(PowerSpectrum{550, extinction, -1.3}), 0.95);
  return {"aerosol", profile, scattering, absorption, HenyeyGreensteinPhase{0.7}};
}

Constituent ozone_layer(double dobson) {
  // Mid-latitude ozone model of the US Standard Atmosphere 1976 (Krueger & Minzner 1976, J. Geophys. Res. 81, 4477):
  // number density [1e18 / m^3] every 2 km from 2 km. Its own column, 345 Dobson units, is scaled to the one asked for.
  // Up to 50 km the US standard profile of Anderson et al. 1986 (AFGL-TR-86-0110) is the same within 2 % (tested).
  constexpr std::array<double, 37> table{
      0.68,   0.58,   0.57,   0.65,    1.13,    2.02,    2.35,    2.95,    4.04,    4.77,    4.86,   4.54,   4.03,
      3.24,   2.52,   2.03,   1.58,    1.22,    0.873,   0.607,   0.398,   0.274,   0.169,   0.103,  0.0664, 0.0384,
      0.0255, 0.0161, 0.0112, 0.00733, 0.00481, 0.00317, 0.00172, 0.00075, 0.00054, 0.00022, 0.00017};
  TableProfile profile;
  for (std::size_t i = 0; i < table.size(); ++i) {
    profile.altitudes.push_back(2000.0 * double(i + 1));
    profile.densities.push_back(table[i]);
  }
  const Spectrum cross_section = shipped("ozone_cross_section_233K.csv", Sampling::bins);
  return {"ozone", profile, 0.0, column_absorption(dobson, cross_section, profile, earth_top), IsotropicPhase{}};
}

Atmosphere earth_with_aerosol(const char* name, double optical_depth) {
  Atmosphere earth;
  earth.name = name;
  // Mean radius (2 a + b) / 3 of the ellipsoid, 6 371 009 m, as commonly rounded: distances to the horizon and the
  // Earth's shadow follow the mean curvature. Albedo 0.1: snow-free land in visible light lies between 0.04 (forest)
  // and 0.2 (desert); plants, which reflect most in the infrared, keep the mean near 0.1.
  earth.planet = {6'371'000, earth_top, 0.1};
  earth.sun = sun_at(1);
  // Natural light is depolarised as the King factor says, and no more than that: the two are one quantity.
  const double depolarisation = depolarisation_from_king_factor(king_factor_of_air(550));
  earth.constituents = {
      {"molecules", StandardAtmosphereProfile{}, Spectrum(RayleighAirSpectrum{}), 0.0, RayleighPhase{depolarisation}},
      continental_aerosol(optical_depth),
      ozone_layer(300)};
  return earth;
}

// Bruneton 2017's demonstration, precomputed_atmospheric_scattering/demo/demo.cc: his constants, and his spectra, which
// are linear between values taken at their wavelengths.
Atmosphere earth_bruneton() {
  Atmosphere earth;
  earth.name = "earth-bruneton";
  earth.planet = {6'360'000, 60'000, 0.1};
  earth.sun = {shipped("solar_irradiance.csv", Sampling::point), 0.004675, 0.0};
  const auto [scattering, absorption] = split_extinction(Spectrum(PowerSpectrum{550, 4.44e-6, 0}), 0.9);
  const Profile tent = TentProfile{25'000, 15'000};
  const Spectrum cross_section = shipped("ozone_cross_section_233K.csv", Sampling::point);
  earth.constituents = {
      {"molecules", ExponentialProfile{8000}, Spectrum(PowerSpectrum{1000, 1.24062e-6, -4}), 0.0, RayleighPhase{}},
      {"aerosol", ExponentialProfile{1200}, scattering, absorption, CornetteShanksPhase{0.8}},
      {"ozone", tent, 0.0, column_absorption(300, cross_section, tent, earth.planet.top_altitude), IsotropicPhase{}}};
  return earth;
}

// ---- Mars ----

Atmosphere mars_clear() {
  Atmosphere mars;
  mars.name = "mars-clear";
  // Mean radius, scale height, gravity and mean molecular weight: NASA Mars Fact Sheet. It gives 636 Pa at the mean
  // radius, 400 to 870 Pa over the year; 610 Pa is what dust optical depths are normalised to (see below).
  constexpr double pressure = 610, scale_height = 11'100, gravity = 3.73, molecule = 43.34 * 1.66053906660e-27;
  // The ground takes Mars' geometric albedos in U, B, V, R and I (Mallama, Krobusek & Pavlov 2017, Icarus 282, 19,
  // rounded; V is 0.170 in the Fact Sheet too, a second source for the others was not found): that is the colour of the
  // mean surface; a Lambertian ground of that albedo is within the spread of dark and bright land.
  mars.planet = {
      3'389'500, 120'000,
      Spectrum(TableSpectrum{{360, 436, 549, 700, 900}, {0.06, 0.09, 0.17, 0.25, 0.29}, Sampling::point, ""})};
  mars.sun = sun_at(1.524);  // semi-major axis

  // Dust is mixed with the gas; its scale height was found to be 6 to 12 km, by season (Vincendon & Langevin 2010,
  // Icarus 207, 923).
  const Profile mixed = ExponentialProfile{scale_height};
  // Carbon dioxide: a power law through Sneep & Ubachs 2005 (J. Quant. Spectrosc. Radiat. Transf. 92, 293; refractive
  // index of Bideau-Mehu 1973, King factor of Alms 1975), good to 1.4 % from 360 to 830 nm; a hundredth of the dust's
  // effect.
  const double number_density = pressure / (molecule * gravity * scale_height);  // hydrostatic: the column is P / (m g)
  const Spectrum gas(PowerSpectrum{550, number_density * 1.171e-30, -4.115});
  constexpr double carbon_dioxide_king_factor = 1.1448;  // at 550 nm

  // Dust, optical depth 0.3: the clear season. In years without a global storm the planet's mean at 610 Pa is 0.38, its
  // least 0.2 (climatology of the Mars Climate Database after Montabone et al. 2015, Icarus 251, 65: absorption at
  // 9.3 um, times their 2.6 for visible light). Extinction by particles of 1.5 um hardly changes with wavelength: by 3
  // % from 600 to 880 nm.
  const double extinction = 0.3 / path_length(mixed, mars.planet.top_altitude);
  // Iron oxides absorb blue: this makes the sky butterscotch. Wolff et al. 2009 (J. Geophys. Res. 114, E00D04) as the
  // LMD Mars climate model tabulates them for 1.5 um: 0.73 at 388 nm, 0.967 at 650 nm, 0.975 at 700 nm; below,
  // Ockert-Bell et al. 1997 (J. Geophys. Res. 102, 9039) as the NASA Ames climate model weighs them with a Planck
  // spectrum of 6000 K: 1.623 / 2.622 over 240 to 400 nm, where no wavelength of ours but 360 to 388 nm lies.
  const Spectrum albedo(
      TableSpectrum{{320, 388, 650, 700, 1050}, {0.619, 0.73, 0.967, 0.975, 0.975}, Sampling::point, ""});
  // The sky of Gale crater at 650 nm is a sum of two lobes, g = 0.889 (share 0.743) and g = 0.094 (Chen-Chen,
  // Pérez-Hoyos & Sánchez-Lavega 2019, Icarus 330, 16: fits of 10 to 150 degrees; g to 0.1 and 0.25, share to 0.1).
  // Shorter waves are diffracted less: asymmetry is 0.856 over 240 to 400 nm, 0.700 over 400 to 800 nm and 0.634 over
  // 800 to 1310 nm (Ockert-Bell et al. 1997, weighed as above). The lobes keep their shape and the forward one's share
  // follows the asymmetry: this makes the sun's surroundings bluer than the rest of the sky.
  constexpr double forward_g = 0.889, wide_g = 0.094;
  const auto share = [&](double asymmetry) { return (asymmetry - wide_g) / (forward_g - wide_g); };
  const Spectrum forward(TableSpectrum{
      {320, 600, 650, 1050}, {share(0.856), share(0.700), share(0.685), share(0.634)}, Sampling::point, ""});
  mars.constituents = {
      {"carbon dioxide", mixed, gas, 0.0, RayleighPhase{depolarisation_from_king_factor(carbon_dioxide_king_factor)}},
      {"dust", mixed, Spectrum(ProductSpectrum{{extinction, albedo}, {forward}}),
       Spectrum(ProductSpectrum{{extinction}, {albedo}}), HenyeyGreensteinPhase{wide_g}},
      {"dust-forward", mixed, Spectrum(ProductSpectrum{{extinction, albedo, forward}, {}}), 0.0,
       HenyeyGreensteinPhase{forward_g}}};
  return mars;
}

struct Preset {
  std::string_view name, description;
  Atmosphere (*make)();
};

constexpr std::array<Preset, 4> presets{{
    {"earth", "Earth, clear: US Standard Atmosphere 1976, 300 DU of ozone, continental aerosol of optical depth 0.1",
     [] { return earth_with_aerosol("earth", 0.1); }},
    {"earth-hazy", "Earth, hazy: as earth, with four times the aerosol (optical depth 0.4 at 550 nm)",
     [] { return earth_with_aerosol("earth-hazy", 0.4); }},
    {"earth-bruneton", "Earth as in the demonstration of Bruneton 2017, for comparisons", earth_bruneton},
    {"mars-clear", "Mars between dust storms: 610 Pa of carbon dioxide, dust of optical depth 0.3", mars_clear},
}};

const Preset& preset(std::string_view name) {
  for (const Preset& candidate : presets) {
    if (candidate.name == name) return candidate;
  }
  throw InputError("unknown atmosphere \"" + std::string(name) + "\"" + did_you_mean(name, built_in_atmospheres()));
}

}  // namespace

std::vector<std::string_view> built_in_atmospheres() {
  std::vector<std::string_view> names;
  for (const Preset& candidate : presets) names.push_back(candidate.name);
  return names;
}

std::string_view describe_atmosphere(std::string_view name) { return preset(name).description; }

Atmosphere built_in_atmosphere(std::string_view name) { return preset(name).make(); }

}  // namespace airlight
