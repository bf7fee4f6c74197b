// What `airlight validate` is told, for its parts.
#pragma once
#include <string>
#include <vector>

namespace airlight::cli {

struct ValidateOptions {
  std::string folder;               ///< that reports go to
  std::string data = "data";        ///< the repository's or the installed data
  std::vector<std::string> models;  ///< none: all
  std::string page;                 ///< a page whose part between markers is written anew; empty: none
  std::string against;              ///< a ledger.json; empty: none
  bool quick = false, measured = false, spectrum = false;
};

/// Models against the yardstick (data/yardstick).
int validate_ledger(const ValidateOptions& options);

/// Models and air against measured and published values (data/measured).
int validate_measured(const ValidateOptions& options);

/// Colours of few wavelengths against those of many; fits the four of real time.
int validate_spectrum(const ValidateOptions& options);

/// Writes the text between "<!-- NAME begin" and "<!-- NAME end" of a page anew.
/// @throws InputError where the page cannot be read or has no such marks
void write_into_page(const std::string& page, const std::string& name, const std::string& text);

}  // namespace airlight::cli
