// Whole text files, of regular files and reasonable size only.
#pragma once
#include <optional>
#include <string>

namespace airlight {

/// The file's bytes; none where there is no such file.
/// @throws InputError for what is not a regular file, is larger than 16 MiB or cannot be read.
std::optional<std::string> read_text_file(const std::string& path);

}  // namespace airlight
