// What an eye or a camera makes of a spectrum: three curves over wavelength.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace airlight {

using Xyz = std::array<double, 3>;

struct Response {
  std::vector<double> wavelengths;  ///< [nm], 1 nm apart; the response is 0 beyond
  std::vector<Xyz> curves;          ///< of three channels at each
  Response scaled(double factor) const;
};

/// "wavelength [nm],first,second,third" a line, perhaps after a heading, whole numbers of nanometres, increasing; linear between.
/// @param name  for messages
/// @throws InputError: "camera.csv:3: ..." naming what was expected; for a text with fewer than two rows
Response parse_response_csv(std::string_view text, const std::string& name);

}  // namespace airlight
