// What a long command has done so far, in files of its own until all is done: started again, it goes on.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace airlight::cli {

/// The file's JSON; none where it cannot be read or holds none.
std::optional<nlohmann::ordered_json> read_json(const std::string& path);

class Unfinished {
 public:
  /// @param folder  made when the first part is kept
  /// @param key     what the parts depend on: those of another key, of another version of the program, or computed by
  ///                other sources, are not taken
  Unfinished(std::string folder, nlohmann::ordered_json key);

  std::optional<nlohmann::ordered_json> find(const std::string& part) const;
  void keep(const std::string& part, const nlohmann::ordered_json& done) const;
  /// All is done.
  void remove() const;

 private:
  std::string path(const std::string& part) const { return folder_ + '/' + part + ".json"; }
  std::string folder_;
  nlohmann::ordered_json key_;
};

}  // namespace airlight::cli
