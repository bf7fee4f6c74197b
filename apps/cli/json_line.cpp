#include "json_line.h"

#include <fmt/core.h>

#include "airlight/error.h"
#include "did_you_mean.h"

namespace airlight::cli {

using nlohmann::json;

namespace {

constexpr std::size_t longest_excerpt = 40;

/// "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error ..." without the library's own
/// address and its line, which is always the first.
std::string plain_message(const json::exception& error) {
  std::string_view what = error.what();
  for (const std::string_view end : {"] ", "at line 1, "})
    if (const std::size_t found = what.find(end); found != what.npos) what.remove_prefix(found + end.size());
  return "not JSON: " + std::string(what);
}

}  // namespace

json parse_object(std::string_view text, json& id) {
  static constexpr int deepest = 8;
  // The parser's callback is the only place that sees a key given twice (the object silently keeps the last value), and
  // the id of a line that breaks further on.
  std::vector<std::set<std::string>> keys;
  bool id_follows = false;
  const auto watch = [&](int depth, json::parse_event_t event, json& value) {
    if (depth > deepest) throw InputError(fmt::format("nested deeper than {}", deepest));
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::value && id_follows && (value.is_string() || value.is_number())) id = value;
    id_follows = false;
    if (event == json::parse_event_t::key) {
      const auto& key = value.get_ref<const std::string&>();
      if (!keys.back().insert(key).second)
        throw InputError(fmt::format("{}: given twice", key.substr(0, longest_excerpt)));
      id_follows = keys.size() == 1 && key == "id";
    }
    return true;
  };
  try {
    json object = json::parse(text, watch);
    if (!object.is_object()) throw InputError("expected a JSON object, {\"id\":…}");
    if (const auto given = object.find("id"); given != object.end() && *given != id)
      throw InputError(fmt::format("id = {}: expected a string or a number", excerpt(*given)));
    return object;
  } catch (const json::exception& error) {
    throw InputError(plain_message(error));
  }
}

const json* Fields::find(const std::string& key) {
  known_.insert(key);
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

const json& Fields::get(const std::string& key) {
  if (const json* const found = find(key)) return *found;
  throw InputError(path(key) + ": missing");
}

double Fields::number(const std::string& key, const Interval& interval) {
  const json& value = get(key);
  if (!value.is_number()) throw InputError(fmt::format("{} = {}: {}", path(key), excerpt(value), expected(interval)));
  const double number = value.get<double>();
  check_number(number, path(key), interval);
  return number;
}

double Fields::number(const std::string& key, const Interval& interval, double otherwise) {
  return find(key) ? number(key, interval) : otherwise;
}

std::string Fields::text(const std::string& key, const std::string& otherwise) {
  const json* const value = find(key);
  if (!value) return otherwise;
  if (!value->is_string()) throw InputError(fmt::format("{} = {}: expected a string", path(key), excerpt(*value)));
  return value->get<std::string>();
}

std::vector<double> Fields::numbers(const std::string& key, const Interval& interval) {
  const json& list = get(key);
  if (!list.is_array() || list.empty())
    throw InputError(fmt::format("{} = {}: expected an array of numbers", path(key), excerpt(list)));
  std::vector<double> values;
  for (const json& value : list) {
    const std::string name = fmt::format("{}[{}]", path(key), values.size());
    if (!value.is_number()) throw InputError(fmt::format("{} = {}: {}", name, excerpt(value), expected(interval)));
    check_number(value.get<double>(), name, interval);
    values.push_back(value.get<double>());
  }
  return values;
}

Fields Fields::object(const std::string& key) {
  const json& value = get(key);
  if (!value.is_object()) throw InputError(fmt::format("{} = {}: expected an object", path(key), excerpt(value)));
  return {value, path(key) + "."};
}

std::vector<Fields> Fields::objects(const std::string& key, std::size_t most) {
  const json& list = get(key);
  if (!list.is_array() || list.empty() || list.size() > most)
    throw InputError(fmt::format("{} = {}: expected an array of 1 .. {} objects", path(key), excerpt(list), most));
  std::vector<Fields> all;
  for (const json& value : list) {
    const std::string name = fmt::format("{}[{}]", path(key), all.size());
    if (!value.is_object()) throw InputError(fmt::format("{} = {}: expected an object", name, excerpt(value)));
    all.push_back({value, name + "."});
  }
  return all;
}

void Fields::expect_no_more() const {
  for (const auto& [key, value] : object_.items())
    if (!known_.contains(key))
      throw InputError(
          fmt::format("{}: unknown key{}", path(key.substr(0, longest_excerpt)), did_you_mean(key, known_)));
}

std::string excerpt(const json& value) {
  if (value.is_structured()) return value.is_array() ? "an array" : "an object";
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= longest_excerpt ? text : text.substr(0, longest_excerpt) + "...";
}

std::string to_line(const nlohmann::ordered_json& object) {
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

nlohmann::ordered_json error_answer(const json& id, const std::string& message) {
  return {{"id", id}, {"error", message}};
}

}  // namespace airlight::cli
