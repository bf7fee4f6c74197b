// Density profiles and phase functions in TOML: { type = "exponential", scale_height = 8000.0 }.
#pragma once
#include <string>

#include "airlight/atmosphere.h"
#include "scenefile/toml_document.h"

namespace airlight {

Profile read_profile(TableReader& reader);
Phase read_phase(TableReader& reader);

/// What the readers read back to equal values, in one line.
std::string profile_toml(const Profile& profile);
std::string phase_toml(const Phase& phase);

}  // namespace airlight
