#include "json_phase.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/validate.h"

namespace airlight::cli {
namespace {

constexpr std::array<std::string_view, 6> types{
    "rayleigh", "isotropic", "henyey-greenstein", "cornette-shanks", "double-henyey-greenstein", "table"};
constexpr Interval any_number{-1e9, 1e9, ""};  // the phase function itself knows better

TablePhase read_table(Fields& fields) {
  TablePhase table{fields.numbers("angles", any_number), fields.numbers("values", any_number)};
  if (table.angles.back() == 180)
    for (double& angle : table.angles) angle *= degree;
  const double integral = table.angles.size() == table.values.size() ? sphere_integral(table) : 0;
  if (!(integral > 0) || !std::isfinite(integral))
    throw InputError(fields.path("values") + ": expected as many values as angles, none negative and not all 0");
  for (double& value : table.values) value /= integral;
  return table;
}

Phase read_fields(Fields& fields) {
  fields.get("type");
  const std::string type = fields.text("type", "");
  if (type == "rayleigh") return RayleighPhase{fields.number("depolarisation", any_number, 0)};
  if (type == "isotropic") return IsotropicPhase{};
  if (type == "henyey-greenstein") return HenyeyGreensteinPhase{fields.number("g", any_number)};
  if (type == "cornette-shanks") return CornetteShanksPhase{fields.number("g", any_number)};
  if (type == "double-henyey-greenstein")
    return DoubleHenyeyGreensteinPhase{fields.number("g1", any_number), fields.number("g2", any_number),
                                       fields.number("weight", any_number)};
  if (type == "table") return read_table(fields);
  throw InputError(fmt::format("{} = {}: unknown phase function{}", fields.path("type"), type.substr(0, 40),
                               did_you_mean(type, types)));
}

}  // namespace

Phase read_phase(Fields& object) {
  Fields fields = object.object("phase");
  Phase phase = read_fields(fields);
  fields.expect_no_more();
  if (const auto problem = find_problem(phase, object.path("phase"))) throw InputError(problem->message());
  return phase;
}

}  // namespace airlight::cli
