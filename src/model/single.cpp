// Numerical single scattering: light scattered or reflected exactly once, for any planet and air. What it leaves out is all light
// scattered more than once: a fifth of the blue noon sky, most of the light in haze, nearly all of late twilight.
#include "model/model.h"

namespace airlight {

Model single_model() {
  return {
      .name = "single",
      .summary = "numerical single scattering: each ray marched; any planet, any air; no light of higher orders",
      .air = {.zones = 32, .substeps = 4},
      .tables = {{"core.optical_depth", {512, 128}}, {"core.sunlight", {512, 128}}},
      .rays = "single.rays",
      .irradiance = "single.irradiance",
      .picture = [](const Situation&) -> std::string_view { return "single.picture"; },
      .fields = {},
  };
}

}  // namespace airlight
