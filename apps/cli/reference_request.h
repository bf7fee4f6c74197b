// What a line of a batch asks the model `reference` and no other: how long it shall walk.
#pragma once
#include <cstdint>
#include <string>

#include "json_line.h"

namespace airlight::cli {

struct ReferenceEffort {
  long samples = 0;         ///< walks at most
  double target_error = 0;  ///< standard error over value, at the worst wavelength; 0: walk on
  std::uint64_t seed = 1;
};

/// Takes the keys "samples", "target_error" and "seed". @throws InputError
ReferenceEffort read_reference_effort(Fields& fields);

/// The same keys as a Topic's `own` text, and back.
std::string reference_effort_text(Fields& fields);
ReferenceEffort parse_reference_effort(const std::string& text);

}  // namespace airlight::cli
