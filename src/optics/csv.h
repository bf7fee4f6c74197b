// Comma-separated numbers; spectra among them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "airlight/spectrum.h"

namespace airlight {

struct CsvRow {
  int line;                    ///< in its file, from 1
  std::vector<double> values;  ///< one for each column
};

/// The rows of a text. Empty lines and those that begin with '#' say nothing; the first other one may be a heading: no number first.
/// @param name     of the file, for messages
/// @param columns  what a row holds, for messages: "wavelength [nm],value"
/// @throws InputError: "sun.csv:3: ..." for a line that is not as many numbers, "sun.csv: ..." for a text without rows
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& name, std::string_view columns);

/// @param name  for messages, and kept as the table's file
/// @throws InputError as parse_csv; order and ranges are checked with the rest of an atmosphere (validate.h).
TableSpectrum parse_spectrum_csv(std::string_view text, const std::string& name, Sampling sampling);

}  // namespace airlight
