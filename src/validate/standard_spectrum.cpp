#include "validate/standard_spectrum.h"

#include <cstdio>
#include <fstream>

#include "airlight/error.h"
#include "airlight/spectrum.h"

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
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) throw InputError(path + ": cannot be read");
  StandardSpectrum spectrum;
  for (int number = 2; std::getline(file, line); ++number) {
    double w, above, global, direct;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &w, &above, &global, &direct) != 4)
      throw InputError(path + ":" + std::to_string(number) + ": expected four numbers");
    spectrum.wavelengths.push_back(w);
    spectrum.above.push_back(above);
    spectrum.direct.push_back(direct);
  }
  return spectrum;
}

}  // namespace airlight::validation
