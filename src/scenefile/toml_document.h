// TOML text to tables that are read strictly: every key known, every type right, every complaint with file, line and
// key.
#pragma once
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace airlight {

/// Parses TOML. Text that nests deeper than any scene does is refused before toml++'s recursion meets it.
/// @throws InputError: "air.toml:3: ..."
toml::table parse_toml(std::string_view text, const std::string& file);

/// One table of a document. Keys that nobody asked for are mistakes: call finish() when all were read.
class TableReader {
 public:
  /// The document's root. Both must outlive the reader and its children.
  TableReader(const toml::table& root, const std::string& file) : TableReader(root, file, root, "") {}

  bool has(std::string_view key) { return find(key) != nullptr; }
  const toml::node* find(std::string_view key);  ///< null: not there

  // ---- values; without a fallback the key must be there ----
  double number(std::string_view key);
  double number(std::string_view key, double fallback) { return has(key) ? number(key) : fallback; }
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key);
  std::vector<double> numbers(std::string_view key);
  TableReader table(std::string_view key);
  std::vector<TableReader> tables(std::string_view key);  ///< an array of tables
  const toml::array& array(std::string_view key);
  /// A table found by find() or in array(), under the key "factors[1]" that names it.
  TableReader child(const toml::table& table, std::string_view key) const { return {*root_, *file_, table, path(key)}; }

  /// @throws InputError with "did you mean" for a key that was never asked for.
  void finish() const;

  /// From the document's root: "constituent[1].profile".
  const std::string& path() const { return path_; }
  /// "constituent[1].profile.type"
  std::string path(std::string_view key) const;

  /// Complains about a key, at its line, or at the table's where there is no such key.
  /// @param what  ends the sentence that begins with the key: " = -3: expected ..."
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;
  /// The same for a path from the document's root; the line is that of the longest beginning of it that exists.
  [[noreturn]] void fail_at(const std::string& path, const std::string& what) const;
  /// A message that names the key itself, at the key's line.
  [[noreturn]] void fail_message(std::string_view key, const std::string& message) const;

  /// "scene.toml:12: camera.altitude", for complaints that come when the file is long read.
  std::string location(std::string_view key) const;

  const std::string& file() const { return *file_; }
  /// A file named in the document lies beside it.
  std::string beside(const std::string& name) const;

 private:
  TableReader(const toml::table& root, const std::string& file, const toml::table& table, std::string path)
      : root_(&root), file_(&file), table_(&table), path_(std::move(path)) {}
  const toml::node& require(std::string_view key);
  std::size_t line_of(std::string path) const;
  [[noreturn]] void fail_type(std::string_view key, const char* expected, const toml::node& node) const;

  const toml::table* root_;
  const std::string* file_;
  const toml::table* table_;
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace airlight
