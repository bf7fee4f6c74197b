// Values as TOML text.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "optics/number_text.h"

namespace airlight {

/// A floating-point number that reads back to the same double.
inline std::string toml_text(double value) {
  std::string text = number_text(value);
  // Without point or exponent it would be an integer, of which TOML has 64 bits.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

inline std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20 || code == 0x7f) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04X", code);
      quoted += escaped;
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

inline std::string toml_text(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + toml_text(value);
  return text + "]";
}

}  // namespace airlight
