// The verbs of the command line; one file each.
#pragma once

namespace airlight::cli {

class CommandLine;

// Each adds its verb.
void add_sky(CommandLine& line);
void add_render(CommandLine& line);
void add_compare(CommandLine& line);
void add_haze(CommandLine& line);
void add_sequence(CommandLine& line);
void add_realworldz_table(CommandLine& line);
void add_tables(CommandLine& line);
void add_probe(CommandLine& line);
void add_validate(CommandLine& line);  // where the reference is built in
void add_eval(CommandLine& line);
void add_models(CommandLine& line);
void add_planets(CommandLine& line);
void add_doctor(CommandLine& line);

/// "airlight 0.1.0"
const char* version();

/// Exit codes.
enum : int { ok = 0, failed = 1, bad_input = 2, interrupted_code = 130 };

}  // namespace airlight::cli
