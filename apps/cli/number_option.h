// Options that take a number; --help states its unit and range.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "number.h"

namespace airlight::cli {

/// Adds an option that takes one number; its range and unit go into the help text.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, Interval interval,
                        const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, int& value, Interval interval, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, Interval interval,
                        const std::string& help);

}  // namespace airlight::cli
