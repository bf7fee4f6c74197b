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
  for (i += many_lines ? 3 : 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (many_lines ? text.substr(i, 3) == three : text[i] == quote) {
      return i + (many_lines ? 3 : 1);
    } else if (!many_lines && text[i] == '\n') {
      return i;  // not closed: toml++ will say so
    }
  }
  return i;
}

/// toml++ 3.3 makes and destroys nested values, and tables of dotted keys, by recursion without a bound of its own on
/// dots.
void refuse_deep_nesting(std::string_view text, const std::string& file) {
  constexpr int deepest = 24;
  int depth = 0, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = skip_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.') ++dots;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') depth = std::max(0, depth - 1);
    if (std::string_view("[]{},=\n").find(c) != std::string_view::npos) dots = 0;
    if (depth > deepest || dots > deepest) {
      const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(i), '\n');
      throw InputError(at_line(file, std::size_t(line)) + "expected at most " + std::to_string(deepest) +
                       " levels of nesting");
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
  refuse_deep_nesting(text, file);
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

std::size_t TableReader::line_of(std::string path) const {
  while (!path.empty()) {
    if (const auto node = toml::at_path(*root_, path)) return node.node()->source().begin.line;
    const std::size_t cut = path.find_last_of(".[");
    path.resize(cut == std::string::npos ? 0 : cut);
  }
  return 1;
}

void TableReader::fail_type(std::string_view key, const char* expected, const toml::node& node) const {
  fail(key, std::string(": expected ") + expected + ", got " + type_of(node));
}

}  // namespace airlight
