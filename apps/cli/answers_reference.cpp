// `reference`: all orders of scattering on a spherical planet, by random walks, with standard errors.
#include <fmt/core.h>

#include <memory>
#include <tuple>

#include "airlight/error.h"
#include "answers.h"
#include "interrupt.h"
#include "reference/monte_carlo.h"
#include "reference/single_scattering.h"
#include "reference_request.h"

namespace airlight::cli {
namespace {

using reference::MonteCarlo;

class ReferenceAnswerer : public Answerer {
 public:
  explicit ReferenceAnswerer(const Workshop& workshop) : load_(workshop.atmosphere) {}

  bool has(const Asked&) const override { return true; }

  std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays) override {
    const ReferenceEffort effort = parse_reference_effort(topic.own);
    std::vector<double> errors;  // of what walks found; the sun's own light has none
    std::vector<long> walks(rays.size(), 0);
    std::vector<double> wavelengths_walked;
    std::vector<Answer> answers =
        as_asked(topic, rays, [&](Quantity quantity, std::span<const double> wavelengths) -> std::vector<double> {
          if (quantity == Quantity::sun_irradiance || quantity == Quantity::transmittance)
            return exact(topic.atmosphere, quantity, rays, wavelengths);
          const MonteCarlo& solver = of(topic, effort.seed, wavelengths);
          wavelengths_walked.assign(wavelengths.begin(), wavelengths.end());
          std::vector<double> values;
          for (std::size_t i = 0; i < rays.size(); ++i) {
            const reference::RandomLight light = walk(solver, quantity, rays[i], effort);
            values.insert(values.end(), light.total.mean.begin(), light.total.mean.end());
            errors.insert(errors.end(), light.total.standard_error.begin(), light.total.standard_error.end());
            walks[i] = light.walks;
          }
          return values;
        });
    const std::size_t width = wavelengths_walked.size();
    for (std::size_t i = 0; i < rays.size() && width > 0; ++i) {
      const auto of_ray = std::span(errors).subspan(i * width, width);
      // Walks are shared by all wavelengths, and so are their errors: a luminance's is at most the luminance of them.
      if (topic.asked->photometric)
        answers[i].more["standard_error"] = {spectrum_to_xyz(wavelengths_walked, of_ray)[1]};
      else
        answers[i].more["standard_error"] = std::vector<double>(of_ray.begin(), of_ray.end());
      answers[i].more["samples"] = walks[i];
    }
    return answers;
  }

  std::string engine() const override { return "Monte Carlo (double)"; }

 private:
  static reference::RandomLight walk(const MonteCarlo& solver, Quantity quantity, const Ray& ray,
                                     const ReferenceEffort& effort) {
    const reference::Budget budget{
        .walks = effort.samples, .target_error = effort.target_error, .between = check_interrupt};
    if (quantity == Quantity::radiance) return solver.radiance(ray, budget);
    if (quantity == Quantity::path_radiance) return solver.path_radiance(ray, budget);
    return solver.sky_irradiance(ray, budget);
  }

  std::vector<double> exact(const std::string& atmosphere, Quantity quantity, std::span<const Ray> rays,
                            std::span<const double> wavelengths) const {
    const Atmosphere air = loaded(atmosphere, wavelengths);
    const reference::SingleScattering solver(air);
    std::vector<double> values;
    for (const Ray& ray : rays) {
      check_interrupt();
      const auto light = quantity == Quantity::transmittance ? solver.transmittance(ray, wavelengths)
                                                             : solver.sun_irradiance(ray, wavelengths);
      values.insert(values.end(), light.begin(), light.end());
    }
    return values;
  }

  Atmosphere loaded(const std::string& name, std::span<const double> wavelengths) const {
    Atmosphere atmosphere = load_(name);
    const Spectrum::Range range = wavelength_range(atmosphere);
    for (const double wavelength : wavelengths)
      if (!(wavelength >= range.first && wavelength <= range.last))
        throw InputError(fmt::format("wavelength = {}: expected {} .. {} nm, where the atmosphere has data", wavelength,
                                     range.first, range.last));
    return atmosphere;
  }

  const MonteCarlo& of(const Topic& topic, std::uint64_t seed, std::span<const double> wavelengths) {
    const Key key{topic.atmosphere, {wavelengths.begin(), wavelengths.end()}, topic.max_order, seed};
    if (const auto found = solvers_.find(key); found != solvers_.end()) return *found->second;
    if (solvers_.size() >= 16) solvers_.clear();  // a batch may name any number of files
    return *(solvers_[key] = std::make_unique<MonteCarlo>(
                 loaded(topic.atmosphere, wavelengths), wavelengths,
                 reference::MonteCarloSettings{.seed = seed, .max_order = topic.max_order}));
  }

  using Key = std::tuple<std::string, std::vector<double>, int, std::uint64_t>;
  std::function<Atmosphere(const std::string&)> load_;
  std::map<Key, std::unique_ptr<MonteCarlo>> solvers_;
};

}  // namespace

std::unique_ptr<Answerer> make_reference_answerer(const Workshop& workshop) {
  return std::make_unique<ReferenceAnswerer>(workshop);
}

}  // namespace airlight::cli
