// The numbers of one view from a published system, which answers in red, green and blue.
#pragma once
#include <memory>
#include <string>

#include "airlight/sky.h"
#include "options.h"

namespace airlight::cli {

struct ColourQuestion {
  std::string model;
  Parameters parameters;
  std::shared_ptr<Engine> engine;
  SunPlace sun;
  Atmosphere atmosphere;  ///< its air is not asked: the system has its own
  Ray ray;
};

/// Everything that the system says of the view, as a table or as JSON; what it says nothing on is left out.
/// @throws InputError, also where it says nothing on the view itself
std::string probe_colours(const ColourQuestion& question, bool json);

}  // namespace airlight::cli
