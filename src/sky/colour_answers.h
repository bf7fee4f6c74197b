// What a published system that answers in red, green and blue may be asked.
#pragma once
#include <span>
#include <vector>

#include "airlight/sky.h"
#include "model/model.h"

namespace airlight {

/// Which of red, green and blue (0, 1, 2) answers each of the wavelengths asked; all three where the model has none and none were asked.
/// @throws InputError for any other wavelength
std::vector<std::size_t> colour_components(const Model& model, std::span<const double> wavelengths);

/// @throws InputError where the system says nothing on a quantity, or on rays that end in the air
void check_answerable(const Model& model, Quantity quantity, std::span<const Ray> rays);

}  // namespace airlight
