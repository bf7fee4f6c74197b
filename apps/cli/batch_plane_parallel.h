// What a line of a batch asks the plane-parallel solver and no other model: its air, and where the observer stands.
#pragma once
#include <string>

#include "json_line.h"
#include "reference/plane_parallel.h"

namespace airlight::cli {

struct PlaneParallelScene {
  reference::PlaneParallelAir air;
  bool from_space = false;
};

/// Takes the keys "layers", "surface_albedo" and "observer". @throws InputError
PlaneParallelScene read_plane_parallel(Fields& fields);

/// The same keys as a Topic's `own` text, and back.
std::string plane_parallel_text(Fields& fields);
PlaneParallelScene parse_plane_parallel(const std::string& text);

}  // namespace airlight::cli
