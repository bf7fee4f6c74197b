// The fast solver that converges: light of the first order is marched along each ray, the other orders come from a lattice of
// altitudes, Suns and directions, summed one by one (docs/models/precomputed.md). What it leaves out: polarisation, refraction, shadows
// of land in the air; peaks of the second order that are sharper than its directions.
#include <cmath>
#include <numbers>

#include "model/model.h"

namespace airlight {
namespace {

/// Angle within which diffuse light that is scattered counts as not scattered [rad]: about a step of the lattice. With 20 degrees light goes
/// too far in deep twilight, with 10 it is lost between directions (measured on the yardstick: Mars and Earth's haze).
constexpr double straight = 16 * std::numbers::pi / 180;

struct Sizes {
  int suns, altitudes, rings, sectors, zeniths, azimuths;
};

/// `full` is what docs/accuracy.md judges; `draft` answers at once, for tests and for a first look.
Sizes sizes(const Situation& situation) {
  if (situation.parameters && situation.parameters->word("detail") == "draft") return {20, 10, 8, 4, 8, 5};
  return {64, 24, 24, 10, 20, 10};
}

TablePass sized(std::string_view pass, Shape (*shape)(const Sizes&)) {
  return {.pass = pass, .shape = {}, .sized = [shape](const Situation& s) { return shape(sizes(s)); }};
}

Shape shape_of_light(const Sizes& s) { return {s.suns, s.altitudes * s.rings * s.sectors}; }
Shape shape_of_source(const Sizes& s) { return {s.suns, s.altitudes * s.zeniths, s.azimuths}; }

Shape shape_of_weights(const Sizes& s) { return {s.rings * s.sectors, s.altitudes * s.zeniths * s.azimuths}; }

Fields fields(std::string_view argument, const Situation& situation) {
  if (argument == "march") return {{"panels", {situation.parameters ? situation.parameters->number("panels") : 16.0}}};
  if (argument != "lattice") return {};
  const Sizes s = sizes(situation);
  return {{"suns", {double(s.suns)}},
          {"altitudes", {double(s.altitudes)}},
          {"rings", {double(s.rings)}},
          {"sectors", {double(s.sectors)}},
          {"zeniths", {double(s.zeniths)}},
          {"azimuths", {double(s.azimuths)}},
          {"panels", {8}},
          {"straight", {std::sin(straight / 2)}}};
}

}  // namespace

Model precomputed_model() {
  return {
      .name = "precomputed",
      .summary =
          "all orders of scattering, converged: the first marched, the others from tables; any planet, ground to space",
      // A horizontal ray has an optical depth of 10 at 390 nm: with 24 zones its steps cost 5 %, with 44 half of that.
      .air = {.zones = 44, .substeps = 1},
      .tables = {{"core.optical_depth", {512, 128}},
                 {"core.sunlight", {512, 128}},
                 {"precomputed.layers", {512, 5}},
                 {"precomputed.forward", {4, 1}},
                 {"precomputed.smooth_layers", {512, 5}},
                 {"precomputed.darkness", {2, 2, 2}},
                 sized("precomputed.peaks",
                       [](const Sizes& s) {
                         return Shape{s.suns, s.altitudes};
                       }),
                 sized("precomputed.weights", shape_of_weights),
                 sized("precomputed.smooth_weights", shape_of_weights)},
      .rays = "precomputed.rays",
      .transmittance = "precomputed.transmittance",
      .sky_light = "precomputed.sky_light",
      .picture = [](const Situation&) -> std::string_view { return "precomputed.picture"; },
      .haze = [](const Situation&) -> std::string_view { return ""; },
      .fields = fields,
      .orders = OrderPasses{.first_light = sized("precomputed.first_light", shape_of_light),
                            .next_light = sized("precomputed.next_light", shape_of_light),
                            .next_source = sized("precomputed.smooth_source", shape_of_source),
                            .source = sized("precomputed.source", shape_of_source),
                            .ground_light = sized("precomputed.ground_light",
                                                  [](const Sizes& s) {
                                                    return Shape{s.suns, 1};
                                                  }),
                            .sum = "precomputed.sum",
                            .closed = "precomputed.closed"},
      .greatest_optical_depth = 2,
      .parameters = {{.name = "detail",
                      .kind = ParameterInfo::Kind::word,
                      .text = "of the tables: draft answers at once, with a few percent of error",
                      .words = {"full", "draft"},
                      .otherwise = "full"},
                     {.name = "panels",
                      .kind = ParameterInfo::Kind::whole,
                      .text = "of a ray, with three points each: fewer are faster, more see thin layers",
                      .low = 3,
                      .high = 64,
                      .otherwise = std::vector<double>{16}}},
  };
}

}  // namespace airlight
