#include "batch_request.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "airlight/error.h"
#include "batch_plane_parallel.h"
#include "json_line.h"
#include "model_of_sky.h"
#include "number.h"
#include "reference_request.h"

namespace airlight::cli {
namespace {

using nlohmann::json;

constexpr Interval zenith_range{0, 180, "degrees"}, azimuth_range{-360, 360, "degrees"};

/// Unit vector from "view_zenith" and "view_azimuth" [degrees], or "sun_...".
Direction read_direction(Fields& fields, const std::string& prefix, bool needed) {
  const std::string zenith_key = prefix + "_zenith";
  const double zenith = needed ? fields.number(zenith_key, zenith_range) : fields.number(zenith_key, zenith_range, 0);
  const double azimuth = fields.number(prefix + "_azimuth", azimuth_range, 0);
  return direction(azimuth * degree, (90 - zenith) * degree);
}

std::vector<double> read_wavelengths(Fields& fields, bool needed) {
  const json* const list = needed ? &fields.get("wavelengths") : fields.find("wavelengths");
  if (!list || (list->is_null() && !needed)) return {};
  if (!list->is_array() || list->empty() || list->size() > most_wavelengths)
    throw InputError(
        fmt::format("wavelengths = {}: expected an array of 1 .. {} numbers in nm", excerpt(*list), most_wavelengths));
  std::vector<double> wavelengths;
  for (const json& value : *list) {
    const std::string name = fmt::format("wavelengths[{}]", wavelengths.size());
    if (!value.is_number())
      throw InputError(fmt::format("{} = {}: {}", name, excerpt(value), expected(any_wavelength)));
    check_number(value.get<double>(), name, any_wavelength);
    wavelengths.push_back(value.get<double>());
  }
  return wavelengths;
}

int read_order(Fields& fields) {
  constexpr int highest = 1000;
  const json* const order = fields.find("max_order");
  if (!order || order->is_null()) return 0;
  if (!order->is_number_integer() || *order < 0 || *order > highest)
    throw InputError(fmt::format("max_order = {}: expected a whole number 0 (all) .. {}", excerpt(*order), highest));
  return order->get<int>();
}

void expect_increasing(const std::vector<double>& wavelengths) {
  if (wavelengths.size() < 2) throw InputError("wavelengths: a photometric quantity needs at least 2");
  for (std::size_t i = 1; i < wavelengths.size(); ++i)
    if (wavelengths[i] <= wavelengths[i - 1])
      throw InputError(
          fmt::format("wavelengths[{}] = {}: expected more than {} nm, the one before (a photometric quantity "
                      "integrates over them)",
                      i, wavelengths[i], wavelengths[i - 1]));
}

/// The keys of models that have an atmosphere.
void read_in_air(Fields& fields, Topic& topic, Ray& ray) {
  topic.atmosphere = fields.text("atmosphere", topic.atmosphere);
  ray.altitude = fields.number("altitude", {lowest_altitude, highest_altitude, "m"}, 0);
  ray.view = read_direction(fields, "view", topic.asked->along_view);
  ray.sun = read_direction(fields, "sun", topic.asked->spectral != Quantity::transmittance);
  if (const json* const distance = fields.find("distance"); distance && !distance->is_null())
    ray.distance = fields.number("distance", {0, highest_altitude, "m (or null)"});
  const std::optional<ModelInfo> info = model_of_sky(topic.model);
  const ColourModel* const colours = info && !topic.asked->photometric ? info->colours : nullptr;
  topic.wavelengths = read_wavelengths(fields, !topic.asked->photometric && !colours);
  if (colours && topic.wavelengths.empty()) topic.wavelengths = colours->wavelengths;
  topic.max_order = read_order(fields);
  if (topic.asked->photometric && !topic.wavelengths.empty()) expect_increasing(topic.wavelengths);
}

void read_in_layers(Fields& fields, Topic& topic, Ray& ray) {
  topic.atmosphere.clear();
  topic.own = plane_parallel_text(fields);
  ray.view = read_direction(fields, "view", topic.asked->along_view);
  ray.sun = read_direction(fields, "sun", true);
  if (const double zenith = fields.number("sun_zenith", zenith_range); zenith >= 90)
    throw InputError(
        fmt::format("sun_zenith = {}: expected 0 up to less than 90 degrees (flat air has no light "
                    "when the sun is down)",
                    zenith));
}

void read(const json& object, BatchRequest& request) {
  Fields fields(object, "");
  fields.find("id");
  Topic& topic = request.topic;
  topic.model = fields.text("model", topic.model);
  fields.get("quantity");
  topic.asked = &asked(fields.text("quantity", ""));
  if (topic.model == "plane-parallel")
    read_in_layers(fields, topic, request.ray);
  else
    read_in_air(fields, topic, request.ray);
  if (topic.model == "reference") topic.own = reference_effort_text(fields);
  fields.expect_no_more();
}

}  // namespace

BatchRequest parse_batch_request(std::string_view text, const Topic& otherwise) {
  BatchRequest request{nullptr, otherwise, {}, {}};
  try {
    read(parse_object(text, request.id), request);
  } catch (const InputError& error) {
    request.error = error.what();
  }
  return request;
}

}  // namespace airlight::cli
