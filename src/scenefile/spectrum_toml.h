// A spectrum in TOML: a number, { wavelengths, values }, { file } or a law { type, ... }; all but the number take
// `scale`.
#pragma once
#include <string>

#include "airlight/spectrum.h"
#include "optics/validate.h"
#include "scenefile/toml_document.h"

namespace airlight {

/// Reads and checks the spectrum under a key.
/// @param path_length  of the profile that a law "column" spreads its gas over [m]; 0: that law has no place here
Spectrum read_spectrum(TableReader& reader, const std::string& key, Limits limits, double path_length = 0);

/// What read_spectrum() reads back to an equal spectrum, in one line.
std::string spectrum_toml(const Spectrum& spectrum);

}  // namespace airlight
