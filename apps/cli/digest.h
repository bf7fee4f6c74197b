// A short name for content, to tell the frames of one scene from those of another.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace airlight::cli {

/// FNV-1a of 64 bits over pieces of text: not cryptographic.
class Digest {
 public:
  void add(std::string_view piece);
  /// The content of a file; one that cannot be read has none.
  void add_file(const std::string& path);
  std::string text() const;  ///< 16 hexadecimal digits

 private:
  void mix(std::string_view bytes);
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace airlight::cli
