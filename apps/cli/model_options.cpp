#include "model_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "airlight/error.h"
#include "model/model.h"
#include "number.h"

namespace airlight::cli {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

ParameterValue parse_parameter(std::string_view text) {
  if (text == "true" || text == "false") return std::vector<double>{text == "true" ? 1.0 : 0.0};
  std::vector<double> numbers;
  for (const std::string_view part : comma_separated(text)) {
    const auto value = number(part);
    if (!value) return std::string(text);
    numbers.push_back(*value);
  }
  return numbers;
}

std::string parameter_text(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* picture = std::get_if<std::shared_ptr<const ParameterPicture>>(&value)) return (*picture)->name;
  std::string text;
  for (const double v : std::get<std::vector<double>>(value)) text += fmt::format("{}{}", text.empty() ? "" : ",", v);
  return text;
}

void tell_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
}

void ModelOptions::add_to(const Verb& verb) {
  const char* const group = "Model and engine";
  verb.option("--preset", preset, "values that belong together, of a published system (`airlight models --json`)")
      .group(group)
      .type_name("NAME");
  verb.option("--set", set,
              "a parameter of the model (`airlight models`): a number, numbers with commas, or a word; may be repeated")
      .group(group)
      .one_value_each()
      .type_name("NAME=VALUE");
}

Parameters ModelOptions::parameters() const {
  Parameters values;
  if (!preset.empty()) values["preset"] = preset;
  for (const std::string& text : set) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError(fmt::format("--set = {}: expected NAME=VALUE", text));
    const std::string name = text.substr(0, equals);
    if (!values.emplace(name, parse_parameter(std::string_view(text).substr(equals + 1))).second)
      throw InputError(fmt::format("--set {}: given twice", name));
  }
  return values;
}

std::optional<double> ModelOptions::sun_elevation(std::string_view model) const {
  const auto& presets = model_info(model).presets;
  const auto found = std::ranges::find(presets, preset, &Preset::name);
  return found == presets.end() ? std::nullopt : found->sun_elevation;
}

std::optional<OwnDisplay> own_display(std::string_view name, const Parameters& given) {
  const Model& model = find_model(name);
  if (!model.colours) return {};
  const Values values = model_parameters(model, given, std::string(name) + ".");
  const double gain = values.has("exposure") ? values.number("exposure") : 1;
  // 0 is black: the lowest exposure that may be said.
  const double ev = gain > 0 ? std::clamp(std::log2(gain / model.colours->luminance), -100.0, 100.0) : -100;
  return OwnDisplay{fmt::format("{}", ev), std::string(model.colours->tone)};
}

}  // namespace airlight::cli
