// Numbers on the command line: finite, inside a stated range, with a unit that --help and the message name.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace airlight::cli {

struct Interval {
  double low, high;
  std::string_view unit;  ///< "" for plain numbers
};

/// "expected -90 .. 90 degrees"
std::string expected(const Interval& interval);

/// @param name  for the message: an option or a key
/// @throws InputError "--altitude = nan: expected -20000 .. 1e+12 m"
double parse_number(std::string_view text, std::string_view name, const Interval& interval);
/// The same for whole numbers.
int parse_whole(std::string_view text, std::string_view name, const Interval& interval);
/// @throws InputError in the same form.
void check_number(double value, std::string_view name, const Interval& interval);

/// Adds an option that takes one number; its range and unit go into the help text.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, Interval interval,
                        const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, int& value, Interval interval, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, Interval interval,
                        const std::string& help);

/// Wavelengths [nm]: "440,550,680" or first:last:step ("400:700:50", both ends included).
/// @throws InputError.
std::vector<double> parse_wavelengths(const std::string& text, std::string_view name);

/// Wavelengths [nm] that any input may name; an atmosphere's own data are narrower.
inline constexpr Interval any_wavelength{1e-3, 1e6, "nm"};
inline constexpr std::size_t most_wavelengths = 4096;

inline constexpr double degree = 0.017453292519943295;  ///< [rad]

}  // namespace airlight::cli
