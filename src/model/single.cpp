// Numerical single scattering: light scattered or reflected exactly once, for any planet and air. What it leaves out is all light
// scattered more than once: a fifth of the blue noon sky, most of the light in haze, nearly all of late twilight.
#include "model/model.h"

namespace airlight {

Model single_model() {
  return {
      .name = "single",
      .summary = "numerical single scattering: each ray marched; any planet, any air; no light of higher orders",
      // A grazing ray lies for 100 km in one cell: 1024 of them cost 1.1e-5 of transmittance, 2048 a quarter of that.
      .air = {.zones = 64, .substeps = 2, .cells = 2048},
      .tables = {{"core.optical_depth", {512, 128}}, {"core.sunlight", {512, 128}}},
      .rays = "single.rays",
      .sky_light = "single.sky_light",
      .picture = [](const Situation&) -> std::string_view { return "single.picture"; },
      .haze = [](const Situation&) -> std::string_view { return ""; },
      .fields = {},
  };
}

}  // namespace airlight
