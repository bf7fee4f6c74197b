#include "validate/ledger.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "airlight/error.h"
#include "model/model.h"
#include "optics/colour_difference.h"
#include "reference/monte_carlo.h"
#include "reference/single_scattering.h"

namespace airlight::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

Xyz colour_of(std::span<const double> spectrum, std::span<const Xyz> weights) {
  Xyz colour{};
  for (std::size_t w = 0; w < spectrum.size(); ++w)
    for (std::size_t c = 0; c < 3; ++c) colour[c] += weights[w][c] * spectrum[w];
  return colour;
}

std::string place_of(const YardstickRay& ray) {
  std::string text = fmt::format("ray {}: from {:g} m", ray.id, ray.ray.altitude);
  if (ray.quantity != Quantity::sky_irradiance)
    text += fmt::format(", view {:.1f} degrees high, {:.0f} from the sun's azimuth",
                        90 - std::acos(std::clamp(ray.ray.view[2], -1.0, 1.0)) / degree,
                        std::atan2(ray.ray.view[0], ray.ray.view[1]) / degree);
  if (std::isfinite(ray.ray.distance)) text += fmt::format(", {:g} m long", ray.ray.distance);
  return text + fmt::format(", sun {:g}", ray.sun_elevation);
}

/// One ray's deviations, at each of its wavelengths that counts.
struct Judged {
  const YardstickRay* ray = nullptr;
  bool answered = false;
  std::vector<Deviation> light = {}, transmittance = {};
  std::vector<double> colour = {};  // none: too dim
};

/// Error relative to the truth; nothing inside two standard errors.
Deviation relative(double value, double truth, double standard_error, std::string where) {
  const double error = (value - truth) / truth;
  return {error, std::abs(value - truth) <= 2 * standard_error ? 0 : std::abs(error), std::move(where)};
}

std::string observer_class(double altitude) {
  return altitude < 1000 ? "from the ground" : fmt::format("from {:g} km", altitude / 1000);
}

using Condition = std::pair<std::string, std::function<bool(const YardstickRay&)>>;

/// In the order of the tables: all, by sun, by observer, by kind.
std::vector<Condition> conditions(const std::vector<Judged>& judged, double ground_radius) {
  std::vector<Condition> list{{"all", [](const YardstickRay&) { return true; }},
                              {"sun -2 and higher", [](const YardstickRay& ray) { return ray.sun_elevation >= -2; }}};
  std::map<double, bool, std::greater<>> suns;
  std::map<double, std::string> observers;
  for (const Judged& one : judged) {
    suns[one.ray->sun_elevation] = true;
    observers[one.ray->ray.altitude < 1000 ? 0 : one.ray->ray.altitude] = observer_class(one.ray->ray.altitude);
  }
  for (const auto& [sun, there] : suns)
    list.push_back({fmt::format("sun {:g}", sun), [sun](const YardstickRay& ray) { return ray.sun_elevation == sun; }});
  for (const auto& [altitude, name] : observers)
    list.push_back({name, [name](const YardstickRay& ray) { return observer_class(ray.ray.altitude) == name; }});
  list.push_back({"whole rays", [](const YardstickRay& ray) { return ray.quantity == Quantity::radiance; }});
  list.push_back({"segments", [](const YardstickRay& ray) { return ray.quantity == Quantity::path_radiance; }});
  const auto looks = [ground_radius](LowView where) {
    return [=](const YardstickRay& ray) {
      return ray.quantity != Quantity::sky_irradiance && low_view(ray.ray, ground_radius) == where;
    };
  };
  list.push_back({"just below the horizon", looks(LowView::ground)});
  list.push_back({"past a low limb", looks(LowView::limb)});
  return list;
}

/// The brightest of each sun's rays: what is far dimmer does not count.
class Brightest {
 public:
  void add(const YardstickRay& ray, std::size_t w, double value) {
    double& most = most_[{ray.quantity == Quantity::sky_irradiance, ray.sun_elevation, w}];
    most = std::max(most, value);
  }
  bool counts(const YardstickRay& ray, std::size_t w, double value) const {
    const auto found = most_.find({ray.quantity == Quantity::sky_irradiance, ray.sun_elevation, w});
    return found != most_.end() && value > dimmest_counted * found->second;
  }

 private:
  std::map<std::tuple<bool, double, std::size_t>, double> most_;
};

constexpr std::size_t luminance = 1000;  // in place of a wavelength's index

void judge_light(Judged& judged, const ModelAnswers& answers, const ModelAnswers::Ray& answer,
                 const std::vector<double>& wavelengths, const std::vector<Xyz>& weights, const Brightest& brightest,
                 double scale) {
  const YardstickRay& ray = *judged.ray;
  const std::string where = place_of(ray);
  const Xyz truth = colour_of(ray.value, weights);
  const bool bright = brightest.counts(ray, luminance, truth[1]);
  Xyz colour;
  if (answers.colours) {
    colour = srgb_to_xyz({answer.value[0], answer.value[1], answer.value[2]});
    for (double& c : colour) c *= scale;
    // Walks are shared by all wavelengths, and so are their errors: the luminance's is at most the luminance of them.
    const double error = colour_of(ray.standard_error, weights)[1];
    if (bright) judged.light.push_back(relative(colour[1], truth[1], error, where));
  } else {
    colour = colour_of(answer.value, weights);
    for (std::size_t w = 0; w < wavelengths.size(); ++w)
      if (brightest.counts(ray, w, ray.value[w]))
        judged.light.push_back(relative(answer.value[w], ray.value[w], ray.standard_error[w],
                                        fmt::format("{}, {:g} nm", where, wavelengths[w])));
  }
  if (!bright || !(colour[1] > 0)) return;
  for (const double dimmer = truth[1] / colour[1]; double& c : colour) c *= dimmer;
  judged.colour.push_back(colour_difference(truth, colour));
}

void judge_transmittance(Judged& judged, const ModelAnswers::Ray& answer, const std::vector<double>& wavelengths,
                         const reference::SingleScattering& solver) {
  const std::vector<double> truth = solver.transmittance(judged.ray->ray, wavelengths);
  for (std::size_t w = 0; w < truth.size(); ++w) {
    const double error = answer.transmittance[w] - truth[w];
    judged.transmittance.push_back(
        {error, std::abs(error), fmt::format("{}, {:g} nm", place_of(*judged.ray), wavelengths[w])});
  }
}

/// One row a condition that has rays at all.
void add_quantity(Ledger& ledger, const ModelAnswers& answers, const std::string& quantity,
                  const std::vector<Judged>& judged, double ground_radius, std::vector<Deviation> Judged::*deviations) {
  for (const auto& [name, holds] : conditions(judged, ground_radius)) {
    LedgerRow row{answers.model, answers.atmosphere, quantity, name, {}};
    std::vector<Deviation> all;
    std::vector<double> colours;
    for (const Judged& one : judged) {
      if (!holds(*one.ray)) continue;
      ++row.rays;
      row.unanswered += !one.answered;
      all.insert(all.end(), (one.*deviations).begin(), (one.*deviations).end());
      if (deviations == &Judged::light) colours.insert(colours.end(), one.colour.begin(), one.colour.end());
    }
    if (all.empty()) continue;
    row.figure = figure_of(std::move(all));
    row.colour_median = percentile(colours, 0.5);
    row.colour_p90 = percentile(colours, 0.9);
    ledger.rows.push_back(std::move(row));
  }
}

}  // namespace

double zenith_scale(const Contestant& contestant) {
  const Model& model = find_model(contestant.model);
  const Atmosphere earth = built_in_atmosphere("earth");
  const Ray zenith{.altitude = 0, .view = {0, 0, 1}, .sun = direction(0, 60 * degree)};
  const std::vector<double> wavelengths{390, 440, 480, 520, 560, 610, 670, 740};
  const reference::MonteCarlo solver(earth, wavelengths);
  const auto light = solver.radiance(zenith, {.walks = 1'000'000, .target_error = 0.002});
  const double truth = colour_of(light.total.mean, colour_weights(earth, wavelengths))[1];
  std::array<double, 3> rgb;
  Sky(earth, contestant.model, make_engine("simd"), contestant.parameters)
      .evaluate(Quantity::radiance, {&zenith, 1}, model.colours->wavelengths, rgb);
  return truth / srgb_to_xyz(rgb)[1];
}

void add_rows(Ledger& ledger, const Yardstick& yardstick, const ModelAnswers& answers, double scale) {
  const Atmosphere atmosphere = built_in_atmosphere(answers.atmosphere);
  const std::vector<Xyz> weights = colour_weights(atmosphere, yardstick.wavelengths);
  const reference::SingleScattering solver(atmosphere);
  Brightest brightest;
  for (const ModelAnswers::Ray& answer : answers.rays) {
    const YardstickRay& ray = yardstick.rays[answer.place];
    for (std::size_t w = 0; w < ray.value.size(); ++w) brightest.add(ray, w, ray.value[w]);
    brightest.add(ray, luminance, colour_of(ray.value, weights)[1]);
  }
  std::vector<Judged> rays, skies;  // what a ray shows, and what falls on the ground
  for (const ModelAnswers::Ray& answer : answers.rays) {
    const YardstickRay& ray = yardstick.rays[answer.place];
    Judged& judged = (ray.quantity == Quantity::sky_irradiance ? skies : rays).emplace_back(Judged{&ray});
    judged.answered = !answer.value.empty();
    if (judged.answered) judge_light(judged, answers, answer, yardstick.wavelengths, weights, brightest, scale);
    if (!answers.colours && !answer.transmittance.empty())
      judge_transmittance(judged, answer, yardstick.wavelengths, solver);
  }
  const double radius = atmosphere.planet.ground_radius;
  add_quantity(ledger, answers, answers.colours ? "luminance" : "radiance", rays, radius, &Judged::light);
  add_quantity(ledger, answers, "transmittance", rays, radius, &Judged::transmittance);
  add_quantity(ledger, answers, "sky_irradiance", skies, radius, &Judged::light);
  ledger.costs.push_back({answers.model, answers.atmosphere, answers.cost});
}

const LedgerRow* find_row(const Ledger& ledger, const std::string& model, const std::string& atmosphere,
                          const std::string& quantity, const std::string& condition) {
  const auto found = std::ranges::find_if(ledger.rows, [&](const LedgerRow& row) {
    return row.model == model && row.atmosphere == atmosphere && row.quantity == quantity && row.condition == condition;
  });
  return found == ledger.rows.end() ? nullptr : &*found;
}

}  // namespace airlight::validation
