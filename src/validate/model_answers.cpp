#include "validate/model_answers.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "airlight/error.h"
#include "engine/kernel_index.h"
#include "model/model.h"
#include "processor_time.h"

namespace airlight::validation {
namespace {

using Json = nlohmann::ordered_json;
using Rays = std::vector<airlight::Ray>;

/// The numbers that one ray is answered with.
std::size_t width(const Model& model, std::size_t wavelengths) { return model.colours ? 3 : wavelengths; }

/// All at once, or, where the model refuses one of them, each by itself. @returns  none where it refuses
std::vector<std::vector<double>> ask(const Sky& sky, const Model& model, Quantity quantity, const Rays& rays,
                                     const std::vector<double>& wavelengths) {
  const std::size_t W = width(model, wavelengths.size());
  const auto& asked = model.colours ? model.colours->wavelengths : wavelengths;
  std::vector<double> values(rays.size() * W);
  std::vector<std::vector<double>> answers(rays.size());
  try {
    sky.evaluate(quantity, rays, asked, values);
    for (std::size_t i = 0; i < rays.size(); ++i) answers[i].assign(&values[i * W], &values[i * W] + W);
  } catch (const InputError&) {
    if (rays.size() == 1) return answers;
    for (std::size_t i = 0; i < rays.size(); ++i) answers[i] = ask(sky, model, quantity, {rays[i]}, wavelengths)[0];
  }
  return answers;
}

/// What published systems were made for: the sky as it is seen from the ground.
bool made_for_published(const YardstickRay& ray) {
  return ray.quantity == Quantity::radiance && ray.ray.altitude < 1000 && ray.ray.view[2] > 0;
}

/// Of the tables that answering rays needs, through those that make them.
double table_bytes(const Model& model, const Situation& situation) {
  constexpr double texel = 4 * sizeof(float);
  std::vector<TablePass> makers = model.tables;
  if (model.orders) makers.insert(makers.end(), {model.orders->source, model.orders->ground_light});
  std::set<std::string_view> made;
  double bytes = 0;
  const std::function<void(std::string_view)> need = [&](std::string_view reader) {
    for (const ArgumentInfo& table : kernel_pass(reader).tables) {
      for (const TablePass& maker : makers) {
        const auto& outputs = kernel_pass(maker.pass).outputs;
        if (std::ranges::find(outputs, table.name) == outputs.end() || !made.insert(maker.pass).second) continue;
        bytes += texel * double(maker.shape_for(situation).texels()) * double(outputs.size());
        need(maker.pass);
      }
    }
  };
  need(model.rays);
  return bytes;
}

}  // namespace

ModelAnswers ask_model(const Contestant& contestant, const std::string& atmosphere_name, const Yardstick& yardstick,
                       std::shared_ptr<Engine> engine) {
  const Model& model = find_model(contestant.model);
  const Sky sky(built_in_atmosphere(atmosphere_name), contestant.model, std::move(engine), contestant.parameters);
  ModelAnswers answers{contestant.name, atmosphere_name, model.colours.has_value(), {}, {}};
  for (const Quantity quantity : {Quantity::radiance, Quantity::path_radiance, Quantity::sky_irradiance}) {
    Rays rays;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < yardstick.rays.size(); ++i) {
      const YardstickRay& ray = yardstick.rays[i];
      if (ray.atmosphere != atmosphere_name || ray.quantity != quantity) continue;
      if (model.colours && !made_for_published(ray)) continue;
      rays.push_back(ray.ray);
      places.push_back(i);
    }
    if (rays.empty()) continue;
    auto values = ask(sky, model, quantity, rays, yardstick.wavelengths);
    auto transmittance = quantity == Quantity::sky_irradiance
                             ? std::vector<std::vector<double>>(rays.size())
                             : ask(sky, model, Quantity::transmittance, rays, yardstick.wavelengths);
    for (std::size_t i = 0; i < rays.size(); ++i)
      answers.rays.push_back({places[i], std::move(values[i]), std::move(transmittance[i])});
  }
  return answers;
}

Cost cost_of(const Contestant& contestant, const ModelAnswers& answers, const Yardstick& yardstick,
             std::shared_ptr<Engine> engine) {
  Cost cost;
  Rays rays;
  for (const ModelAnswers::Ray& answer : answers.rays) {
    const YardstickRay& ray = yardstick.rays[answer.place];
    if (ray.quantity == Quantity::radiance && !answer.value.empty()) rays.push_back(ray.ray);
  }
  if (rays.empty()) return cost;
  const Model& model = find_model(contestant.model);
  const Atmosphere atmosphere = built_in_atmosphere(answers.atmosphere);
  const Sky sky(atmosphere, contestant.model, std::move(engine), contestant.parameters);
  const Values parameters = model_parameters(model, contestant.parameters, "");
  cost.tables_bytes =
      table_bytes(model, {atmosphere.planet.ground_radius, atmosphere.planet.top_altitude, 0, &parameters});
  const std::vector<double>& all = yardstick.wavelengths;
  const std::vector<double> four(all.begin(), all.begin() + std::ptrdiff_t(std::min<std::size_t>(4, all.size())));
  const auto& asked = model.colours ? model.colours->wavelengths : four;
  const auto time = [&](const Rays& some) {
    std::vector<double> values(some.size() * width(model, four.size()));
    const double begin = processor_time();
    sky.evaluate(Quantity::radiance, some, asked, values);
    return processor_time() - begin;
  };
  // The engine keeps the answers to equal rays, and the sky some tables for each altitude below the ground: neither is what is measured.
  Rays one{rays[0]}, many;
  const double first = time(one);
  one[0].altitude += 1e-3;
  cost.tables_seconds = std::max(first - time(one), 0.0);
  for (std::size_t i = 0; i < 4096; ++i) many.push_back(rays[(i * 37) % rays.size()]);
  double best = std::numeric_limits<double>::infinity();  // other work on the machine can only add
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < many.size(); ++i) many[i].altitude += 1e-3 * double(i + 1) / double(many.size());
    best = std::min(best, time(many));
  }
  cost.ray_nanoseconds = 1e9 * best / double(many.size());
  return cost;
}

Json to_json(const ModelAnswers& answers) {
  Json json{{"model", answers.model}, {"atmosphere", answers.atmosphere}, {"colours", answers.colours}};
  json["cost"] = {answers.cost.tables_seconds, answers.cost.tables_bytes, answers.cost.ray_nanoseconds};
  for (const ModelAnswers::Ray& ray : answers.rays) json["rays"].push_back({ray.place, ray.value, ray.transmittance});
  return json;
}

ModelAnswers model_answers_from(const Json& json) {
  ModelAnswers answers;
  json.at("model").get_to(answers.model);
  json.at("atmosphere").get_to(answers.atmosphere);
  json.at("colours").get_to(answers.colours);
  const Json& cost = json.at("cost");
  answers.cost = {cost.at(0), cost.at(1), cost.at(2)};
  if (json.contains("rays"))
    for (const Json& ray : json["rays"]) answers.rays.push_back({ray.at(0), ray.at(1), ray.at(2)});
  return answers;
}

}  // namespace airlight::validation
