// What the two files of Hoffman & Preetham's system share: its parameters, and what the kernels get of them.
#pragma once
#include <vector>

#include "model/model.h"
#include "model/parameters.h"

namespace airlight::hoffman_preetham {

const std::vector<ParameterInfo>& parameters();
const std::vector<Preset>& presets();
/// The kernels' struct HoffmanPreetham.
Fields kernel_fields(const Values& values);

}  // namespace airlight::hoffman_preetham
