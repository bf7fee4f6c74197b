#include "model/model.h"

#include <algorithm>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "did_you_mean.h"

namespace airlight {

std::span<const Model> all_models() {
  static const std::vector<Model> models{
      single_model(),   skyview_model(), precomputed_model(), hoffman_preetham_model(),
      codeflow_model(), jetlag_model(),  rama_model(),        realworldz_model()};
  return models;
}

const Model& find_model(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Model& m : all_models()) {
    if (m.name == name) return m;
    names.push_back(m.name);
  }
  throw InputError("unknown model '" + std::string(name) + "'" + did_you_mean(name, names));
}

ModelInfo model_info(std::string_view name) {
  const Model& m = find_model(name);
  return {m.name, m.summary, m.parameters, m.presets, m.colours ? &*m.colours : nullptr, bool(m.gathering)};
}

std::vector<ModelInfo> models() {
  std::vector<ModelInfo> infos;
  for (const Model& m : all_models()) infos.push_back(model_info(m.name));
  return infos;
}

Values model_parameters(const Model& model, const Parameters& given, std::string_view where) {
  Parameters values = given;
  if (const auto named = given.find("preset"); named != given.end()) {
    const auto* name = std::get_if<std::string>(&named->second);
    const auto preset = std::ranges::find(model.presets, name ? *name : "", &Preset::name);
    // insert: what was given stays. An unknown name is refused below, with the others.
    if (preset != model.presets.end()) values.insert(preset->values.begin(), preset->values.end());
  }
  return check_parameters(model.parameters, values, where);
}

}  // namespace airlight
