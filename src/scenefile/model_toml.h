// The parameters of published systems in a scene: a table of the model's name.
#pragma once
#include <functional>
#include <map>
#include <string>

#include "airlight/parameters.h"
#include "scenefile/toml_document.h"

namespace airlight {

/// @throws InputError: "scene.toml:12: codeflow.intensity = 20: expected 0 .. 10"; unknown keys get "did you mean".
std::map<std::string, Parameters, std::less<>> read_model_tables(TableReader& root);

}  // namespace airlight
