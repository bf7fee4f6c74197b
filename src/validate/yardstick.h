// The rays of data/yardstick and their light, and what falls on the ground: models are judged by them.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "airlight/sky.h"

namespace airlight::validation {

struct YardstickRay {
  std::string id, atmosphere;
  Quantity quantity = Quantity::radiance;
  double sun_elevation = 0;  ///< [degrees]
  Ray ray;
  std::vector<double> value, standard_error;  ///< for each wavelength, in the quantity's unit
};

/// Where light crosses the most air: to the ground less than a degree below the horizon; or past the ground, through a lowest
/// point below both the observer and 3 km. A segment counts where it reaches that point, and whatever its length where it
/// looks to the ground.
enum class LowView { none, ground, limb };
LowView low_view(const Ray& ray, double ground_radius);

struct Yardstick {
  std::vector<double> wavelengths;  ///< [nm] of every ray
  std::vector<YardstickRay> rays;   ///< those that have been solved, in the order in which they were; then irradiances
  std::size_t solved = 0, irradiances = 0;  ///< how many of either
};

/// A line of rays.jsonl or irradiance_rays.jsonl.
Ray read_ray(const nlohmann::ordered_json& line);

/// Reads rays.jsonl and values.jsonl, irradiance_rays.jsonl and irradiance_values.jsonl.
/// @param folder  "data/yardstick"
/// @param first   so many lines of values.jsonl, which grows at its end; none: all
/// @throws InputError naming file and line
Yardstick read_yardstick(const std::string& folder, std::optional<std::size_t> first = {});

/// The same at some of its wavelengths. @param which  indices
Yardstick at_wavelengths(const Yardstick& yardstick, const std::vector<std::size_t>& which);

}  // namespace airlight::validation
