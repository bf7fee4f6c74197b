#include "sky/runs.h"

#include <algorithm>

#include "sky/colour_answers.h"

namespace airlight {

Quad quad_at(std::span<const double> wavelengths, std::size_t w) {
  Quad quad;
  for (std::size_t k = 0; k < 4; ++k) quad[k] = wavelengths[std::min(w + k, wavelengths.size() - 1)];
  return quad;
}

std::size_t answers_for(const Model& model, std::span<const double> wavelengths) {
  return model.colours ? colour_components(model, wavelengths).size() : wavelengths.size();
}

std::vector<Run> runs_for(const Model& model, std::span<const double> wavelengths) {
  std::vector<Run> runs;
  if (model.colours) {
    Run& run = runs.emplace_back();
    for (const std::size_t component : colour_components(model, wavelengths))
      run.parts.push_back({component, run.parts.size()});
    return runs;
  }
  for (std::size_t w = 0; w < wavelengths.size(); w += 4) {
    Run& run = runs.emplace_back(Run{quad_at(wavelengths, w), {}});
    for (std::size_t k = 0; k < 4 && w + k < wavelengths.size(); ++k) run.parts.push_back({k, w + k});
  }
  return runs;
}

}  // namespace airlight
