// A scene from TOML that is parsed already.
#pragma once
#include "scenefile/scene_file.h"
#include "scenefile/toml_document.h"

namespace airlight {

/// @param file  for messages; files named inside are looked for beside it
/// @throws InputError as parse_scene does. Key frames (`animate`) are passed over.
Scene read_scene(const toml::table& document, const std::string& file);

}  // namespace airlight
