#include "text_output.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "airlight/error.h"

namespace airlight::cli {

TextOutput::TextOutput(const std::string& path, OutputFile::Unfinished unfinished) {
  if (path != "-") file_.emplace(path, unfinished);
}

void TextOutput::write(std::string_view text) {
  if (file_)
    file_->write(text);
  else if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw WorkError(fmt::format("standard output: {}", std::strerror(errno)));
}

void TextOutput::finish() {
  if (file_) file_->commit();
}

void write_text(const std::string& path, std::string_view text) {
  TextOutput output(path);
  output.write(text);
  output.finish();
}

}  // namespace airlight::cli
