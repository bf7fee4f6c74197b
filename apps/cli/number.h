// Numbers from outside: finite and inside a stated range, which the message names with its unit.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace airlight::cli {

struct Interval {
  double low, high;
  std::string_view unit;  ///< "" for plain numbers
};

/// What stands between the commas; empty text is one empty piece.
std::vector<std::string_view> comma_separated(std::string_view text);

/// "expected -90 .. 90 degrees"
std::string expected(const Interval& interval);

/// @param name  for the message: an option or a key
/// @throws InputError "--altitude = nan: expected -20000 .. 1e+12 m"
double parse_number(std::string_view text, std::string_view name, const Interval& interval);
/// The same for whole numbers.
int parse_whole(std::string_view text, std::string_view name, const Interval& interval);
/// "256x128", or "256" alone.
struct Size {
  int width;
  std::optional<int> height;
};
/// @param interval  of each side. @throws InputError in the same form.
Size parse_size(std::string_view text, std::string_view name, const Interval& interval);
/// @throws InputError in the same form.
void check_number(double value, std::string_view name, const Interval& interval);

/// Wavelengths [nm]: "440,550,680" or first:last:step ("400:700:50", both ends included).
/// @throws InputError.
std::vector<double> parse_wavelengths(const std::string& text, std::string_view name);

/// Wavelengths [nm] that any input may name; an atmosphere's own data are narrower.
inline constexpr Interval any_wavelength{1e-3, 1e6, "nm"};
inline constexpr std::size_t most_wavelengths = 4096;

inline constexpr double lowest_altitude = -20'000, highest_altitude = 1e12;  ///< [m]

inline constexpr double degree = 0.017453292519943295;  ///< [rad]

}  // namespace airlight::cli
