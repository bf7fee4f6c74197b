// The files of data/ as they are compiled into the library.
#pragma once
#include <span>
#include <string_view>

namespace airlight {

struct ShippedFile {
  std::string_view name, text;
};

/// All of them, by name. Defined in the source that tools/embed_data.py writes.
std::span<const ShippedFile> shipped_files();

/// The text of one file; empty: no such file.
inline std::string_view shipped_text(std::string_view name) {
  for (const ShippedFile& file : shipped_files()) {
    if (file.name == name) return file.text;
  }
  return {};
}

}  // namespace airlight
