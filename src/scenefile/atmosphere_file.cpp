#include "scenefile/atmosphere_file.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/coefficients.h"
#include "optics/validate.h"
#include "scenefile/air_toml.h"
#include "scenefile/spectrum_toml.h"
#include "scenefile/text_file.h"
#include "scenefile/toml_document.h"
#include "scenefile/toml_text.h"

namespace airlight {
namespace {

void refuse(const TableReader& reader, const std::optional<Problem>& problem) {
  if (problem) reader.fail_at(problem->key, problem->what);
}

// ---- reading: values that a base has may be left out ----

void read_planet(TableReader reader, bool has_base, Planet& planet) {
  const auto number = [&](const char* key, double& value) {
    value = has_base ? reader.number(key, value) : reader.number(key);
  };
  number("ground_radius", planet.ground_radius);
  number("top_altitude", planet.top_altitude);
  if (reader.has("albedo")) planet.albedo = read_spectrum(reader, "albedo", albedo_limits);
  reader.finish();
  refuse(reader, find_problem(planet));
}

void read_sun(TableReader reader, bool has_base, Sun& sun) {
  if (!has_base || reader.has("irradiance")) sun.irradiance = read_spectrum(reader, "irradiance", irradiance_limits);
  sun.angular_radius = reader.number("angular_radius", sun.angular_radius);
  if (reader.has("limb_darkening")) {
    sun.limb_darkening = read_spectrum(reader, "limb_darkening", limb_darkening_limits);
  }
  reader.finish();
  refuse(reader, find_problem(sun));
}

void read_coefficients(TableReader& reader, double path_length, Constituent& constituent) {
  const bool extinction = reader.has("extinction"), albedo = reader.has("single_scattering_albedo");
  const bool scattering = reader.has("scattering"), absorption = reader.has("absorption");
  if (extinction != albedo || extinction == (scattering || absorption)) {
    reader.fail("", ": expected either extinction and single_scattering_albedo, or scattering or absorption or both");
  }
  if (extinction) {
    const auto split = split_extinction(read_spectrum(reader, "extinction", coefficient_limits),
                                        read_spectrum(reader, "single_scattering_albedo", albedo_limits));
    constituent.scattering = split.scattering;
    constituent.absorption = split.absorption;
  }
  if (scattering) constituent.scattering = read_spectrum(reader, "scattering", coefficient_limits);
  if (absorption) constituent.absorption = read_spectrum(reader, "absorption", coefficient_limits, path_length);
}

Constituent read_constituent(TableReader& reader, double top) {
  Constituent constituent;
  constituent.name = reader.text("name");
  TableReader profile = reader.table("profile");
  constituent.profile = read_profile(profile);
  read_coefficients(reader, path_length(constituent.profile, top), constituent);
  if (reader.has("phase")) {
    TableReader phase = reader.table("phase");
    constituent.phase = read_phase(phase);
  } else if (constituent.scattering != Spectrum(0.0)) {
    reader.fail("phase", " is missing: what scatters has a phase function");
  } else {
    constituent.phase = IsotropicPhase{};
  }
  reader.finish();
  refuse(reader, find_problem(constituent, reader.path()));
  return constituent;
}

/// One of the same name takes its place.
void put(std::vector<Constituent>& constituents, Constituent constituent) {
  const auto place = std::find_if(constituents.begin(), constituents.end(),
                                  [&](const Constituent& present) { return present.name == constituent.name; });
  if (place == constituents.end()) {
    constituents.push_back(std::move(constituent));
  } else {
    *place = std::move(constituent);
  }
}

void read_constituents(TableReader& root, Atmosphere& atmosphere) {
  if (!root.has("constituent")) return;
  std::vector<std::string> names;
  for (TableReader& reader : root.tables("constituent")) {
    Constituent constituent = read_constituent(reader, atmosphere.planet.top_altitude);
    if (std::find(names.begin(), names.end(), constituent.name) != names.end()) {
      reader.fail("name", " = " + toml_text(constituent.name) + ": expected a name not yet used");
    }
    names.push_back(constituent.name);
    put(atmosphere.constituents, std::move(constituent));
  }
}

/// The base's columns, spread anew up to another top.
void respread_columns(Atmosphere& atmosphere) {
  for (Constituent& constituent : atmosphere.constituents) {
    if (const auto* column = std::get_if<ColumnSpectrum>(&constituent.absorption.law())) {
      constituent.absorption = column_absorption(column->dobson, column->cross_section.at(0), constituent.profile,
                                                 atmosphere.planet.top_altitude)
                                   .scaled(constituent.absorption.factor());
    }
  }
}

void read_overrides(TableReader& root, Atmosphere& atmosphere) {
  const auto apply = [&](const char* key, std::optional<double> AirOverrides::*member) {
    if (!root.has(key)) return;
    AirOverrides overrides;
    overrides.*member = root.number(key);
    try {
      atmosphere = with_overrides(std::move(atmosphere), overrides);
    } catch (const InputError& error) {
      root.fail_message(key, error.what());
    }
  };
  apply("angstrom", &AirOverrides::angstrom);
  apply("aerosol_optical_depth", &AirOverrides::aerosol_optical_depth);
  apply("ozone", &AirOverrides::ozone);
}

Atmosphere read_base(TableReader& root) {
  const std::string name = root.text("base");
  const auto names = built_in_atmospheres();
  if (std::find(names.begin(), names.end(), name) != names.end()) return built_in_atmosphere(name);
  root.fail("base", " = " + toml_text(name) + ": unknown atmosphere" + did_you_mean(name, names));
}

}  // namespace

Atmosphere parse_atmosphere(std::string_view text, const std::string& name) {
  const toml::table document = parse_toml(text, name);
  TableReader root(document, name);
  const bool has_base = root.has("base");
  Atmosphere atmosphere = has_base ? read_base(root) : Atmosphere{};
  atmosphere.name = root.has("name") ? root.text("name") : std::filesystem::path(name).stem().string();
  if (!has_base || root.has("planet")) read_planet(root.table("planet"), has_base, atmosphere.planet);
  if (has_base) respread_columns(atmosphere);
  if (!has_base || root.has("sun")) read_sun(root.table("sun"), has_base, atmosphere.sun);
  read_constituents(root, atmosphere);
  read_overrides(root, atmosphere);
  root.finish();
  refuse(root, find_problem(atmosphere));
  return atmosphere;
}

Atmosphere load_atmosphere(const std::string& name_or_path) {
  if (!name_or_path.ends_with(".toml")) return built_in_atmosphere(name_or_path);
  const auto text = read_text_file(name_or_path);
  if (!text) throw InputError(name_or_path + ": no such file");
  return parse_atmosphere(*text, name_or_path);
}

std::string to_toml(const Atmosphere& atmosphere) {
  const Planet& planet = atmosphere.planet;
  const Sun& sun = atmosphere.sun;
  std::string text = "name = " + toml_text(atmosphere.name) + "\n";
  text += "\n[planet]\n";
  text += "ground_radius = " + toml_text(planet.ground_radius) + "  # m\n";
  text += "top_altitude = " + toml_text(planet.top_altitude) + "  # m\n";
  text += "albedo = " + spectrum_toml(planet.albedo) + "\n";
  text += "\n[sun]\n";
  text += "irradiance = " + spectrum_toml(sun.irradiance) + "  # W/m^2/nm\n";
  text += "angular_radius = " + toml_text(sun.angular_radius) + "  # rad\n";
  text += "limb_darkening = " + spectrum_toml(sun.limb_darkening) + "\n";
  for (const Constituent& constituent : atmosphere.constituents) {
    text += "\n[[constituent]]\n";
    text += "name = " + toml_text(constituent.name) + "\n";
    text += "profile = " + profile_toml(constituent.profile) + "\n";
    text += "scattering = " + spectrum_toml(constituent.scattering) + "  # 1/m\n";
    text += "absorption = " + spectrum_toml(constituent.absorption) + "  # 1/m\n";
    text += "phase = " + phase_toml(constituent.phase) + "\n";
  }
  return text;
}

}  // namespace airlight
