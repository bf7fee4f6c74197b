#include "parameter_json.h"

#include <fmt/core.h>

namespace airlight::cli {
namespace {

using Kind = ParameterInfo::Kind;

std::string_view kind_name(const ParameterInfo& key) {
  constexpr std::string_view names[] = {"number", "whole", "flag", "colour", "vector", "list", "word", "picture"};
  return names[static_cast<int>(key.kind)];
}

constexpr double no_limit = 1e300;

}  // namespace

nlohmann::ordered_json value_json(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* picture = std::get_if<std::shared_ptr<const ParameterPicture>>(&value)) return (*picture)->name;
  const auto& numbers = std::get<std::vector<double>>(value);
  if (numbers.size() == 1) return numbers[0];
  return numbers;
}

nlohmann::ordered_json parameter_json(const ParameterInfo& key) {
  nlohmann::ordered_json json{{"name", key.name}, {"type", kind_name(key)}, {"unit", key.unit}};
  if (key.kind == Kind::vector || key.kind == Kind::list) json["size"] = key.size;
  if (key.kind == Kind::word) json["words"] = key.words;
  if (key.kind != Kind::word && key.kind != Kind::flag && key.kind != Kind::picture)
    json["range"] = {key.low, key.high};
  if (key.otherwise) json["default"] = value_json(*key.otherwise);
  if (key.optional || key.otherwise) json["optional"] = true;
  if (!key.text.empty()) json["text"] = key.text;
  return json;
}

std::string parameter_line(const ParameterInfo& key) {
  std::string text = fmt::format("{} {}", kind_name(key), key.name);
  if (key.kind == Kind::word) {
    for (const std::string_view word : key.words)
      text += fmt::format("{}{}", word == key.words[0] ? " = " : " | ", word);
  } else if (key.kind != Kind::flag && key.kind != Kind::picture) {
    text += fmt::format(" [{}]", key.unit);
    if (key.high < no_limit) text += fmt::format(" {:g} .. {:g}", key.low, key.high);
  }
  if (key.otherwise) text += fmt::format(", default {}", value_json(*key.otherwise).dump());
  if (key.optional && !key.otherwise) text += ", may be left out";
  if (!key.text.empty()) text += fmt::format(": {}", key.text);
  return text;
}

}  // namespace airlight::cli
