#include "shaded_air.h"

#include <fmt/core.h>

#include "airlight/error.h"

namespace airlight::cli {

bool shades_air(const Sky& sky, double altitude, std::optional<bool> asked) {
  if (asked == false) return false;
  const bool able = sky.shades_air(altitude);
  if (asked && !able)
    throw InputError(fmt::format(
        "model {}: cannot shade the air for an observer at {:g} m; expected picture.air_shadows = false, or none",
        sky.model(), altitude));
  return able;
}

std::string unshaded_note(const Sky& sky) {
  return fmt::format(
      "land casts no shadows into the air: model {} cannot make them for this observer (picture.air_shadows = false "
      "or --no-air-shadows: without this line)",
      sky.model());
}

}  // namespace airlight::cli
