#include "optics/validate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "optics/coefficients.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

// Inside this file a problem is thrown, which ends the search; it never leaves it.
template <typename Search>
std::optional<Problem> first_problem(Search&& search) {
  try {
    search();
  } catch (Problem& problem) {
    return std::move(problem);
  }
  return std::nullopt;
}

std::string item(const std::string& key, std::size_t i) { return key + "[" + std::to_string(i) + "]"; }

void require(double value, const std::string& key, Limits limits, const std::string& where = "") {
  if (value >= limits.low && value <= limits.high) return;  // false for NaN
  const std::string unit = *limits.unit ? std::string(" ") + limits.unit : "";
  throw Problem{key, where + " = " + number_text(value) + ": expected " + number_text(limits.low) + " .. " +
                         number_text(limits.high) + unit};
}

void require_increasing(const std::vector<double>& values, const std::string& key, Limits limits) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(values[i], item(key, i), limits);
    if (i > 0 && values[i] <= values[i - 1]) {
      throw Problem{item(key, i), " = " + number_text(values[i]) + " after " + number_text(values[i - 1]) +
                                      ": expected strictly increasing values"};
    }
  }
}

void require_equal_sizes(std::size_t size, std::size_t expected, const std::string& key, const char* other) {
  if (size == expected) return;
  throw Problem{
      key, ": " + std::to_string(size) + " values: expected " + std::to_string(expected) + ", as many as " + other};
}

void require_size(std::size_t size, const std::string& key, std::size_t least, std::size_t most = 100'000) {
  if (size >= least && size <= most) return;
  throw Problem{
      key, ": " + std::to_string(size) + " values: expected " + std::to_string(least) + " .. " + std::to_string(most)};
}

// ---- spectra ----

constexpr Limits wavelength_limits{1, 1e6, "nm"};
constexpr Limits scale_limits{0, 1e60};
constexpr Spectrum::Range visible{360, 830};

void check(const Spectrum& spectrum, const std::string& key, Limits limits, Spectrum::Range window);

void check_shape(const ConstantSpectrum&, const std::string&, Spectrum::Range) {}
void check_shape(const HestrofferMagnanSpectrum&, const std::string&, Spectrum::Range) {}

void check_shape(const TableSpectrum& table, const std::string& key, Spectrum::Range) {
  const std::string wavelengths = key + ".wavelengths";
  require_size(table.wavelengths.size(), wavelengths, table.sampling == Sampling::bins ? 2 : 1);
  require_increasing(table.wavelengths, wavelengths, wavelength_limits);
  require_equal_sizes(table.values.size(), table.wavelengths.size(), key + ".values", "wavelengths");
  if (table.sampling != Sampling::bins) return;
  const double step = table.wavelengths[1] - table.wavelengths[0];
  for (std::size_t i = 1; i < table.wavelengths.size(); ++i) {
    const double here = table.wavelengths[i] - table.wavelengths[i - 1];
    if (std::abs(here - step) <= 1e-6 * step) continue;
    throw Problem{item(wavelengths, i), " = " + number_text(table.wavelengths[i]) + ": expected " +
                                            number_text(table.wavelengths[i - 1] + step) +
                                            " nm, for bins are evenly spaced (or sampling = \"point\")"};
  }
}

void check_shape(const PowerSpectrum& law, const std::string& key, Spectrum::Range) {
  require(law.at, key + ".at", wavelength_limits);
  require(law.exponent, key + ".exponent", {-20, 20});
  require(law.value, key + ".value", scale_limits);
}

void check_shape(const RayleighAirSpectrum& law, const std::string& key, Spectrum::Range) {
  require(law.number_density, key + ".number_density", {0, 1e30, "1/m^3"});
}

void check_shape(const ProductSpectrum& law, const std::string& key, Spectrum::Range window) {
  require_size(law.factors.size(), key + ".factors", 0, 16);
  require_size(law.complements.size(), key + ".complements", 0, 16);
  for (std::size_t i = 0; i < law.factors.size(); ++i) {
    check(law.factors[i], item(key + ".factors", i), scale_limits, window);
  }
  for (std::size_t i = 0; i < law.complements.size(); ++i) {
    check(law.complements[i], item(key + ".complements", i), albedo_limits, window);
  }
}

void check_shape(const ColumnSpectrum& law, const std::string& key, Spectrum::Range window) {
  require(law.dobson, key + ".dobson", {0, 1e12, "Dobson units"});
  require(law.path_length, key + ".path_length", {1e-30, 1e60, "m"});
  require_size(law.cross_section.size(), key + ".cross_section", 1, 1);
  check(law.cross_section[0], key + ".cross_section", cross_section_limits, window);
}

void check(const Spectrum& spectrum, const std::string& key, Limits limits, Spectrum::Range window) {
  require(spectrum.factor(), key + ".scale", scale_limits);
  std::visit([&](const auto& law) { check_shape(law, key, window); }, spectrum.law());
  if (const auto* table = std::get_if<TableSpectrum>(&spectrum.law())) {
    for (std::size_t i = 0; i < table->values.size(); ++i) {
      require(table->values[i] * spectrum.factor(), item(key + ".values", i), limits);
    }
    return;
  }
  if (const auto* constant = std::get_if<ConstantSpectrum>(&spectrum.law())) {
    return require(constant->value * spectrum.factor(), key, limits);
  }
  constexpr int samples = 33;
  for (int i = 0; i < samples; ++i) {
    const double wavelength = std::lerp(window.first, window.last, i / double(samples - 1));
    require(spectrum.at(wavelength), key, limits, " at " + number_text(wavelength) + " nm");
  }
}

void check(const Spectrum& spectrum, const std::string& key, Limits limits) {
  check(spectrum, key, limits, spectrum.range().value_or(visible));
}

// ---- profiles ----

constexpr Limits altitude_limits{0, 1e9, "m"};
constexpr Limits density_limits{0, 1e30};

void check(const ExponentialProfile& profile, const std::string& key) {
  require(profile.scale_height, key + ".scale_height", {1, 1e8, "m"});
}

void check(const TentProfile& profile, const std::string& key) {
  require(profile.altitude, key + ".altitude", altitude_limits);
  require(profile.half_width, key + ".half_width", {1, 1e9, "m"});
}

void check(const LayersProfile& profile, const std::string& key) {
  require_size(profile.layers.size(), key + ".layers", 1, 1000);
  double below = 0;
  for (std::size_t i = 0; i < profile.layers.size(); ++i) {
    const LayersProfile::Layer& layer = profile.layers[i];
    const std::string place = item(key + ".layers", i);
    require(layer.bottom, place + ".bottom", altitude_limits);
    require(layer.top, place + ".top", altitude_limits);
    require(layer.density, place + ".density", density_limits);
    if (layer.bottom < below) {
      throw Problem{place + ".bottom", " = " + number_text(layer.bottom) + ": expected at least " + number_text(below) +
                                           " m, the top of the layer below"};
    }
    if (layer.top <= layer.bottom) {
      throw Problem{place + ".top", " = " + number_text(layer.top) + ": expected more than the layer's bottom, " +
                                        number_text(layer.bottom) + " m"};
    }
    below = layer.top;
  }
}

void check(const TableProfile& profile, const std::string& key) {
  require_size(profile.altitudes.size(), key + ".altitudes", 2, 10'000);
  require_increasing(profile.altitudes, key + ".altitudes", altitude_limits);
  require_equal_sizes(profile.densities.size(), profile.altitudes.size(), key + ".densities", "altitudes");
  for (std::size_t i = 0; i < profile.densities.size(); ++i) {
    require(profile.densities[i], item(key + ".densities", i), density_limits);
  }
}

void check(const StandardAtmosphereProfile&, const std::string&) {}

/// Highest relative density below the planet's top.
double densest(const Profile& profile, double top) {
  double highest = density(profile, 0);
  double below = 0;
  std::vector<double> edges = kinks(profile, top);
  edges.push_back(top);
  for (const double edge : edges) {  // at an edge two values may meet: look on both sides of it
    for (const double altitude : {std::lerp(below, edge, 1e-9), std::lerp(below, edge, 1 - 1e-9), edge}) {
      highest = std::max(highest, density(profile, altitude));
    }
    below = edge;
  }
  return highest;
}

// ---- phase functions ----

// A Henyey-Greenstein peak beyond this is narrower than the sun's disc and than the tables that hold it.
constexpr Limits asymmetry_limits{-0.99, 0.99};

void check(const RayleighPhase& phase, const std::string& key) {
  require(phase.depolarisation, key + ".depolarisation", {0, 1});
}
void check(const IsotropicPhase&, const std::string&) {}
void check(const HenyeyGreensteinPhase& phase, const std::string& key) {
  require(phase.g, key + ".g", asymmetry_limits);
}
void check(const CornetteShanksPhase& phase, const std::string& key) { require(phase.g, key + ".g", asymmetry_limits); }
void check(const DoubleHenyeyGreensteinPhase& phase, const std::string& key) {
  require(phase.g1, key + ".g1", asymmetry_limits);
  require(phase.g2, key + ".g2", asymmetry_limits);
  require(phase.weight, key + ".weight", {0, 1});
}

void check(const TablePhase& phase, const std::string& key) {
  constexpr double pi = std::numbers::pi;
  require_size(phase.angles.size(), key + ".angles", 2);
  require_increasing(phase.angles, key + ".angles", {0, 3.15, "rad"});
  require(phase.angles.front(), item(key + ".angles", 0), {0, 0, "rad"});
  // 3.1416 is welcome, 180 is not.
  require(phase.angles.back(), item(key + ".angles", phase.angles.size() - 1), {pi - 1e-4, pi + 1e-4, "rad (pi)"});
  require_equal_sizes(phase.values.size(), phase.angles.size(), key + ".values", "angles");
  for (std::size_t i = 0; i < phase.values.size(); ++i) {
    require(phase.values[i], item(key + ".values", i), {0, 1e9, "1/sr"});
  }
  require(sphere_integral(phase), key + ".values", {0.999, 1.001}, ": integral over the sphere");
}

// ---- the parts of an atmosphere ----

void check(const Planet& planet) {
  require(planet.ground_radius, "planet.ground_radius", {1000, 1e9, "m"});
  require(planet.top_altitude, "planet.top_altitude", {1, 1e9, "m above the ground"});
  check(planet.albedo, "planet.albedo", albedo_limits);
}

void check(const Sun& sun) {
  check(sun.irradiance, "sun.irradiance", irradiance_limits);
  require(sun.angular_radius, "sun.angular_radius", {1e-6, 1.5, "rad"});
  check(sun.limb_darkening, "sun.limb_darkening", limb_darkening_limits);
}

void check(const Profile& profile, const std::string& key) {
  std::visit([&](const auto& shape) { check(shape, key); }, profile);
}
void check(const Phase& phase, const std::string& key) {
  std::visit([&](const auto& shape) { check(shape, key); }, phase);
}

void check(const Constituent& constituent, const std::string& key) {
  if (constituent.name.empty()) throw Problem{key + ".name", ": expected a name that is not empty"};
  check(constituent.profile, key + ".profile");
  check(constituent.scattering, key + ".scattering", coefficient_limits);
  check(constituent.absorption, key + ".absorption", coefficient_limits);
  check(constituent.phase, key + ".phase");
}

// A column keeps the path length that it was made with; whoever changes the profile or the top must make it anew.
void check_column(const Constituent& constituent, const std::string& key, double top) {
  const auto* column = std::get_if<ColumnSpectrum>(&constituent.absorption.law());
  if (!column) return;
  const double expected = path_length(constituent.profile, top);
  if (std::abs(column->path_length - expected) <= 1e-9 * expected) return;
  throw Problem{key + ".absorption.path_length", " = " + number_text(column->path_length) + ": expected " +
                                                     number_text(expected) + " m, the integral of its profile"};
}

}  // namespace

std::optional<Problem> find_problem(const Spectrum& spectrum, const std::string& key, Limits limits) {
  return first_problem([&] { check(spectrum, key, limits); });
}
std::optional<Problem> find_problem(const Planet& planet) {
  return first_problem([&] { check(planet); });
}
std::optional<Problem> find_problem(const Sun& sun) {
  return first_problem([&] { check(sun); });
}
std::optional<Problem> find_problem(const Profile& profile, const std::string& key) {
  return first_problem([&] { check(profile, key); });
}
std::optional<Problem> find_problem(const Phase& phase, const std::string& key) {
  return first_problem([&] { check(phase, key); });
}
std::optional<Problem> find_problem(const Constituent& constituent, const std::string& key) {
  return first_problem([&] { check(constituent, key); });
}

std::optional<Problem> find_problem(const Atmosphere& atmosphere) {
  return first_problem([&] {
    check(atmosphere.planet);
    check(atmosphere.sun);
    std::set<std::string> names;
    for (std::size_t i = 0; i < atmosphere.constituents.size(); ++i) {
      const Constituent& constituent = atmosphere.constituents[i];
      check(constituent, item("constituent", i));
      check_column(constituent, item("constituent", i), atmosphere.planet.top_altitude);
      if (!names.insert(constituent.name).second) {
        throw Problem{item("constituent", i) + ".name",
                      " = \"" + constituent.name + "\": expected a name not yet used"};
      }
    }

    const Spectrum::Range range = wavelength_range(atmosphere);
    if (!(range.first <= range.last)) {
      throw Problem{"atmosphere", ": no wavelength lies inside the data of every spectrum: one begins at " +
                                      number_text(range.first) + " nm, another ends at " + number_text(range.last) +
                                      " nm"};
    }
    check(atmosphere.planet.albedo, "planet.albedo", albedo_limits, range);
    check(atmosphere.sun.irradiance, "sun.irradiance", irradiance_limits, range);
    check(atmosphere.sun.limb_darkening, "sun.limb_darkening", limb_darkening_limits, range);
    for (std::size_t i = 0; i < atmosphere.constituents.size(); ++i) {
      // What counts is the coefficient where the air is densest: tables may hold anything relative.
      const Constituent& constituent = atmosphere.constituents[i];
      const double highest = densest(constituent.profile, atmosphere.planet.top_altitude);
      check(constituent.scattering.scaled(highest), item("constituent", i) + ".scattering", coefficient_limits, range);
      check(constituent.absorption.scaled(highest), item("constituent", i) + ".absorption", coefficient_limits, range);
    }
  });
}

double sphere_integral(const TablePhase& table) {
  // Linear p on each piece: p sin integrates to [-p cos] + slope * [sin].
  double sum = 0;
  for (std::size_t i = 1; i < table.angles.size(); ++i) {
    const double a = table.angles[i - 1], b = table.angles[i],
                 slope = (table.values[i] - table.values[i - 1]) / (b - a);
    sum += table.values[i - 1] * std::cos(a) - table.values[i] * std::cos(b) + slope * (std::sin(b) - std::sin(a));
  }
  return 2 * std::numbers::pi * sum;
}

}  // namespace airlight
