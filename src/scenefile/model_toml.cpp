#include "scenefile/model_toml.h"

#include "airlight/error.h"
#include "airlight/model_info.h"
#include "model/parameters.h"

namespace airlight {
namespace {

ParameterValue read_value(TableReader& reader, const ParameterInfo& info) {
  const std::string_view key = info.name;
  const toml::node& node = *reader.find(key);
  if (info.kind == ParameterInfo::Kind::picture) return reader.beside(reader.text(key));
  if (node.is_string()) return reader.text(key);
  if (node.is_boolean()) return std::vector<double>{reader.flag(key, false) ? 1.0 : 0.0};
  if (node.is_array()) return reader.numbers(key);
  return std::vector<double>{reader.number(key)};
}

Parameters read_parameters(TableReader reader, const ModelInfo& model) {
  Parameters values;
  for (const ParameterInfo& key : model.parameters) {
    if (!reader.has(key.name)) continue;
    const ParameterValue value = read_value(reader, key);
    try {
      values.emplace(key.name, check_parameter(key, value, reader.path() + "."));
    } catch (const InputError& error) {
      reader.fail_message(key.name, error.what());
    }
  }
  reader.finish();
  return values;
}

}  // namespace

std::map<std::string, Parameters, std::less<>> read_model_tables(TableReader& root) {
  std::map<std::string, Parameters, std::less<>> tables;
  for (const ModelInfo& model : models()) {
    if (model.parameters.empty() || !root.has(model.name)) continue;
    tables.emplace(model.name, read_parameters(root.table(model.name), model));
  }
  return tables;
}

}  // namespace airlight
