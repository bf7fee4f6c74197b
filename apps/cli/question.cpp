#include "question.h"

#include <fmt/core.h>

#include "airlight/error.h"
#include "did_you_mean.h"

namespace airlight::cli {
namespace {

constexpr Asked quantities[] = {
    {"radiance", "W m-2 sr-1 nm-1", Quantity::radiance, false, false, true},
    {"path_radiance", "W m-2 sr-1 nm-1", Quantity::path_radiance, false, false, true},
    {"transmittance", "1", Quantity::transmittance, false, false, true},
    {"sun_irradiance", "W m-2 nm-1", Quantity::sun_irradiance, false, false, false},
    {"sky_irradiance", "W m-2 nm-1", Quantity::sky_irradiance, false, false, false},
    {"luminance", "cd m-2", Quantity::radiance, true, false, true},
    {"sun_illuminance", "lx", Quantity::sun_irradiance, true, false, false},
    {"sky_illuminance", "lx", Quantity::sky_irradiance, true, false, false},
    {"global_illuminance", "lx", Quantity::sky_irradiance, true, true, false},
};

}  // namespace

std::span<const Asked> all_asked() { return quantities; }

const Asked& asked(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Asked& quantity : quantities) {
    if (quantity.name == name) return quantity;
    names.push_back(quantity.name);
  }
  throw InputError(fmt::format("quantity = {}: unknown{}", name.substr(0, 40), did_you_mean(name, names)));
}

}  // namespace airlight::cli
