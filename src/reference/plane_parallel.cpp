#include "reference/plane_parallel.h"

#include <string>

#include "airlight/error.h"
#include "optics/number_text.h"
#include "optics/validate.h"

namespace airlight::reference {
namespace {

void check(double value, double highest, const std::string& key) {
  if (!(value >= 0 && value <= highest))
    throw InputError(key + " = " + number_text(value) + ": expected 0 .. " + number_text(highest));
}

}  // namespace

void validate(const PlaneParallelAir& air) {
  check(air.surface_albedo, 1, "surface_albedo");
  for (std::size_t i = 0; i < air.layers.size(); ++i) {
    const std::string layer = "layers[" + std::to_string(i) + "]";
    check(air.layers[i].absorption_optical_depth, deepest_layer, layer + ".absorption_optical_depth");
    for (std::size_t k = 0; k < air.layers[i].scatterers.size(); ++k) {
      const std::string scatterer = layer + ".scatterers[" + std::to_string(k) + "]";
      check(air.layers[i].scatterers[k].optical_depth, deepest_layer, scatterer + ".optical_depth");
      if (const auto problem = find_problem(air.layers[i].scatterers[k].phase, scatterer + ".phase"))
        throw InputError(problem->message());
    }
  }
}

}  // namespace airlight::reference
