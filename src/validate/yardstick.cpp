#include "validate/yardstick.h"

#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "airlight/error.h"

namespace airlight::validation {
namespace {

using Json = nlohmann::ordered_json;
constexpr double degree = std::numbers::pi / 180;

Quantity quantity_named(const std::string& name) {
  if (name == "radiance") return Quantity::radiance;
  if (name == "path_radiance") return Quantity::path_radiance;
  if (name == "sky_irradiance") return Quantity::sky_irradiance;
  throw InputError("quantity = " + name + ": expected radiance, path_radiance or sky_irradiance");
}

/// @param take  is given each line; false ends
void read_lines(const std::string& path, const std::function<bool(const Json&)>& take) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path));
  int number = 0;
  for (std::string text; std::getline(file, text);) {
    ++number;
    try {
      if (!take(Json::parse(text))) return;
    } catch (const std::exception& error) {
      throw InputError(fmt::format("{}:{}: {}", path, number, error.what()));
    }
  }
}

YardstickRay question(const Json& line) {
  YardstickRay ray;
  ray.id = line.at("id");
  ray.atmosphere = line.at("atmosphere");
  ray.quantity = quantity_named(line.at("quantity"));
  ray.sun_elevation = 90 - line.at("sun_zenith").get<double>();
  ray.ray = read_ray(line);
  return ray;
}

/// Adds what has been solved of one file's questions. @param first  so many of them; none: all
void add_solved(Yardstick& yardstick, const std::string& questions, const std::string& values,
                std::optional<std::size_t> first) {
  std::map<std::string, YardstickRay> asked;
  read_lines(questions, [&](const Json& line) {
    const auto wavelengths = line.at("wavelengths").get<std::vector<double>>();
    if (yardstick.wavelengths.empty()) yardstick.wavelengths = wavelengths;
    if (wavelengths != yardstick.wavelengths || wavelengths.empty())
      throw InputError("wavelengths: expected those of the first line");
    asked[line.at("id")] = question(line);
    return true;
  });
  const std::size_t before = yardstick.rays.size();
  read_lines(values, [&](const Json& line) {
    if (first && yardstick.rays.size() == before + *first) return false;
    const std::string id = line.at("id");
    if (!asked.contains(id)) throw InputError(fmt::format("id = {}: {} has no such line", id, questions));
    YardstickRay ray = asked[id];
    line.at("value").get_to(ray.value);
    line.at("standard_error").get_to(ray.standard_error);
    if (ray.value.size() != yardstick.wavelengths.size() || ray.standard_error.size() != ray.value.size())
      throw InputError(fmt::format("expected {} values, one for each wavelength", yardstick.wavelengths.size()));
    yardstick.rays.push_back(std::move(ray));
    return true;
  });
}

}  // namespace

Ray read_ray(const Json& line) {
  const auto towards = [&](const std::string& what) {
    const double zenith = line.at(what + "_zenith"), azimuth = line.at(what + "_azimuth");
    return direction(azimuth * degree, (90 - zenith) * degree);
  };
  Ray ray{.altitude = line.at("altitude"), .view = towards("view"), .sun = towards("sun")};
  if (line.contains("distance")) ray.distance = line.at("distance");
  return ray;
}

LowView low_view(const Ray& ray, double ground_radius) {
  constexpr double just_below = 1 * degree, low = 3e3;
  const double down = -ray.view[2], radius = ground_radius + ray.altitude;
  if (!(down > 0 && ray.altitude > 0)) return LowView::none;
  const double lowest = radius * std::sqrt((1 - down) * (1 + down)) - ground_radius;
  if (lowest > 0) return lowest < low && ray.distance >= radius * down ? LowView::limb : LowView::none;
  return std::asin(std::min(down, 1.0)) - std::acos(ground_radius / radius) < just_below ? LowView::ground
                                                                                         : LowView::none;
}

Yardstick read_yardstick(const std::string& folder, std::optional<std::size_t> first) {
  Yardstick yardstick;
  add_solved(yardstick, folder + "/rays.jsonl", folder + "/values.jsonl", first);
  yardstick.solved = yardstick.rays.size();
  add_solved(yardstick, folder + "/irradiance_rays.jsonl", folder + "/irradiance_values.jsonl", {});
  yardstick.irradiances = yardstick.rays.size() - yardstick.solved;
  return yardstick;
}

Yardstick at_wavelengths(const Yardstick& yardstick, const std::vector<std::size_t>& which) {
  const auto chosen = [&](const std::vector<double>& values) {
    std::vector<double> some;
    for (const std::size_t w : which) some.push_back(values.at(w));
    return some;
  };
  Yardstick part = yardstick;
  part.wavelengths = chosen(yardstick.wavelengths);
  for (YardstickRay& ray : part.rays) {
    ray.value = chosen(ray.value);
    ray.standard_error = chosen(ray.standard_error);
  }
  return part;
}

}  // namespace airlight::validation
