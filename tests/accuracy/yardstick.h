// The rays of data/yardstick.
#pragma once
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "airlight/sky.h"

namespace airlight::accuracy {

/// A line of rays.jsonl.
inline Ray read_ray(const nlohmann::ordered_json& line) {
  constexpr double degree = std::numbers::pi / 180;
  const auto towards = [&](const std::string& what) {
    const double zenith = line.at(what + "_zenith"), azimuth = line.at(what + "_azimuth");
    return direction(azimuth * degree, (90 - zenith) * degree);
  };
  Ray ray{.altitude = line.at("altitude"), .view = towards("view"), .sun = towards("sun")};
  if (line.contains("distance")) ray.distance = line.at("distance");
  return ray;
}

}  // namespace airlight::accuracy
