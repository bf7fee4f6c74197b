// Text that a command answers with: to standard output ("-"), or to a file that appears when it is whole.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "image/output_file.h"

namespace airlight::cli {

class TextOutput {
 public:
  /// @throws InputError where the file cannot be made.
  explicit TextOutput(const std::string& path, OutputFile::Unfinished unfinished = OutputFile::Unfinished::remove);

  /// To standard output at once, so that whoever reads it can go on. @throws WorkError naming the file and the reason.
  void write(std::string_view text);
  /// Completes the file. @throws WorkError.
  void finish();
  /// The file that holds what was written if finish() is never called; empty: none.
  std::string kept() const { return file_ ? file_->kept() : std::string(); }

 private:
  std::optional<OutputFile> file_;  ///< none: standard output
};

/// Writes the whole text.
void write_text(const std::string& path, std::string_view text);

}  // namespace airlight::cli
