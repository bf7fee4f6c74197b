#include "reference_request.h"

#include <cmath>

#include "airlight/error.h"

namespace airlight::cli {
namespace {

constexpr double most_samples = 1e9;

/// 0 where the key is missing.
double whole(Fields& fields, const std::string& key, const Interval& interval) {
  if (const auto* const value = fields.find(key); !value || value->is_null()) return 0;
  const double number = fields.number(key, interval);
  if (number != std::floor(number))
    throw InputError(fields.path(key) + " = " + excerpt(fields.get(key)) + ": expected a whole number");
  return number;
}

}  // namespace

ReferenceEffort read_reference_effort(Fields& fields) {
  ReferenceEffort effort;
  effort.samples = long(whole(fields, "samples", {1, most_samples, ""}));
  if (const auto* const value = fields.find("target_error"); value && !value->is_null())
    effort.target_error = fields.number("target_error", {1e-5, 1, ""});
  effort.seed = std::uint64_t(whole(fields, "seed", {0, 4294967295.0, ""}));
  if (effort.seed == 0) effort.seed = 1;
  // Light of which hardly any walk knows would be sought for ever.
  constexpr long patience = 2'000'000;
  if (effort.samples == 0) {
    effort.samples = patience;
    if (effort.target_error == 0) effort.target_error = 0.01;
  }
  return effort;
}

std::string reference_effort_text(Fields& fields) {
  read_reference_effort(fields);
  nlohmann::json own = nlohmann::json::object();
  for (const char* key : {"samples", "target_error", "seed"})
    if (const auto* const value = fields.find(key)) own[key] = *value;
  return own.dump();
}

ReferenceEffort parse_reference_effort(const std::string& text) {
  const nlohmann::json own = text.empty() ? nlohmann::json::object() : nlohmann::json::parse(text);
  Fields fields(own, "");
  return read_reference_effort(fields);
}

}  // namespace airlight::cli
