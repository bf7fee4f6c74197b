#include "scenefile/toml_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "airlight/error.h"
#include "did_you_mean.h"

namespace airlight {
namespace {

std::string at_line(const std::string& file, std::size_t line) { return file + ":" + std::to_string(line) + ": "; }

/// Reads toml++ its text in a form that it bears (3.3, by what fuzzing found). It makes and destroys nested values, and
/// the tables of dotted keys, by recursion with no bound of its own on dots. It asserts rather than reports when '}'
/// stands where an array expects a value. And its test for blanks is undefined for most characters beyond ASCII, which
/// it may look at even inside quotes: they become escapes in strings, and go from comments.
class Bearable {
 public:
  Bearable(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  std::string ascii() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        copy_string(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        if (beyond_ascii(c)) fail("expected ASCII outside quotes and comments");
        count_nesting(c);
        copy();
      }
    }
    return std::move(ascii_);
  }

 private:
  static bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

  [[noreturn]] void fail(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
    throw InputError(at_line(file_, std::size_t(line)) + what);
  }

  void copy() { ascii_ += text_[at_++]; }

  /// Copies a string, or what there is of one that is not closed: toml++ will say so.
  void copy_string(char quote) {
    const std::string three(3, quote);
    const bool many_lines = text_.substr(at_, 3) == three;
    const std::string closing = many_lines ? three : std::string(1, quote);
    for (std::size_t i = 0; i < closing.size(); ++i) copy();
    while (at_ < text_.size() && (many_lines || text_[at_] != '\n')) {
      if (quote == '"' && text_[at_] == '\\') {
        copy();
        if (at_ == text_.size()) return;
        if (beyond_ascii(text_[at_])) fail("expected an escape behind a backslash");
        copy();
      } else if (text_.substr(at_, closing.size()) == closing) {
        // A string of several lines may end in one or two quotes of its own, before the three that close it.
        std::size_t quotes = closing.size();
        while (many_lines && quotes < 5 && text_.substr(at_ + quotes).starts_with(quote)) ++quotes;
        for (std::size_t i = 0; i < quotes; ++i) copy();
        return;
      } else if (beyond_ascii(text_[at_])) {
        if (quote == '\'') fail("expected ASCII in single quotes (double quotes take any character)");
        copy_escaped();
      } else {
        copy();
      }
    }
  }

  /// Copies one character of two to four bytes of UTF-8 as \UXXXXXXXX.
  void copy_escaped() {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text_[at_ + i]); };
    const std::size_t size = std::size_t(std::countl_one(byte(0)));
    bool valid = size >= 2 && size <= 4 && at_ + size <= text_.size();
    std::uint32_t code = byte(0) & (0x7fu >> size);
    for (std::size_t i = 1; valid && i < size; ++i) {
      valid = (byte(i) & 0xc0) == 0x80;
      code = code << 6 | (byte(i) & 0x3f);
    }
    if (!valid) fail("expected UTF-8");
    std::array<char, 11> escape{};
    std::snprintf(escape.data(), escape.size(), "\\U%08x", unsigned(code));
    ascii_ += escape.data();
    at_ += size;
  }

  void count_nesting(char c) {
    constexpr std::size_t deepest = 24;
    if (c == '[' || c == '{') open_ += c;
    if (c == ']' || c == '}') {
      const char opening = c == ']' ? '[' : '{';
      if (open_.empty() || open_.back() != opening) fail(std::string("'") + c + "' closes no '" + opening + "'");
      open_.pop_back();
    }
    if (c == '.') ++dots_;
    if (std::string_view("[]{},=\n").find(c) != std::string_view::npos) dots_ = 0;
    if (open_.size() > deepest || dots_ > deepest) {
      fail("expected at most " + std::to_string(deepest) + " levels of nesting");
    }
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::string ascii_;
  std::string open_;  ///< brackets
  std::size_t dots_ = 0;
};

const char* type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::optional<double> as_number(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return double(integer->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  return std::nullopt;
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  const std::string ascii = Bearable(text, file).ascii();
  try {
    return toml::parse(ascii, file);
  } catch (const toml::parse_error& error) {
    throw InputError(at_line(file, error.source().begin.line) + std::string(error.description()));
  }
}

const toml::node* TableReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_->get(key);
}

const toml::node& TableReader::require(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) fail(key, " is missing");
  return *node;
}

double TableReader::number(std::string_view key) {
  const toml::node& node = require(key);
  const auto value = as_number(node);
  if (!value) fail_type(key, "a number", node);
  return *value;
}

bool TableReader::flag(std::string_view key, bool fallback) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  if (!node->is_boolean()) fail_type(key, "true or false", *node);
  return node->as_boolean()->get();
}

std::string TableReader::text(std::string_view key) {
  const toml::node& node = require(key);
  if (!node.is_string()) fail_type(key, "a string", node);
  return node.as_string()->get();
}

const toml::array& TableReader::array(std::string_view key) {
  const toml::node& node = require(key);
  if (!node.is_array()) fail_type(key, "an array", node);
  return *node.as_array();
}

std::vector<double> TableReader::numbers(std::string_view key) {
  std::vector<double> values;
  for (const toml::node& node : array(key)) {
    const auto value = as_number(node);
    if (!value) fail_type(std::string(key) + "[" + std::to_string(values.size()) + "]", "a number", node);
    values.push_back(*value);
  }
  return values;
}

TableReader TableReader::table(std::string_view key) {
  const toml::node& node = require(key);
  if (!node.is_table()) fail_type(key, "a table", node);
  return child(*node.as_table(), key);
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  std::vector<TableReader> readers;
  for (const toml::node& node : array(key)) {
    const std::string item = std::string(key) + "[" + std::to_string(readers.size()) + "]";
    if (!node.is_table()) fail_type(item, "a table", node);
    readers.push_back(child(*node.as_table(), item));
  }
  return readers;
}

void TableReader::finish() const {
  for (const auto& [key, node] : *table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    throw InputError(at_line(*file_, key.source().begin.line) + path(key.str()) + ": unknown key" +
                     did_you_mean(key.str(), known_));
  }
}

std::string TableReader::beside(const std::string& name) const {
  const std::filesystem::path path(name);
  return path.is_absolute() ? name : (std::filesystem::path(*file_).parent_path() / path).string();
}

std::string TableReader::path(std::string_view key) const {
  if (path_.empty() || key.empty()) return path_ + std::string(key);
  return path_ + "." + std::string(key);
}

void TableReader::fail(std::string_view key, const std::string& what) const { fail_at(path(key), what); }

void TableReader::fail_at(const std::string& path, const std::string& what) const {
  throw InputError(at_line(*file_, line_of(path)) + path + what);
}

void TableReader::fail_message(std::string_view key, const std::string& message) const {
  throw InputError(at_line(*file_, line_of(path(key))) + message);
}

std::string TableReader::location(std::string_view key) const {
  return at_line(*file_, line_of(path(key))) + path(key);
}

std::size_t TableReader::line_of(std::string path) const {
  while (!path.empty()) {
    // Line 0: put there by the program, not by the file.
    const auto node = toml::at_path(*root_, path);
    if (node && node.node()->source().begin.line > 0) return node.node()->source().begin.line;
    const std::size_t cut = path.find_last_of(".[");
    path.resize(cut == std::string::npos ? 0 : cut);
  }
  return 1;
}

void TableReader::fail_type(std::string_view key, const char* expected, const toml::node& node) const {
  fail(key, std::string(": expected ") + expected + ", got " + type_of(node));
}

}  // namespace airlight
