// Phase functions in JSON: the types and keys of the TOML.
#pragma once
#include "airlight/atmosphere.h"
#include "json_line.h"

namespace airlight::cli {

/// {"type":"henyey-greenstein","g":0.7}. The last of a table's "angles" tells their unit: 180 degrees, or pi as in TOML; its
/// "values" are divided by their integral.
/// @param object  its value of the key "phase"
/// @throws InputError naming key, value and legal range
Phase read_phase(Fields& object);

}  // namespace airlight::cli
