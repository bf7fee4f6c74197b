// Spectra as comma-separated text: a heading, then one "wavelength,value" a line.
#pragma once
#include <string>
#include <string_view>

#include "airlight/spectrum.h"

namespace airlight {

/// @param name  for messages, and kept as the table's file
/// @throws InputError: "sun.csv:3: ..." for a line that is not two numbers; order and ranges are checked with the rest
/// of an
///         atmosphere (validate.h).
TableSpectrum parse_spectrum_csv(std::string_view text, const std::string& name, Sampling sampling);

}  // namespace airlight
