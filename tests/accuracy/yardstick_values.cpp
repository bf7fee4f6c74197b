// Solves the yardstick's rays by Monte Carlo and appends their values, one JSON object a line; the highest sun, whose
// rays cost least, first. What the output already holds is kept: start it again to go on after an interruption. The same
// numbers on any machine.
//
//   yardstick_values RAYS VALUES [FIRST-ID LAST-ID]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "reference/monte_carlo.h"
#include "validate/yardstick.h"

namespace {

using namespace airlight;
using Json = nlohmann::ordered_json;

/// Standard error over value that is asked for; twilight costs more, and so does light from everywhere.
double target_error(double sun_elevation, bool irradiance) {
  if (sun_elevation >= 2) return irradiance ? 0.005 : 0.0015;
  if (sun_elevation >= -2) return 0.005;
  if (sun_elevation >= -6) return 0.01;
  return 0.03;
}

/// Six digits: more than the values have.
std::vector<double> short_numbers(std::vector<double> values) {
  for (double& value : values) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5e", value);
    value = std::strtod(text, nullptr);
  }
  return values;
}

Json solve(const reference::MonteCarlo& solver, const Json& line) {
  const Ray ray = validation::read_ray(line);
  // A ray that looks at nothing, or at a last glimmer, ends here with the error that it has.
  constexpr long most_walks = 400'000'000;
  const std::string quantity = line.at("quantity");
  const reference::Budget budget{
      .walks = most_walks,
      .target_error = target_error(90 - line.at("sun_zenith").get<double>(), quantity == "sky_irradiance")};
  const reference::RandomLight light = quantity == "radiance"        ? solver.radiance(ray, budget)
                                       : quantity == "path_radiance" ? solver.path_radiance(ray, budget)
                                                                     : solver.sky_irradiance(ray, budget);
  return {{"id", line.at("id")},
          {"value", short_numbers(light.total.mean)},
          {"standard_error", short_numbers(light.total.standard_error)},
          {"first_order", short_numbers(light.orders.front().mean)},
          {"walks", light.walks}};
}

int run(int count, char** arguments) {
  if (count != 3 && count != 5) {
    std::fprintf(stderr, "usage: yardstick_values RAYS VALUES [FIRST-ID LAST-ID]\n");
    return 2;
  }
  const int first = count == 5 ? std::atoi(arguments[3]) : 0, last = count == 5 ? std::atoi(arguments[4]) : 1 << 30;
  std::set<std::string> done;
  std::string text;
  for (std::ifstream values(arguments[2]); std::getline(values, text);)
    done.insert(Json::parse(text).at("id").get<std::string>());
  std::ifstream rays(arguments[1]);
  if (!rays) {
    std::fprintf(stderr, "yardstick_values: cannot read %s\n", arguments[1]);
    return 2;
  }
  std::vector<Json> missing;
  while (std::getline(rays, text)) {
    const Json line = Json::parse(text);
    const std::string id = line.at("id");
    const int number = std::stoi(id.substr(id.find_first_of("0123456789")));
    if (!done.contains(id) && number >= first && number <= last) missing.push_back(line);
  }
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Json& a, const Json& b) { return a.at("sun_zenith") < b.at("sun_zenith"); });
  std::ofstream values(arguments[2], std::ios::app);
  std::map<std::string, std::unique_ptr<reference::MonteCarlo>> solvers;
  for (const Json& line : missing) {
    const std::string atmosphere = line.at("atmosphere");
    auto& solver = solvers[atmosphere];
    if (!solver)
      solver = std::make_unique<reference::MonteCarlo>(built_in_atmosphere(atmosphere),
                                                       line.at("wavelengths").get<std::vector<double>>());
    values << solve(*solver, line).dump() << std::endl;
    if (!values) {
      std::fprintf(stderr, "yardstick_values: cannot write %s\n", arguments[2]);
      return 1;
    }
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "yardstick_values: %s\n", error.what());
    return 1;
  }
}
