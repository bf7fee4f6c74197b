#include "optics/csv.h"

#include <charconv>
#include <optional>
#include <utility>

#include "airlight/error.h"

namespace airlight {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::pair<double, double>> row(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto wavelength = number(line.substr(0, comma)), value = number(line.substr(comma + 1));
  if (!wavelength || !value) return std::nullopt;
  return std::pair{*wavelength, *value};
}

}  // namespace

TableSpectrum parse_spectrum_csv(std::string_view text, const std::string& name, Sampling sampling) {
  TableSpectrum table{{}, {}, sampling, name};
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') continue;
    if (const auto values = row(line)) {
      table.wavelengths.push_back(values->first);
      table.values.push_back(values->second);
    } else if (line_number > 1) {  // the first line may be a heading
      throw InputError(name + ":" + std::to_string(line_number) + ": \"" + std::string(line.substr(0, 60)) +
                       "\": expected two numbers, \"wavelength [nm],value\"");
    }
  }
  return table;
}

}  // namespace airlight
