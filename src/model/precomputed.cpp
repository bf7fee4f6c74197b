// The fast solver that converges: orders of scattering are summed one by one on a lattice of altitudes, Suns and directions, and what whole
// rays gather of them is tabulated; light of the first order is marched along each ray, or tabulated too (docs/models/precomputed.md).
// What it leaves out: polarisation, refraction, shadows of land in the air; peaks of the second order that are sharper than its directions.
#include <cmath>
#include <numbers>

#include "model/model.h"

namespace airlight {
namespace {

/// Angle within which diffuse light that is scattered counts as not scattered [rad]: about a step of the lattice. With 20 degrees light goes
/// too far in deep twilight, with 10 it is lost between directions (measured on the yardstick: Mars and Earth's haze).
constexpr double straight = 16 * std::numbers::pi / 180;

/// Panels of a ray: with 8, one ray in ten thousand is 1 to 2 % off in dusk; 10 cost a ninth more and tell next to nothing more.
constexpr double usual_panels = 9;

struct Sizes {
  int suns, altitudes, rings, sectors;
  int zeniths;  ///< odd: one of them is horizontal, where haze sends most
  int azimuths;
  struct Seen {
    int suns, altitudes, ups, limbs, grounds, azimuths;
  } seen;
};

bool from_tables(const Situation& situation) {
  return situation.parameters && situation.parameters->word("first_order") == "tables";
}

/// `full` is what docs/accuracy.md judges; `draft` answers at once, for tests and for a first look.
Sizes sizes(const Situation& situation) {
  if (situation.parameters && situation.parameters->word("detail") == "draft")
    return {24, 10, 8, 4, 9, 5, {28, 14, 10, 14, 8, 5}};
  // There are two of the tables of what is seen where nothing is marched: smaller ones, so that all stay below 64 MiB.
  const Sizes::Seen seen =
      from_tables(situation) ? Sizes::Seen{64, 32, 20, 26, 12, 10} : Sizes::Seen{64, 40, 20, 40, 14, 12};
  return {64, 24, 24, 10, 21, 10, seen};
}

TablePass sized(std::string_view pass, Shape (*shape)(const Sizes&)) {
  return {.pass = pass, .shape = {}, .sized = [shape](const Situation& s) { return shape(sizes(s)); }};
}

TablePass kept(std::string_view pass, Shape (*shape)(const Situation&)) {
  return {.pass = pass, .shape = {}, .sized = shape, .on_disk = true};
}

Shape shape_of_light(const Sizes& s) { return {s.suns, s.altitudes * s.rings * s.sectors}; }
Shape shape_of_source(const Sizes& s) { return {s.suns, s.altitudes * s.zeniths, s.azimuths}; }

Shape shape_of_weights(const Sizes& s) { return {s.rings * s.sectors, s.altitudes * s.zeniths * s.azimuths}; }
Shape shape_of_seen(const Sizes& s) {
  return {s.seen.suns, s.seen.altitudes * (s.seen.ups + s.seen.limbs + s.seen.grounds), s.seen.azimuths};
}

Fields fields(std::string_view argument, const Situation& situation) {
  if (argument == "march")
    return {{"panels", {situation.parameters ? situation.parameters->number("panels") : usual_panels}}};
  const Sizes s = sizes(situation);
  if (argument == "sight")
    return {{"marched", {from_tables(situation) ? 0.0 : 1.0}},
            {"suns", {double(s.seen.suns)}},
            {"altitudes", {double(s.seen.altitudes)}},
            {"ups", {double(s.seen.ups)}},
            {"limbs", {double(s.seen.limbs)}},
            {"grounds", {double(s.seen.grounds)}},
            {"azimuths", {double(s.seen.azimuths)}}};
  if (argument != "lattice") return {};
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
      .tables = {{"core.optical_depth", {512, 256}},
                 {"core.sunlight", {512, 128}},
                 {"precomputed.layers", {512, 5}},
                 {"precomputed.forward", {4, 1}},
                 {"precomputed.smooth_layers", {512, 5}},
                 {"precomputed.darkness", {2, 2, 2}},
                 {"precomputed.sunlit", {256, 64}},
                 sized("precomputed.peaks",
                       [](const Sizes& s) {
                         return Shape{s.suns, s.altitudes};
                       }),
                 sized("precomputed.weights", shape_of_weights),
                 sized("precomputed.smooth_weights", shape_of_weights),
                 kept("precomputed.seen", [](const Situation& s) { return shape_of_seen(sizes(s)); }),
                 kept("precomputed.seen_peak",
                      [](const Situation& s) {
                        return from_tables(s) ? shape_of_seen(sizes(s)) : Shape{2, 2, 2};  // nothing reads it
                      })},
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
                     {.name = "first_order",
                      .kind = ParameterInfo::Kind::word,
                      .text =
                          "of scattering: marched along each ray, or from tables, several times faster and less exact",
                      .words = {"marched", "tables"},
                      .otherwise = "marched"},
                     {.name = "panels",
                      .kind = ParameterInfo::Kind::whole,
                      .text = "of a ray, with three points each: fewer are faster, more see thin layers",
                      .low = 3,
                      .high = 64,
                      .otherwise = std::vector<double>{usual_panels}}},
  };
}

}  // namespace airlight
