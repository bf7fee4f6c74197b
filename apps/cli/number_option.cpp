#include "number_option.h"

#include <fmt/core.h>

#include <type_traits>

namespace airlight::cli {
namespace {

template <typename Number>
CLI::Option* add(CLI::App& app, const std::string& name, Number& value, const Interval& interval,
                 const std::string& help) {
  const auto read = [&value, name, interval](const std::string& text) {
    if constexpr (std::is_same_v<Number, int>)
      value = parse_whole(text, name, interval);
    else
      value = parse_number(text, name, interval);
  };
  const std::string range = fmt::format("{:g} .. {:g}", interval.low, interval.high);
  return app
      .add_option_function<std::string>(
          name, read, fmt::format("{} [{}{}{}]", help, interval.unit, interval.unit.empty() ? "" : ", ", range))
      ->type_name("NUMBER");
}

}  // namespace

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, Interval interval,
                        const std::string& help) {
  return add(app, name, value, interval, fmt::format("{} (default {:g})", help, value));
}

CLI::Option* add_number(CLI::App& app, const std::string& name, int& value, Interval interval,
                        const std::string& help) {
  return add(app, name, value, interval, fmt::format("{} (default {})", help, value));
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, Interval interval,
                        const std::string& help) {
  return add(app, name, value, interval, help);
}

}  // namespace airlight::cli
