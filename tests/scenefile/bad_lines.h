// Files that are good but for a line, and what is said of them.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "airlight/error.h"

namespace airlight {

/// A good file with one of its lines, counted from 1, replaced; 0: none.
inline std::string with_line(const std::vector<std::string>& good, std::size_t line, const std::string& replacement) {
  std::string text;
  for (std::size_t i = 0; i < good.size(); ++i) text += (i + 1 == line ? replacement : good[i]) + "\n";
  return text;
}

struct BadLine {
  std::size_t line;         ///< replaced
  std::string replacement;  ///< may be several lines
  std::vector<std::string> expected;
};

/// @param parse  called with each bad text; must throw InputError with all that is expected in its message
template <class Parse>
void expect_refused(const std::vector<std::string>& good, const std::vector<BadLine>& lines, const Parse& parse) {
  for (const BadLine& bad : lines) {
    try {
      parse(with_line(good, bad.line, bad.replacement));
      ADD_FAILURE() << "accepted: " << bad.replacement;
    } catch (const InputError& error) {
      for (const std::string& fragment : bad.expected) {
        EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos)
            << error.what() << "\n  lacks: " << fragment << "\n  for: " << bad.replacement;
      }
    }
  }
}

}  // namespace airlight
