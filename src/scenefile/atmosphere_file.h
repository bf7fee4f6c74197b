// Atmospheres as TOML.
#pragma once
#include <string>
#include <string_view>

#include "airlight/atmosphere.h"

namespace airlight {

/// Reads an atmosphere from TOML text.
/// @param name  for messages ("air.toml"), and for files named inside, which are looked for beside it, then among the shipped data
/// @throws InputError: "air.toml:12: planet.ground_radius = -3: expected 1000 .. 1e9 m"; unknown keys get "did you mean".
Atmosphere parse_atmosphere(std::string_view text, const std::string& name);

/// A built-in name or a path that ends in .toml. @throws InputError.
Atmosphere load_atmosphere(const std::string& name_or_path);

/// TOML that parse_atmosphere reads back to an equal atmosphere.
std::string to_toml(const Atmosphere& atmosphere);

}  // namespace airlight
