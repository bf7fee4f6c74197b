#include "scenefile/text_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "airlight/error.h"

namespace airlight {

std::optional<std::string> read_text_file(const std::string& path) {
  namespace fs = std::filesystem;
  // What is no path at all (too long, a file where a folder should be) has no file either.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return std::nullopt;
  if (!fs::is_regular_file(status)) throw InputError(path + ": expected a regular file");
  constexpr std::uintmax_t largest = 16 << 20;
  if (fs::file_size(path, error) > largest) throw InputError(path + ": expected a file of at most 16 MiB");
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) throw InputError(path + ": cannot be read");
  return text;
}

}  // namespace airlight
