#include "answers.h"

#include <fmt/core.h>

#include <algorithm>

#include "airlight/error.h"
#include "options.h"

namespace airlight::cli {
namespace {

/// The solvers beside the models of the sky.
struct Solver {
  std::string_view name;
  std::unique_ptr<Answerer> (*make)(const Workshop&);
};
#ifdef AIRLIGHT_WITH_REFERENCE
constexpr Solver solvers[] = {{"reference", make_reference_answerer},
                              {"reference-single", make_single_scattering_answerer},
                              {"plane-parallel", make_plane_parallel_answerer}};
#else
constexpr Solver solvers[] = {{"reference", nullptr}, {"reference-single", nullptr}, {"plane-parallel", nullptr}};
#endif

/// The luminous part of every ray's spectrum.
std::vector<double> weighed_by_eye(std::span<const double> spectra, std::span<const double> wavelengths) {
  const std::size_t width = wavelengths.size();
  std::vector<double> values(spectra.size() / width);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = spectrum_to_xyz(wavelengths, spectra.subspan(i * width, width))[1];
  return values;
}

}  // namespace

std::vector<std::string_view> answering_models() {
  std::vector<std::string_view> names = model_names();
  for (const Solver& solver : solvers) names.push_back(solver.name);
  return names;
}

Answerer& Answerers::named(const std::string& model) {
  if (const auto found = made_.find(model); found != made_.end()) return *found->second;
  check_model_name(model, "model", answering_models());
  const auto solver = std::ranges::find(solvers, model, &Solver::name);
  if (solver == std::end(solvers)) return *(made_[model] = make_sky_answerer(model, workshop_));
  if (!solver->make)
    throw InputError(
        fmt::format("model = {}: not in this program, which was built with AIRLIGHT_WITH_REFERENCE off", model));
  return *(made_[model] = solver->make(workshop_));
}

std::vector<Answer> Answerers::answer(const Topic& topic, std::span<const Ray> rays) {
  Answerer& answerer = named(topic.model);
  if (answerer.has(*topic.asked)) return answerer.answer(topic, rays);
  std::string known;
  for (const Asked& other : all_asked())
    if (answerer.has(other)) known += (known.empty() ? "" : ", ") + std::string(other.name);
  throw InputError(fmt::format("quantity = {}: model {} does not compute it; expected one of {}", topic.asked->name,
                               topic.model, known));
}

std::vector<Answer> as_asked(
    const Topic& topic, std::span<const Ray> rays,
    const std::function<std::vector<double>(Quantity, std::span<const double> wavelengths)>& ask) {
  const Asked& asked = *topic.asked;
  std::vector<double> wavelengths = topic.wavelengths;
  if (asked.photometric && wavelengths.empty()) wavelengths = photometric_wavelengths();
  std::vector<double> values = ask(asked.spectral, wavelengths);
  if (asked.photometric) values = weighed_by_eye(values, wavelengths);
  if (asked.with_sun) {
    const auto sun = weighed_by_eye(ask(Quantity::sun_irradiance, wavelengths), wavelengths);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += sun[i] * std::max(rays[i].sun[2], 0.0);
  }
  const std::size_t width = values.size() / rays.size();
  std::vector<Answer> answers(rays.size());
  for (std::size_t i = 0; i < answers.size(); ++i)
    answers[i].value.assign(values.begin() + i * width, values.begin() + (i + 1) * width);
  return answers;
}

}  // namespace airlight::cli
