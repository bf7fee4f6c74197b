// The words of the command line, read by CLI11. Its headers are templates that take a compiler seconds: one file includes them.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "number.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace airlight::cli {

/// What the person asked for, ready to run; its result is the exit code.
using Command = std::function<int()>;

/// One option of a verb: a handle, which its calls give back so that they chain.
class Option {
 public:
  Option group(const std::string& heading) const;   ///< under which --help lists it
  Option type_name(const std::string& word) const;  ///< what stands for the value in --help
  Option required() const;
  Option one_value_each() const;  ///< of a list: one value each time it is given
  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;

 private:
  friend class Verb;
  explicit Option(CLI::Option* option) : option_(option) {}
  CLI::Option* option_;
};

/// A verb and its options: a handle. Values live elsewhere, as long as the command line; what they hold before is the default.
class Verb {
 public:
  /// @param name  "--size", "-o,--output", or without dashes for an argument that is known by its place
  Option option(const std::string& name, std::string& value, const std::string& help) const;
  Option option(const std::string& name, std::optional<int>& value, const std::string& help) const;
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& help) const;
  Option flag(const std::string& name, bool& value, const std::string& help) const;

  /// An option that takes one number; its range and unit go into the help text.
  Option number(const std::string& name, double& value, const Interval& interval, const std::string& help) const;
  Option number(const std::string& name, int& value, const Interval& interval, const std::string& help) const;
  Option number(const std::string& name, std::optional<double>& value, const Interval& interval,
                const std::string& help) const;

  /// An option that was added before.
  Option find(const std::string& name) const;

  /// What it does, called after all its options have been read.
  void runs(Command command) const;

 private:
  friend class CommandLine;
  Verb(CLI::App* app, Command* chosen) : app_(app), chosen_(chosen) {}
  CLI::App* app_;
  Command* chosen_;
};

class CommandLine {
 public:
  /// @param footer  last paragraph of the program's own --help
  CommandLine(const std::string& program, const std::string& about, const std::string& version,
              const std::string& footer);
  ~CommandLine();

  Verb verb(const std::string& name, const std::string& about);

  /// Reads the words and runs the verb that they name. Bad words, and none at all, are told on standard error.
  /// @returns the exit code. @throws what the verb throws, and InputError for numbers outside their range
  int run(int argc, char** argv);

 private:
  /// @param verb  whose words they are; null: the program's own
  int refuse(const CLI::App* verb, const std::string& why) const;

  std::unique_ptr<CLI::App> app_;
  std::string footer_;
  Command chosen_;
};

}  // namespace airlight::cli
