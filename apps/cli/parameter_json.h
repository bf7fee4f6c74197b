// What may be said under a name, for programs and people: inputs of adapters and parameters of models.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "airlight/parameters.h"

namespace airlight::cli {

nlohmann::ordered_json value_json(const ParameterValue& value);
/// {"name":…,"type":"number","unit":…,"range":[…],"default":…,"optional":true,"text":…}; words in place of a range.
nlohmann::ordered_json parameter_json(const ParameterInfo& key);
/// "number intensity [1] 0 .. 10, default 1.8: sunlight before it enters the air"
std::string parameter_line(const ParameterInfo& key);

}  // namespace airlight::cli
