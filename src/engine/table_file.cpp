#include "engine/table_file.h"

#include <unistd.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>

namespace airlight {
namespace {

// "AIRTABLE" as a number, so that a machine of the other byte order does not take the file for its own.
constexpr std::uint64_t magic = 0x454c424154524941, version = 1;
constexpr std::uint64_t most_texels = 1u << 28, most_tables = 64;

// FNV-1a over 64-bit words, folded so that high bits reach low ones.
std::uint64_t checksum(std::span<const std::uint64_t> words) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const std::uint64_t word : words) {
    sum = (sum ^ word) * 0x100000001b3;
    sum ^= sum >> 29;
  }
  return sum;
}

constexpr const char* unfinished = ".partial-";

/// What processes that were killed while writing have left: nobody writes for an hour.
void remove_leftovers(const std::filesystem::path& folder) {
  std::error_code error;
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::error_code gone;
    if (entry.path().filename().string().find(std::string(".tables") + unfinished) != std::string::npos &&
        entry.last_write_time(gone) < old && !gone)
      std::filesystem::remove(entry.path(), gone);
  }
}

std::size_t words_of(Shape shape, int number_size) { return 4 * shape.texels() * std::size_t(number_size) / 8; }

}  // namespace

std::optional<std::vector<TableFile::Values>> TableFile::read(std::string& trouble) const {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  if (missing) return {};
  const auto refuse = [&](const char* why) {
    trouble = path.string() + ": " + why + "; made anew";
    return std::nullopt;
  };
  if (size % 8 != 0 || size < 48) return refuse("not a whole table file");
  std::vector<std::uint64_t> words(size / 8);
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(words.data()), std::streamsize(size))) return refuse("cannot be read");
  if (words[0] != magic) return refuse("not a table file");
  if (words[1] != version) return refuse("a table file of another version");
  if (words[2] != key || words[3] != std::uint64_t(number_size)) return refuse("made from something else");
  if (words.back() != checksum(std::span(words).first(words.size() - 1)))
    return refuse("damaged: its checksum differs");
  std::vector<Values> tables;
  std::size_t at = 5;
  for (std::uint64_t i = 0; i < std::min(words[4], most_tables); ++i) {
    if (at + 3 >= words.size()) return refuse("not a whole table file");
    const std::uint64_t* edge = &words[at];
    if (edge[0] < 1 || edge[1] < 1 || edge[2] < 1 || edge[0] > 1u << 16 || edge[1] > 1u << 16 || edge[2] > 1u << 16 ||
        edge[0] * edge[1] > most_texels || edge[0] * edge[1] * edge[2] > most_texels)
      return refuse("a table of impossible size");
    Values& table = tables.emplace_back(Values{{int(edge[0]), int(edge[1]), int(edge[2])}, {}});
    at += 3;
    const std::size_t length = words_of(table.shape, number_size);
    if (at + length + 1 > words.size()) return refuse("not a whole table file");
    table.rgba.resize(4 * table.shape.texels());
    if (number_size == 8) {
      std::memcpy(table.rgba.data(), &words[at], 8 * length);
    } else {
      std::vector<float> floats(table.rgba.size());
      std::memcpy(floats.data(), &words[at], 8 * length);
      table.rgba.assign(floats.begin(), floats.end());
    }
    for (const double v : table.rgba) {
      if (!std::isfinite(v)) return refuse("holds what is no number");
    }
    at += length;
  }
  if (at + 1 != words.size()) return refuse("longer than its tables");
  return tables;
}

std::string TableFile::write(const std::vector<Values>& tables) const {
  std::vector<std::uint64_t> words{magic, version, key, std::uint64_t(number_size), tables.size()};
  for (const Values& table : tables) {
    for (const int edge : {table.shape.width, table.shape.height, table.shape.depth})
      words.push_back(std::uint64_t(edge));
    const std::size_t at = words.size(), length = words_of(table.shape, number_size);
    words.resize(at + length);
    if (number_size == 8) {
      std::memcpy(&words[at], table.rgba.data(), 8 * length);
    } else {
      const std::vector<float> floats(table.rgba.begin(), table.rgba.end());
      std::memcpy(&words[at], floats.data(), 8 * length);
    }
  }
  words.push_back(checksum(words));

  static std::atomic<unsigned> count{0};
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  remove_leftovers(path.parent_path());
  // A name of this process alone: two that make the same tables do not write into one file.
  std::filesystem::path temporary = path;
  temporary += unfinished + std::to_string(getpid()) + "-" + std::to_string(count++);
  std::ofstream file(temporary, std::ios::binary);
  file.write(reinterpret_cast<const char*>(words.data()), std::streamsize(8 * words.size()));
  file.close();
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return path.string() + ": cannot be written; its tables will be made again next time";
  }
  return {};
}

}  // namespace airlight
