// One line of JSON, read with suspicion: what batches and test vectors are made of.
#pragma once
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "number.h"

namespace airlight::cli {

/// Parses one JSON object. Refused: anything else, bad UTF-8, numbers beyond double's range, a key given twice, nesting
/// deeper than 8, an "id" that is no string, number or null. @throws InputError without the line's own number.
/// @param id  becomes the line's "id", also when the trouble comes after it
nlohmann::json parse_object(std::string_view text, nlohmann::json& id);

/// The keys of an object, taken one by one; what is left over at the end is an error.
class Fields {
 public:
  /// @param where  prefix of the keys in messages, "inputs." or ""
  Fields(const nlohmann::json& object, std::string where) : object_(object), where_(std::move(where)) {}

  /// The value, or null when the key is missing.
  const nlohmann::json* find(const std::string& key);
  /// @throws InputError when the key is missing.
  const nlohmann::json& get(const std::string& key);
  /// A finite number inside the interval. @throws InputError.
  double number(const std::string& key, const Interval& interval);
  double number(const std::string& key, const Interval& interval, double otherwise);
  std::string text(const std::string& key, const std::string& otherwise);
  /// An array of at least one number, each inside the interval. @throws InputError.
  std::vector<double> numbers(const std::string& key, const Interval& interval);
  /// The object under a key. @throws InputError.
  Fields object(const std::string& key);
  /// An array of 1 to `most` objects. @throws InputError.
  std::vector<Fields> objects(const std::string& key, std::size_t most);
  /// @throws InputError naming a key that nobody asked for, with "did you mean".
  void expect_no_more() const;

  /// "inputs.air.g" for messages.
  std::string path(const std::string& key) const { return where_ + key; }

 private:
  const nlohmann::json& object_;
  std::string where_;
  std::set<std::string> known_;
};

/// The start of a value for a message, in one line and of bounded length.
std::string excerpt(const nlohmann::json& value);

/// A line of output: compact, and valid UTF-8 whatever the message holds.
std::string to_line(const nlohmann::ordered_json& object);

/// {"id":…,"error":"…"}
nlohmann::ordered_json error_answer(const nlohmann::json& id, const std::string& message);

}  // namespace airlight::cli
