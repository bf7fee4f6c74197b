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

/// The part of a page between "<!-- NAME begin" and "<!-- NAME end", to be written anew.
class PagePart {
 public:
  /// @param page  empty: none, and nothing is written
  /// @throws InputError where it cannot be read or has no such marks
  PagePart(std::string page, const std::string& name);
  void write(const std::string& text) const;

 private:
  std::string page_, before_, after_;
};

/// @throws InputError where the folder for reports cannot be made
void make_report_folder(const std::string& folder);

}  // namespace airlight::cli
