// Which of the names that answer are models of the sky.
#pragma once
#include <optional>
#include <string_view>

#include "airlight/model_info.h"

namespace airlight::cli {

/// The model of the sky of a name that answers; none: it is one of the solvers.
std::optional<ModelInfo> model_of_sky(std::string_view name);

}  // namespace airlight::cli
