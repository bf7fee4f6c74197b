#include "answers.h"

#include <algorithm>

#include "options.h"
#include "scenefile/atmosphere_file.h"

namespace airlight::cli {
namespace {

/// The luminous part of every ray's spectrum.
std::vector<double> weighed_by_eye(std::span<const double> spectra, std::span<const double> wavelengths) {
  const std::size_t width = wavelengths.size();
  std::vector<double> values(spectra.size() / width);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = spectrum_to_xyz(wavelengths, spectra.subspan(i * width, width))[1];
  return values;
}

std::vector<double> ask(const Sky& sky, Quantity quantity, std::span<const Ray> rays,
                        std::span<const double> wavelengths, int max_order) {
  std::vector<double> values(rays.size() * wavelengths.size());
  sky.evaluate(quantity, rays, wavelengths, values, max_order);
  return values;
}

}  // namespace

const Sky& Skies::sky(const std::string& atmosphere, const std::string& model) {
  const std::pair key(atmosphere, model);
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  check_model_name(model, "model");
  // A batch may name any number of files; a few kept are enough, since equal lines are answered together.
  if (made_.size() >= 64) made_.clear();
  Sky sky(with_overrides(load_atmosphere(atmosphere), overrides_), model, engine_);
  return made_.emplace(key, std::move(sky)).first->second;
}

std::vector<double> answer(const Sky& sky, const Asked& asked, std::span<const Ray> rays,
                           std::span<const double> wavelengths, int max_order) {
  if (!asked.photometric) return ask(sky, asked.spectral, rays, wavelengths, max_order);
  const std::vector<double> forty = photometric_wavelengths();
  if (wavelengths.empty()) wavelengths = forty;
  std::vector<double> values = weighed_by_eye(ask(sky, asked.spectral, rays, wavelengths, max_order), wavelengths);
  if (asked.with_sun) {
    const auto sun = weighed_by_eye(ask(sky, Quantity::sun_irradiance, rays, wavelengths, max_order), wavelengths);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += sun[i] * std::max(rays[i].sun[2], 0.0);
  }
  return values;
}

}  // namespace airlight::cli
