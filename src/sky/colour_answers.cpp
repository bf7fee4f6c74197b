#include "sky/colour_answers.h"

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

const char* name_of(Quantity quantity) {
  constexpr const char* names[] = {"radiance", "path_radiance", "transmittance", "sun_irradiance", "sky_irradiance"};
  return names[static_cast<int>(quantity)];
}

}  // namespace

std::vector<std::size_t> colour_components(const Model& model, std::span<const double> wavelengths) {
  const std::vector<double>& known = model.colours->wavelengths;
  const std::string who = "model " + std::string(model.name);
  if (known.empty()) {
    if (wavelengths.empty()) return {0, 1, 2};
    throw InputError(who + ": wavelength " + number_text(wavelengths[0]) +
                     " nm: expected none; it answers in relative red, green and blue");
  }
  std::vector<std::size_t> components;
  for (const double w : wavelengths) {
    const auto found = std::ranges::find(known, w);
    if (found == known.end()) {
      std::string list;
      for (const double k : known) list += (list.empty() ? "" : ", ") + number_text(k);
      throw InputError(who + ": wavelength " + number_text(w) + " nm: expected one of " + list +
                       " nm, which it has for red, green and blue");
    }
    components.push_back(std::size_t(found - known.begin()));
  }
  return components;
}

void check_answerable(const Model& model, Quantity quantity, std::span<const Ray> rays) {
  const bool answers = quantity == Quantity::sun_irradiance   ? !model.sun.empty()
                       : quantity == Quantity::sky_irradiance ? !model.sky_light.empty()
                       : quantity == Quantity::transmittance  ? model.segments
                                                              : true;
  if (!answers) throw InputError("model " + std::string(model.name) + " says nothing on " + name_of(quantity));
  if (model.segments || quantity >= Quantity::sun_irradiance) return;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (std::isfinite(rays[i].distance))
      throw InputError("ray " + std::to_string(i) + ": distance = " + number_text(rays[i].distance) +
                       ": expected infinity: model " + std::string(model.name) + " knows the sky alone");
  }
}

}  // namespace airlight
