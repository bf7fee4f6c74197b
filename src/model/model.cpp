#include "model/model.h"

#include "airlight/error.h"
#include "airlight/sky.h"
#include "did_you_mean.h"

namespace airlight {

std::span<const Model> all_models() {
  static const std::vector<Model> models{single_model(), skyview_model()};
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

std::vector<ModelInfo> models() {
  std::vector<ModelInfo> infos;
  for (const Model& m : all_models()) infos.push_back({m.name, m.summary});
  return infos;
}

}  // namespace airlight
