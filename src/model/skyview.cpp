// The sky in real time, after Hillaire 2020: light of the second order is gathered isotropically and the higher orders follow as a
// geometric series, so bright haze and deep twilight are approximate (docs/accuracy.md has the figures).
#include <cmath>

#include "model/model.h"

namespace airlight {
namespace {

constexpr Shape dome{128, 160}, froxels{32, 64, 32};

// Above a third of the air the horizon of the sky-view table is the limb of a planet, too thin for its rows: rays are marched.
bool table_holds(const Situation& s) { return s.altitude < 0.3 * s.top_altitude; }

}  // namespace

Model skyview_model() {
  return {
      .name = "skyview",
      .summary =
          "real time: multiple scattering and the observer's sky from tables, any planet and air, ground to space",
      .air = {.zones = 14, .substeps = 1},
      .tables = {{"core.optical_depth", {256, 64}},
                 {"core.sunlight", {256, 64}},
                 {"skyview.multiple_directions", {32, 24 * 64}},
                 {"skyview.multiple_again", {24, 8}},
                 {"skyview.multiple", {32, 24}},
                 {"skyview.ground_directions", {64, 256}},
                 {"skyview.ground_light", {64, 1}},
                 {"skyview.sky_view", dome},
                 {"skyview.aerial", froxels},
                 {"skyview.aerial_class2", froxels}},
      .rays = "skyview.rays",
      .sky_light = "skyview.sky_light",
      .picture = [](const Situation& s) -> std::string_view {
        return table_holds(s) ? "skyview.picture" : "skyview.space_picture";
      },
      .haze = [](const Situation& s) -> std::string_view { return table_holds(s) ? "skyview.haze" : ""; },
      .fields = [](std::string_view argument, const Situation& s) -> Fields {
        if (argument != "dome" && argument != "froxels") return {};
        const Shape& shape = argument == "dome" ? dome : froxels;
        const double horizon =
            -std::sqrt(s.altitude * (2 * s.ground_radius + s.altitude)) / (s.ground_radius + s.altitude);
        return {{"width", {double(shape.width)}},
                {"height", {double(shape.height)}},
                {"depth", {double(shape.depth)}},
                {"horizon", {horizon}}};
      },
  };
}

}  // namespace airlight
