#include "command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "commands.h"
#include "did_you_mean.h"

namespace airlight::cli {

Option Option::group(const std::string& heading) const { return Option(option_->group(heading)); }
Option Option::type_name(const std::string& word) const { return Option(option_->type_name(word)); }
Option Option::required() const { return Option(option_->required()); }
Option Option::one_value_each() const { return Option(option_->allow_extra_args(false)); }
Option Option::needs(const Option& other) const { return Option(option_->needs(other.option_)); }
Option Option::excludes(const Option& other) const { return Option(option_->excludes(other.option_)); }

Option Verb::option(const std::string& name, std::string& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}

Option Verb::option(const std::string& name, std::optional<int>& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}

Option Verb::option(const std::string& name, std::vector<std::string>& values, const std::string& help) const {
  return Option(app_->add_option(name, values, help));
}

Option Verb::flag(const std::string& name, bool& value, const std::string& help) const {
  return Option(app_->add_flag(name, value, help));
}

/// @param read  takes the text of the value
static CLI::Option* add_number(CLI::App& app, const std::string& name, const Interval& interval,
                               const std::string& help, const std::function<void(const std::string& text)>& read) {
  const std::string range = fmt::format("{:g} .. {:g}", interval.low, interval.high);
  return app
      .add_option_function<std::string>(
          name, read, fmt::format("{} [{}{}{}]", help, interval.unit, interval.unit.empty() ? "" : ", ", range))
      ->type_name("NUMBER");
}

Option Verb::number(const std::string& name, double& value, const Interval& interval, const std::string& help) const {
  const auto read = [&value, name, interval](const std::string& text) { value = parse_number(text, name, interval); };
  return Option(add_number(*app_, name, interval, fmt::format("{} (default {:g})", help, value), read));
}

Option Verb::number(const std::string& name, int& value, const Interval& interval, const std::string& help) const {
  const auto read = [&value, name, interval](const std::string& text) { value = parse_whole(text, name, interval); };
  return Option(add_number(*app_, name, interval, fmt::format("{} (default {})", help, value), read));
}

Option Verb::number(const std::string& name, std::optional<double>& value, const Interval& interval,
                    const std::string& help) const {
  const auto read = [&value, name, interval](const std::string& text) { value = parse_number(text, name, interval); };
  return Option(add_number(*app_, name, interval, help, read));
}

Option Verb::find(const std::string& name) const { return Option(app_->get_option(name)); }

void Verb::runs(Command command) const {
  app_->callback([command = std::move(command), chosen = chosen_] { *chosen = command; });
}

namespace {

std::string probably(const std::string& wrong, const std::vector<std::string>& known) {
  const std::string_view nearest = nearest_name(wrong, known);
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

/// What is wrong with words that nothing takes.
std::string about_extras(const CLI::App& program, const CLI::App* verb, const std::vector<std::string>& extras) {
  const auto option = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with('-'); });
  const std::string& word = option == extras.end() ? extras.front() : *option;
  std::vector<std::string> known;
  if (!verb) {
    if (option != extras.end()) return fmt::format("{}: unknown option; a command comes first", word);
    for (const CLI::App* other : program.get_subcommands({})) known.push_back(other->get_name());
    return fmt::format("{}: unknown command{}", word, probably(word, known));
  }
  if (option == extras.end())
    return fmt::format("'{}': one word more than expected (a value with a space in it needs quotes)", word);
  for (const CLI::Option* other : verb->get_options())
    for (const std::string& name : other->get_lnames()) known.push_back("--" + name);
  const std::string name = word.substr(0, word.find('='));
  return fmt::format("{}: unknown option{}", name, probably(name, known));
}

}  // namespace

int CommandLine::refuse(const CLI::App* verb, const std::string& why) const {
  const std::string name = verb ? app_->get_name() + ' ' + verb->get_name() : app_->get_name();
  fmt::print(stderr, "{}: {}\n`{} --help` lists all {}.\n", name, why, name, verb ? "options" : "commands");
  return bad_input;
}

CommandLine::CommandLine(const std::string& program, const std::string& about, const std::string& version,
                         const std::string& footer)
    : app_(std::make_unique<CLI::App>(about, program)), footer_(footer) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(0, 1);  // an unknown word is then named in the message; none at all shows the help
  app_->get_formatter()->column_width(38);
}

CommandLine::~CommandLine() = default;

Verb CommandLine::verb(const std::string& name, const std::string& about) {
  return {app_->add_subcommand(name, about), &chosen_};
}

int CommandLine::run(int argc, char** argv) {
  app_->footer(footer_);  // after all verbs were made, which would inherit it
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {  // airlight help sky
    if (words.size() > 2)
      return refuse(nullptr, fmt::format("help: '{}': one word more than expected, help or help COMMAND", words[2]));
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    app_->parse(words);
  } catch (const CLI::ParseError& error) {
    const auto verbs = app_->get_subcommands();
    const CLI::App* const verb = verbs.empty() ? nullptr : verbs.front();
    const std::vector<std::string> extras = app_->remaining(true);
    // CLI11 gives its general help on what is no command.
    const bool done = dynamic_cast<const CLI::Success*>(&error);
    if (done && (verb || extras.empty())) return app_->exit(error);
    return refuse(verb, extras.empty() ? error.what() : about_extras(*app_, verb, extras));
  }
  if (chosen_) return chosen_();
  std::fputs(app_->help().c_str(), stderr);
  return bad_input;
}

}  // namespace airlight::cli
