// Text that a command answers with: to standard output ("-"), or to a file that appears whole or not at all.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "image/output_file.h"

namespace airlight::cli {

class TextOutput {
 public:
  /// @throws InputError where the file cannot be made.
  explicit TextOutput(const std::string& path);

  /// To standard output at once, so that whoever reads it can go on. @throws WorkError naming the file and the reason.
  void write(std::string_view text);
  /// Completes the file. @throws WorkError.
  void finish();

 private:
  std::optional<OutputFile> file_;  ///< none: standard output
};

/// Writes the whole text.
void write_text(const std::string& path, std::string_view text);

}  // namespace airlight::cli
