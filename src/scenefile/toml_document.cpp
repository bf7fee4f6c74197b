#include "scenefile/toml_document.h"

#include <algorithm>
#include <optional>

#include "airlight/error.h"
#include "did_you_mean.h"

namespace airlight {
namespace {

std::string at_line(const std::string& file, std::size_t line) { return file + ":" + std::to_string(line) + ": "; }

/// Skips a string that begins at `i`; returns the index after it.
std::size_t skip_string(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const std::string three(3, quote);
  const bool many_lines = text.substr(i, 3) == three;
  const std::string closing = many_lines ? three : std::string(1, quote);
  for (i += closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, closing.size()) == closing) {
      i += closing.size();
      // A string of several lines may end in one or two quotes of its own, before the three that close it.
      for (int own = 0; many_lines && own < 2 && i < text.size() && text[i] == quote; ++own) ++i;
      return i;
    } else if (!many_lines && text[i] == '\n') {
      return i;  // not closed: toml++ will say so
    }
  }
  return text.size();
}

bool has_non_ascii(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

/// Refuses what toml++ 3.3 does not bear. It makes and destroys nested values, and the tables of dotted keys, by
/// recursion with no bound of its own on dots. It asserts rather than reports when '}' stands where an array expects a
/// value. And its test for blanks is undefined for most characters beyond ASCII: they are legal in quotes and comments,
/// where it asks only after a backslash in a multi-line string.
void refuse_unbearable(std::string_view text, const std::string& file) {
  constexpr std::size_t deepest = 24;
  std::string open;  // brackets
  std::size_t dots = 0;
  const auto fail = [&](std::size_t i, const std::string& what) {
    const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(i), '\n');
    throw InputError(at_line(file, std::size_t(line)) + what);
  };
  const std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::size_t start = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  for (std::size_t i = start; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      // Where no string may begin, the parser would look at what follows as if it stood outside quotes.
      if (i > start && std::string_view(" \t\r\n=,.[{").find(text[i - 1]) == std::string_view::npos)
        fail(i, "expected a blank, '=', ',', '.', '[' or '{' before a quote");
      const std::size_t end = skip_string(text, i);
      if (text.substr(i, 3) == R"(""")" && has_non_ascii(text.substr(i, end - i))) {
        fail(i, "expected ASCII in a string of several lines");
      }
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (has_non_ascii(text.substr(i, 1))) fail(i, "expected ASCII outside quotes and comments");
    if (c == '[' || c == '{') open += c;
    if (c == ']' || c == '}') {
      const char opening = c == ']' ? '[' : '{';
      if (open.empty() || open.back() != opening) fail(i, std::string("'") + c + "' closes no '" + opening + "'");
      open.pop_back();
    }
    if (c == '.') ++dots;
    if (std::string_view("[]{},=\n").find(c) != std::string_view::npos) dots = 0;
    if (open.size() > deepest || dots > deepest) {
      fail(i, "expected at most " + std::to_string(deepest) + " levels of nesting");
    }
    ++i;
  }
}

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
  refuse_unbearable(text, file);
  try {
    return toml::parse(text, file);
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
