// Text that a command answers with: to standard output ("-"), or to a file that appears whole or not at all.
#pragma once
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "image/output_file.h"

namespace airlight::cli {

class TextOutput {
 public:
  /// @throws InputError where the file cannot be made.
  explicit TextOutput(const std::string& path);
  ~TextOutput();
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  /// @throws WorkError naming the file and the reason.
  void write(std::string_view text);
  /// What was written so far can be read at the other end of a pipe.
  void flush();
  /// Completes the file. @throws WorkError.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::string name_;
  std::optional<OutputFile> file_;
  std::FILE* stream_;
};

/// Writes the whole text.
void write_text(const std::string& path, std::string_view text);

}  // namespace airlight::cli
