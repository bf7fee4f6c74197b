#include "digest.h"

#include <fmt/core.h>

#include <fstream>
#include <vector>

namespace airlight::cli {

void Digest::mix(std::string_view bytes) {
  for (const char c : bytes) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
}

void Digest::add(std::string_view piece) {
  mix(fmt::format("{}:", piece.size()));  // "ab" "c" is not "a" "bc"
  mix(piece);
}

void Digest::add_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(1 << 16);
  Digest content;
  while (file) {
    file.read(block.data(), std::streamsize(block.size()));
    content.mix({block.data(), std::size_t(file.gcount())});
  }
  add(content.text());
}

std::string Digest::text() const { return fmt::format("{:016x}", state_); }

}  // namespace airlight::cli
