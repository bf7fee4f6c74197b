#include "model/parameters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using Kind = ParameterInfo::Kind;

std::string what(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return '"' + word->substr(0, 60) + '"';
  if (const auto* picture = std::get_if<std::shared_ptr<const ParameterPicture>>(&value))
    return *picture ? "picture \"" + (*picture)->name + '"' : "no picture";
  const auto& numbers = std::get<std::vector<double>>(value);
  return numbers.size() == 1 ? number_text(numbers[0]) : std::to_string(numbers.size()) + " numbers";
}

std::string expected(const ParameterInfo& key) {
  switch (key.kind) {
    case Kind::number:
      return "a number";
    case Kind::whole:
      return "a whole number";
    case Kind::flag:
      return "true or false, 1 or 0";
    case Kind::colour:
      return "three numbers, or one for a grey";
    case Kind::vector:
      return std::to_string(key.size) + " numbers";
    case Kind::list:
      return "1 .. " + std::to_string(key.size) + " numbers";
    case Kind::word:
      return "a word";
    case Kind::picture:
      return "a picture of 2 x 2 pixels or more, finite and not negative";
  }
  return "";
}

bool right_count(const ParameterInfo& key, std::size_t count) {
  switch (key.kind) {
    case Kind::colour:
      return count == 1 || count == 3;
    case Kind::vector:
      return count == key.size;
    case Kind::list:
      return count >= 1 && count <= key.size;
    case Kind::word:
    case Kind::picture:
      return false;
    default:
      return count == 1;
  }
}

bool is_picture(const ParameterValue& value) {
  if (std::holds_alternative<std::string>(value)) return true;  // a name
  const auto* picture = std::get_if<std::shared_ptr<const ParameterPicture>>(&value);
  if (!picture || !*picture || (*picture)->width < 2 || (*picture)->height < 2) return false;
  const std::vector<float>& rgba = (*picture)->rgba;
  return rgba.size() == 4 * std::size_t((*picture)->width) * std::size_t((*picture)->height) &&
         std::ranges::all_of(rgba, [](float v) { return v >= 0 && std::isfinite(v); });
}

}  // namespace

const std::vector<double>& Values::numbers(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::logic_error("no parameter " + std::string(name));
  return std::get<std::vector<double>>(found->second);
}

const std::string& Values::word(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::logic_error("no parameter " + std::string(name));
  return std::get<std::string>(found->second);
}

const ParameterPicture& Values::picture(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::logic_error("no parameter " + std::string(name));
  if (const auto* path = std::get_if<std::string>(&found->second))
    throw InputError(std::string(name) + " = \"" + *path + "\": expected a picture that was read, not its name");
  return *std::get<std::shared_ptr<const ParameterPicture>>(found->second);
}

ParameterValue check_parameter(const ParameterInfo& key, const ParameterValue& value, std::string_view where) {
  const std::string name = std::string(where) + std::string(key.name);
  if (key.kind == Kind::picture) {
    if (!is_picture(value)) throw InputError(name + " = " + what(value) + ": expected " + expected(key));
    return value;
  }
  if (key.kind == Kind::word) {
    const auto* word = std::get_if<std::string>(&value);
    if (!word) throw InputError(name + " = " + what(value) + ": expected " + expected(key));
    if (std::ranges::find(key.words, *word) == key.words.end())
      throw InputError(name + " = " + what(value) + ": unknown" + did_you_mean(*word, key.words));
    return value;
  }
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (!numbers || !right_count(key, numbers->size()))
    throw InputError(name + " = " + what(value) + ": expected " + expected(key));
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const double v = (*numbers)[i];
    const std::string at = name + (numbers->size() > 1 ? '[' + std::to_string(i) + ']' : "") + " = " + number_text(v);
    const double low = key.kind == Kind::flag ? 0 : key.low, high = key.kind == Kind::flag ? 1 : key.high;
    if (!(v >= low && v <= high)) {
      const std::string unit = key.unit == "1" ? "" : ' ' + std::string(key.unit);
      throw InputError(at + ": expected " + number_text(low) + " .. " + number_text(high) + unit);
    }
    if ((key.kind == Kind::whole || key.kind == Kind::flag) && v != std::floor(v))
      throw InputError(at + ": expected " + expected(key));
  }
  if (key.kind == Kind::colour && numbers->size() == 1) return std::vector<double>(3, numbers->front());
  return value;
}

Values check_parameters(std::span<const ParameterInfo> keys, const Parameters& given, std::string_view where) {
  for (const auto& [name, value] : given) {
    if (std::ranges::find(keys, name, &ParameterInfo::name) != keys.end()) continue;
    std::vector<std::string_view> names;
    for (const ParameterInfo& key : keys) names.push_back(key.name);
    throw InputError(std::string(where) + name.substr(0, 60) + ": unknown key" +
                     (names.empty() ? "; this model has no parameters" : did_you_mean(name, names)));
  }
  Parameters values;
  for (const ParameterInfo& key : keys) {
    const auto found = given.find(key.name);
    if (found != given.end())
      values.emplace(key.name, check_parameter(key, found->second, where));
    else if (key.otherwise)
      values.emplace(key.name, check_parameter(key, *key.otherwise, where));
    else if (!key.optional)
      throw InputError(std::string(where) + std::string(key.name) + ": missing");
  }
  return Values(std::move(values));
}

}  // namespace airlight
