// A question at W wavelengths as runs of the passes, which answer four channels each.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "model/model.h"
#include "optics/bake.h"

namespace airlight {

/// One run: its wavelengths, and which component of its texels answers which of those asked.
struct Run {
  Quad quad{};
  std::vector<std::pair<std::size_t, std::size_t>> parts;  ///< component, index of the wavelength
};

/// Four wavelengths at a time; one run of red, green and blue for a model that answers in colours.
/// @throws InputError for wavelengths that such a model does not answer at
std::vector<Run> runs_for(const Model& model, std::span<const double> wavelengths);

/// How many numbers answer one question.
std::size_t answers_for(const Model& model, std::span<const double> wavelengths);

/// Four wavelengths from the w-th on; the last stands for those that are missing.
Quad quad_at(std::span<const double> wavelengths, std::size_t w);

}  // namespace airlight
