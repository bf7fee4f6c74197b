// Shadows that land casts into the air of a picture: not every model has them, and `skyview` not for an eye in space.
#pragma once
#include <optional>
#include <string>

#include "airlight/sky.h"

namespace airlight::cli {

/// As asked; where nothing was, whether the model can.
/// @param altitude  of the eye [m]
/// @throws InputError where they were asked for and the model cannot
bool shades_air(const Sky& sky, double altitude, std::optional<bool> asked);

/// What is said where they are left out unasked.
std::string unshaded_note(const Sky& sky);

}  // namespace airlight::cli
