// What can be asked of, and changed in, a whole atmosphere.
#include "airlight/atmosphere.h"

#include <algorithm>

#include "airlight/error.h"
#include "optics/coefficients.h"
#include "optics/number_text.h"
#include "optics/validate.h"

namespace airlight {
namespace {

constexpr double aerosol_wavelength = 550;  // where optical depths of aerosols are stated [nm]

Constituent& constituent_named(Atmosphere& atmosphere, const std::string& name, const std::string& key) {
  std::string names;
  for (Constituent& constituent : atmosphere.constituents) {
    if (constituent.name == name) return constituent;
    names += (names.empty() ? "" : ", ") + constituent.name;
  }
  throw InputError(key + ": atmosphere " + atmosphere.name + " has no constituent \"" + name + "\" to change; it has " +
                   (names.empty() ? "none" : names));
}

void require(double value, const std::string& key, Limits limits) {
  if (value >= limits.low && value <= limits.high) return;
  throw InputError(key + " = " + number_text(value) + ": expected " + number_text(limits.low) + " .. " +
                   number_text(limits.high) + (*limits.unit ? std::string(" ") + limits.unit : ""));
}

/// The same value at 550 nm, another Ångström exponent; none where the spectrum is no Ångström law.
std::optional<Spectrum> with_angstrom(const Spectrum& spectrum, double angstrom) {
  const auto& law = spectrum.law();
  if (std::holds_alternative<ConstantSpectrum>(law) || std::holds_alternative<PowerSpectrum>(law)) {
    const double value = spectrum.at(aerosol_wavelength);
    return value == 0 ? spectrum : Spectrum(PowerSpectrum{aerosol_wavelength, value, -angstrom});
  }
  if (const auto* product = std::get_if<ProductSpectrum>(&law); product && !product->factors.empty()) {
    const auto extinction = with_angstrom(product->factors[0], angstrom);  // as split_extinction() makes it
    if (!extinction) return std::nullopt;
    ProductSpectrum changed = *product;
    changed.factors[0] = *extinction;
    return Spectrum(changed).scaled(spectrum.factor());
  }
  return std::nullopt;
}

void set_angstrom(Atmosphere& atmosphere, double angstrom) {
  require(angstrom, "angstrom", {-2, 5});
  Constituent& aerosol = constituent_named(atmosphere, "aerosol", "angstrom");
  const auto scattering = with_angstrom(aerosol.scattering, angstrom);
  const auto absorption = with_angstrom(aerosol.absorption, angstrom);
  if (!scattering || !absorption) {
    throw InputError("angstrom: the aerosol of atmosphere " + atmosphere.name + " is tabulated, not an Ångström law");
  }
  aerosol.scattering = *scattering;
  aerosol.absorption = *absorption;
}

void set_aerosol_optical_depth(Atmosphere& atmosphere, double optical_depth) {
  require(optical_depth, "aerosol_optical_depth", {0, 100});
  Constituent& aerosol = constituent_named(atmosphere, "aerosol", "aerosol_optical_depth");
  const double extinction = aerosol.scattering.at(aerosol_wavelength) + aerosol.absorption.at(aerosol_wavelength);
  const double present = extinction * path_length(aerosol.profile, atmosphere.planet.top_altitude);
  if (!(present > 0)) {
    throw InputError("aerosol_optical_depth: the aerosol of atmosphere " + atmosphere.name +
                     " has no extinction at 550 nm that could be scaled");
  }
  aerosol.scattering = aerosol.scattering.scaled(optical_depth / present);
  aerosol.absorption = aerosol.absorption.scaled(optical_depth / present);
}

void set_ozone(Atmosphere& atmosphere, double dobson) {
  require(dobson, "ozone", {0, 10'000, "Dobson units"});
  Constituent& ozone = constituent_named(atmosphere, "ozone", "ozone");
  const auto* column = std::get_if<ColumnSpectrum>(&ozone.absorption.law());
  if (!column) {
    throw InputError(
        "ozone: the ozone of atmosphere " + atmosphere.name +
        " is not given as a column: absorption = { type = \"column\", dobson = ..., cross_section = ... }");
  }
  ColumnSpectrum changed = *column;
  changed.dobson = dobson;
  ozone.absorption = Spectrum(changed);
}

}  // namespace

Atmosphere with_overrides(Atmosphere atmosphere, const AirOverrides& overrides) {
  if (overrides.angstrom) set_angstrom(atmosphere, *overrides.angstrom);
  if (overrides.aerosol_optical_depth) set_aerosol_optical_depth(atmosphere, *overrides.aerosol_optical_depth);
  if (overrides.ozone) set_ozone(atmosphere, *overrides.ozone);
  return atmosphere;
}

void validate(const Atmosphere& atmosphere) {
  if (const auto problem = find_problem(atmosphere)) {
    throw InputError("atmosphere " + atmosphere.name + ": " + problem->message());
  }
}

Spectrum::Range wavelength_range(const Atmosphere& atmosphere) {
  Spectrum::Range range{200, 4000};  // sunlight; laws hold there
  const auto narrow = [&](const Spectrum& spectrum) {
    const auto own = spectrum.range();
    if (own) range = {std::max(range.first, own->first), std::min(range.last, own->last)};
  };
  narrow(atmosphere.planet.albedo);
  narrow(atmosphere.sun.irradiance);
  narrow(atmosphere.sun.limb_darkening);
  for (const Constituent& constituent : atmosphere.constituents) {
    narrow(constituent.scattering);
    narrow(constituent.absorption);
  }
  return range;
}

}  // namespace airlight
