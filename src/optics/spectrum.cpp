#include "airlight/spectrum.h"

#include <algorithm>
#include <cmath>

#include "airlight/atmosphere.h"
#include "optics/csv.h"
#include "optics/rayleigh_air.h"
#include "optics/shipped_data.h"

namespace airlight {
namespace {

double value_at(const ConstantSpectrum& law, double) { return law.value; }

double value_at(const TableSpectrum& table, double wavelength) {
  // A bin's mean belongs to its centre, half a step above the wavelength where it begins.
  const std::vector<double>& x = table.wavelengths;
  if (x.empty()) return 0;
  if (table.sampling == Sampling::bins && x.size() > 1) wavelength -= (x[1] - x[0]) / 2;
  const auto above = std::upper_bound(x.begin(), x.end(), wavelength);
  if (above == x.begin()) return table.values.front();
  if (above == x.end()) return table.values.back();
  const std::size_t i = std::size_t(above - x.begin());
  return std::lerp(table.values[i - 1], table.values[i], (wavelength - x[i - 1]) / (x[i] - x[i - 1]));
}

double value_at(const PowerSpectrum& law, double wavelength) {
  return law.value * std::pow(wavelength / law.at, law.exponent);
}

double value_at(const RayleighAirSpectrum& law, double wavelength) {
  return law.number_density * rayleigh_cross_section_of_air(wavelength);
}

// Hestroffer & Magnan 1998, Astron. Astrophys. 333, 338: fits to the measurements of Neckel & Labs 1994, 303 to 1099
// nm. Across the Balmer jump, where they give none, linear between the two fits' ends; constant beyond the
// measurements.
double value_at(const HestrofferMagnanSpectrum&, double wavelength) {
  const auto ultraviolet = [](double nm) { return -0.507 + 441 / nm; };
  const auto visible = [](double nm) { return -0.023 + 292 / nm; };
  constexpr double first = 303.327, gap_begins = 372.98, gap_ends = 416.97, last = 1098.95;
  wavelength = std::clamp(wavelength, first, last);
  if (wavelength <= gap_begins) return ultraviolet(wavelength);
  if (wavelength >= gap_ends) return visible(wavelength);
  return std::lerp(ultraviolet(gap_begins), visible(gap_ends), (wavelength - gap_begins) / (gap_ends - gap_begins));
}

double value_at(const ProductSpectrum& law, double wavelength) {
  double product = 1;
  for (const Spectrum& factor : law.factors) product *= factor.at(wavelength);
  for (const Spectrum& complement : law.complements) product *= 1 - complement.at(wavelength);
  return product;
}

double value_at(const ColumnSpectrum& law, double wavelength) {
  return law.cross_section.at(0).at(wavelength) * (law.dobson * dobson_unit / law.path_length);
}

using Range = std::optional<Spectrum::Range>;

Range common(Range a, Range b) {
  if (!a || !b) return a ? a : b;
  return Spectrum::Range{std::max(a->first, b->first), std::min(a->last, b->last)};
}

template <typename Law>
Range range_of(const Law&) {
  return std::nullopt;
}

Range range_of(const TableSpectrum& table) {
  if (table.wavelengths.empty()) return std::nullopt;
  return Spectrum::Range{table.wavelengths.front(), table.wavelengths.back()};
}

// Peck & Reeder's fit begins at 185 nm; towards the infrared it goes smoothly to its limit.
Range range_of(const RayleighAirSpectrum&) { return Spectrum::Range{200, 4000}; }

Range range_of(const ProductSpectrum& law) {
  Range range;
  for (const Spectrum& factor : law.factors) range = common(range, factor.range());
  for (const Spectrum& complement : law.complements) range = common(range, complement.range());
  return range;
}

Range range_of(const ColumnSpectrum& law) { return law.cross_section.at(0).range(); }

}  // namespace

// Written out: defaulted ones need Spectrum's own comparison, which needs these.
bool ProductSpectrum::operator==(const ProductSpectrum& other) const {
  return factors == other.factors && complements == other.complements;
}
bool ColumnSpectrum::operator==(const ColumnSpectrum& other) const {
  return dobson == other.dobson && path_length == other.path_length && cross_section == other.cross_section;
}

double Spectrum::at(double wavelength) const {
  return factor_ * std::visit([&](const auto& law) { return value_at(law, wavelength); }, law_);
}

std::optional<Spectrum::Range> Spectrum::range() const {
  return std::visit([](const auto& law) { return range_of(law); }, law_);
}

Spectrum Spectrum::scaled(double factor) const {
  if (const auto* constant = std::get_if<ConstantSpectrum>(&law_)) return Spectrum(constant->value * factor_ * factor);
  if (factor == 0) return Spectrum(0.0);
  Spectrum result = *this;
  result.factor_ *= factor;
  return result;
}

std::optional<TableSpectrum> shipped_spectrum(const std::string& file, Sampling sampling) {
  const std::string_view text = shipped_text(file);
  if (text.empty()) return std::nullopt;
  return parse_spectrum_csv(text, file, sampling);
}

}  // namespace airlight
