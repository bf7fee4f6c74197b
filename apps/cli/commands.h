// The verbs of the command line; one file each.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace airlight::cli {

/// What the person asked for, ready to run; its result is the exit code.
using Command = std::function<int()>;

// Each adds its subcommand; when the command line names it, `chosen` becomes what to run.
void add_sky(CLI::App& app, Command& chosen);
void add_render(CLI::App& app, Command& chosen);
void add_compare(CLI::App& app, Command& chosen);
void add_haze(CLI::App& app, Command& chosen);
void add_sequence(CLI::App& app, Command& chosen);
void add_realworldz_table(CLI::App& app, Command& chosen);
void add_tables(CLI::App& app, Command& chosen);
void add_probe(CLI::App& app, Command& chosen);
void add_validate(CLI::App& app, Command& chosen);  // where the reference is built in
void add_eval(CLI::App& app, Command& chosen);
void add_models(CLI::App& app, Command& chosen);
void add_planets(CLI::App& app, Command& chosen);
void add_doctor(CLI::App& app, Command& chosen);

/// "airlight 0.1.0"
const char* version();

/// Exit codes.
enum : int { ok = 0, failed = 1, bad_input = 2, interrupted_code = 130 };

}  // namespace airlight::cli
