#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace airlight {

/// How a tabulated value belongs to its wavelength.
enum class Sampling {
  bins,   ///< the mean over the bin that begins at the stated wavelength; taken as the value at the bin's centre
  point,  ///< the value at the stated wavelength
};

struct ConstantSpectrum {
  double value = 0;
  bool operator==(const ConstantSpectrum&) const = default;
};
/// Linear between samples, held constant beyond the ends.
struct TableSpectrum {
  std::vector<double> wavelengths;  ///< [nm], strictly increasing, evenly spaced where sampling is `bins`
  std::vector<double> values;
  Sampling sampling = Sampling::bins;
  std::string file;  ///< where the table was read from; empty: given inline
  bool operator==(const TableSpectrum&) const = default;
};
/// value * (wavelength / at)^exponent; Ångström's law is exponent = -ångström exponent.
struct PowerSpectrum {
  double at = 550;  ///< [nm]
  double value = 0;
  double exponent = 0;
  bool operator==(const PowerSpectrum&) const = default;
};
/// Rayleigh scattering coefficient [1/m] of air from its refractive index and King factor at the given number density.
struct RayleighAirSpectrum {
  double number_density = 2.546899e25;  ///< [1/m^3]; 288.15 K, 1013.25 hPa
  bool operator==(const RayleighAirSpectrum&) const = default;
};
/// Exponent of the sun's limb darkening radiance(mu) = mu^exponent, after Hestroffer & Magnan 1998.
struct HestrofferMagnanSpectrum {
  bool operator==(const HestrofferMagnanSpectrum&) const = default;
};

class Spectrum;
/// Product of the factors and of (1 - each complement): how an extinction and a single-scattering albedo that both depend on
/// wavelength make scattering (a factor) and absorption (a complement).
struct ProductSpectrum {
  std::vector<Spectrum> factors, complements;
  bool operator==(const ProductSpectrum&) const;
};
/// Absorption coefficient [1/m] of a gas of which the whole column is known: column * cross-section / path length.
struct ColumnSpectrum {
  double dobson = 0;                    ///< vertical column [Dobson units]
  double path_length = 1;               ///< integral of the profile's relative density up to the planet's top [m]
  std::vector<Spectrum> cross_section;  ///< exactly one [m^2]
  bool operator==(const ColumnSpectrum&) const;
};

/// A quantity that depends on wavelength; its unit is that of the quantity.
class Spectrum {
 public:
  using Law = std::variant<ConstantSpectrum, TableSpectrum, PowerSpectrum, RayleighAirSpectrum,
                           HestrofferMagnanSpectrum, ProductSpectrum, ColumnSpectrum>;

  Spectrum(double value = 0) : law_(ConstantSpectrum{value}) {}
  Spectrum(Law law) : law_(std::move(law)) {}

  /// Value at a wavelength [nm]. Tables are held constant beyond their ends; ask range() whether that is inside the data.
  double at(double wavelength) const;

  /// First and last wavelength [nm] of the data (as stated in a table, for bins too); none for laws that hold everywhere.
  struct Range {
    double first, last;
  };
  std::optional<Range> range() const;

  /// The same spectrum times a factor; a constant takes it into its value, and nothing remains of a law times 0.
  Spectrum scaled(double factor) const;

  const Law& law() const { return law_; }
  double factor() const { return factor_; }
  bool operator==(const Spectrum&) const = default;

 private:
  Law law_;
  double factor_ = 1;
};

/// The spectra that ship with Airlight, by file name ("solar_irradiance.csv", "ozone_cross_section_233K.csv"); none: no such file.
std::optional<TableSpectrum> shipped_spectrum(const std::string& file, Sampling sampling);

}  // namespace airlight
