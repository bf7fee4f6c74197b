#include "number.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "airlight/error.h"

namespace airlight::cli {

std::vector<std::string_view> comma_separated(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return pieces;
}

std::string expected(const Interval& interval) {
  return fmt::format("expected {:g} .. {:g}{}{}", interval.low, interval.high, interval.unit.empty() ? "" : " ",
                     interval.unit);
}

double parse_number(std::string_view text, std::string_view name, const Interval& interval) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // "nan" and "inf" are numbers to from_chars; they fail the comparison.
  const bool whole = error == std::errc{} && end == digits.data() + digits.size();
  if (!whole || !(value >= interval.low && value <= interval.high))
    throw InputError(fmt::format("{} = {}: {}", name, text, expected(interval)));
  return value;
}

int parse_whole(std::string_view text, std::string_view name, const Interval& interval) {
  const double value = parse_number(text, name, interval);
  if (value != std::floor(value)) throw InputError(fmt::format("{} = {}: {}, whole", name, text, expected(interval)));
  return static_cast<int>(value);
}

Size parse_size(std::string_view text, std::string_view name, const Interval& interval) {
  const std::size_t cross = text.find_first_of("xX");
  const bool whole = !text.empty() && cross != 0 && cross != text.size() - 1;
  if (!whole || cross != text.find_last_of("xX") ||
      text.find_first_not_of("0123456789+-.eExX") != std::string_view::npos)
    throw InputError(fmt::format("{} = {}: {} a side, WIDTHxHEIGHT or one number", name, text, expected(interval)));
  Size size{parse_whole(text.substr(0, cross), name, interval), {}};
  if (cross != std::string_view::npos) size.height = parse_whole(text.substr(cross + 1), name, interval);
  return size;
}

void check_number(double value, std::string_view name, const Interval& interval) {
  if (!(value >= interval.low && value <= interval.high))
    throw InputError(fmt::format("{} = {}: {}", name, value, expected(interval)));
}

std::vector<double> parse_wavelengths(const std::string& text, std::string_view name) {
  std::vector<double> numbers;
  const bool range = text.find(':') != std::string::npos;
  const std::string_view separator = range ? ":" : ",";
  for (std::size_t begin = 0; begin <= text.size() && numbers.size() <= most_wavelengths;) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    numbers.push_back(parse_number(std::string_view(text).substr(begin, end - begin), name, any_wavelength));
    begin = end + 1;
  }
  if (range) {
    if (numbers.size() != 3) throw InputError(fmt::format("{} = {}: expected first:last:step in nm", name, text));
    const double first = numbers[0], last = numbers[1], step = numbers[2];
    // A last value missed only by rounding still belongs to the list.
    const double steps = std::floor((last - first) / step + 1e-9);
    if (!(steps >= 0) || steps >= most_wavelengths)
      throw InputError(
          fmt::format("{} = {}: expected first <= last and at most {} wavelengths", name, text, most_wavelengths));
    numbers.clear();
    for (int i = 0; i <= static_cast<int>(steps); ++i) numbers.push_back(first + i * step);
  }
  if (numbers.size() > most_wavelengths)
    throw InputError(fmt::format("{}: more than {} wavelengths", name, most_wavelengths));
  return numbers;
}

}  // namespace airlight::cli
