// Numbers as messages and files show them: the shortest text that reads back to the same double.
#pragma once
#include <charconv>
#include <string>

namespace airlight {

inline std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace airlight
