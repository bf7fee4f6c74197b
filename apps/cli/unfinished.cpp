#include "unfinished.h"

#include <filesystem>
#include <fstream>

#include "commands.h"
#include "engine/source_version.h"
#include "judging_version.h"
#include "text_output.h"

namespace airlight::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::optional<Json> read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) return {};
  try {
    return Json::parse(file);
  } catch (const Json::exception&) {
    return {};
  }
}

Unfinished::Unfinished(std::string folder, Json key)
    : folder_(std::move(folder)),
      key_{{"version", version()}, {"sources", {source_version(), judging_version()}}, {"of", std::move(key)}} {}

std::optional<Json> Unfinished::find(const std::string& part) const {
  auto json = read_json(path(part));
  if (!json || json->value("key", Json()) != key_ || !json->contains("done")) return {};
  return (*json)["done"];
}

void Unfinished::keep(const std::string& part, const Json& done) const {
  std::error_code error;
  fs::create_directories(folder_, error);  // one that cannot be made, the file complains of
  write_text(path(part), Json{{"key", key_}, {"done", done}}.dump());
}

void Unfinished::remove() const {
  std::error_code error;
  fs::remove_all(folder_, error);
}

}  // namespace airlight::cli
