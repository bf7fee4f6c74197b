#include "optics/csv.h"

#include <algorithm>
#include <charconv>
#include <optional>

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

std::vector<std::optional<double>> cells(std::string_view line) {
  std::vector<std::optional<double>> numbers;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    numbers.push_back(number(line.substr(begin, comma - begin)));
    if (comma == line.npos) return numbers;
    begin = comma + 1;
  }
}

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& name, std::string_view columns) {
  const auto count = std::size_t(std::ranges::count(columns, ',')) + 1;
  const std::string expected = std::to_string(count) + " numbers, \"" + std::string(columns) + '"';
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark, as spreadsheets write it
  std::vector<CsvRow> rows;
  bool may_be_heading = true;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::optional<double>> values = cells(line);
    const bool heading = may_be_heading && !values.front();
    may_be_heading = false;
    if (heading) continue;
    CsvRow row{number, {}};
    for (const auto& value : values)
      if (value) row.values.push_back(*value);
    if (values.size() != count || row.values.size() != count)
      throw InputError(name + ":" + std::to_string(number) + ": \"" + std::string(line.substr(0, 60)) +
                       "\": expected " + expected);
    rows.push_back(std::move(row));
  }
  if (rows.empty()) throw InputError(name + ": holds no rows; expected lines of " + expected);
  return rows;
}

TableSpectrum parse_spectrum_csv(std::string_view text, const std::string& name, Sampling sampling) {
  TableSpectrum table{{}, {}, sampling, name};
  for (const CsvRow& row : parse_csv(text, name, "wavelength [nm],value")) {
    table.wavelengths.push_back(row.values[0]);
    table.values.push_back(row.values[1]);
  }
  return table;
}

}  // namespace airlight
