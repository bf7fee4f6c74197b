// `reference-single`: converged quadrature of light scattered or reflected once.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "answers.h"
#include "interrupt.h"
#include "reference/single_scattering.h"

namespace airlight::cli {
namespace {

using reference::SingleScattering;

struct Air {
  SingleScattering solver;
  Spectrum::Range range;
};

std::vector<double> one_ray(const SingleScattering& solver, Quantity quantity, const Ray& ray,
                            std::span<const double> wavelengths) {
  if (quantity == Quantity::sun_irradiance) return solver.sun_irradiance(ray, wavelengths);
  reference::RayLight light = solver.along(ray, wavelengths);
  if (quantity == Quantity::transmittance) return light.transmittance;
  if (quantity == Quantity::radiance)
    std::ranges::transform(light.path_radiance, light.ground_radiance, light.path_radiance.begin(), std::plus());
  return light.path_radiance;
}

class SingleScatteringAnswerer : public Answerer {
 public:
  explicit SingleScatteringAnswerer(const Workshop& workshop) : load_(workshop.atmosphere) {}

  bool has(const Asked& asked) const override { return asked.spectral != Quantity::sky_irradiance; }

  std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays) override {
    if (topic.max_order > 1)
      throw InputError(
          fmt::format("max_order = {}: expected 0 or 1, reference-single has one order only", topic.max_order));
    const Air& air = of(topic.atmosphere);
    return as_asked(topic, rays, [&](Quantity quantity, std::span<const double> wavelengths) {
      for (const double wavelength : wavelengths)
        if (!(wavelength >= air.range.first && wavelength <= air.range.last))
          throw InputError(fmt::format("wavelength = {}: expected {} .. {} nm, where the atmosphere has data",
                                       wavelength, air.range.first, air.range.last));
      std::vector<double> values(rays.size() * wavelengths.size());
      tbb::parallel_for(std::size_t(0), rays.size(), [&](std::size_t i) {
        check_interrupt();
        std::ranges::copy(one_ray(air.solver, quantity, rays[i], wavelengths), values.begin() + i * wavelengths.size());
      });
      return values;
    });
  }

  std::string engine() const override { return "quadrature (double)"; }

 private:
  const Air& of(const std::string& name) {
    if (const auto found = airs_.find(name); found != airs_.end()) return found->second;
    if (airs_.size() >= 64) airs_.clear();  // a batch may name any number of files
    const Atmosphere atmosphere = load_(name);
    return airs_.emplace(name, Air{SingleScattering(atmosphere), wavelength_range(atmosphere)}).first->second;
  }

  std::function<Atmosphere(const std::string&)> load_;
  std::map<std::string, Air> airs_;
};

}  // namespace

std::unique_ptr<Answerer> make_single_scattering_answerer(const Workshop& workshop) {
  return std::make_unique<SingleScatteringAnswerer>(workshop);
}

}  // namespace airlight::cli
