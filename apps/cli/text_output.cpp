#include "text_output.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "airlight/error.h"

namespace airlight::cli {

TextOutput::TextOutput(const std::string& path) : name_(path == "-" ? "standard output" : path), stream_(stdout) {
  if (path == "-") return;
  file_.emplace(path);
  stream_ = std::fopen(file_->temporary().c_str(), "wb");
  if (!stream_) throw WorkError(fmt::format("{}: {}", name_, std::strerror(errno)));
}

TextOutput::~TextOutput() {
  if (file_ && stream_) std::fclose(stream_);
}

void TextOutput::fail() const { throw WorkError(fmt::format("{}: {}", name_, std::strerror(errno))); }

void TextOutput::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail();
}

void TextOutput::flush() {
  if (std::fflush(stream_) != 0) fail();
}

void TextOutput::finish() {
  flush();
  if (!file_) return;
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail();
  file_->commit();
}

void write_text(const std::string& path, std::string_view text) {
  TextOutput output(path);
  output.write(text);
  output.finish();
}

}  // namespace airlight::cli
