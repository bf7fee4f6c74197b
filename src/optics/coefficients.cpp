#include "optics/coefficients.h"

namespace airlight {

double path_length(const Profile& profile, double top) { return mean_density(profile, 0, top) * top; }

Spectrum column_absorption(double dobson, const Spectrum& cross_section, const Profile& profile, double top) {
  return Spectrum(ColumnSpectrum{dobson, path_length(profile, top), {cross_section}});
}

Coefficients split_extinction(const Spectrum& extinction, const Spectrum& single_scattering_albedo) {
  if (const auto* albedo = std::get_if<ConstantSpectrum>(&single_scattering_albedo.law())) {
    return {extinction.scaled(albedo->value), extinction.scaled(1 - albedo->value)};
  }
  return {Spectrum(ProductSpectrum{{extinction, single_scattering_albedo}, {}}),
          Spectrum(ProductSpectrum{{extinction}, {single_scattering_albedo}})};
}

}  // namespace airlight
