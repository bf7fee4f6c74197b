#include "validate/standard_spectrum.h"

#include <fstream>
#include <iterator>

#include "airlight/error.h"
#include "airlight/spectrum.h"
#include "optics/csv.h"

namespace airlight::validation {

double StandardSpectrum::above_in_box(double first, double last) const {
  const Spectrum sunlight(TableSpectrum{wavelengths, above, Sampling::point, ""});
  // Midpoints finer than the table, which is linear in between.
  const int parts = 200;
  double sum = 0;
  for (int i = 0; i < parts; ++i) sum += sunlight.at(first + (i + 0.5) / parts * (last - first));
  return sum / parts;
}

StandardSpectrum read_standard_spectrum(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) throw InputError(path + ": cannot be read");
  StandardSpectrum spectrum;
  for (const CsvRow& row : parse_csv(text, path, "wavelength [nm],above the air,global,direct")) {
    spectrum.wavelengths.push_back(row.values[0]);
    spectrum.above.push_back(row.values[1]);
    spectrum.direct.push_back(row.values[3]);
  }
  return spectrum;
}

}  // namespace airlight::validation
