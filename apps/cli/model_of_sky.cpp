#include "model_of_sky.h"

#include <algorithm>
#include <vector>

namespace airlight::cli {

std::optional<ModelInfo> model_of_sky(std::string_view name) {
  const std::vector<ModelInfo> known = models();
  const auto found = std::ranges::find(known, name, &ModelInfo::name);
  return found == known.end() ? std::nullopt : std::optional(*found);
}

}  // namespace airlight::cli
