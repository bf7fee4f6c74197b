// Ctrl-C, noticed between pieces of work, so that the way out cleans up as any other failure does.
#pragma once
#include <stdexcept>
#include <string>

namespace airlight::cli {

/// Thrown by check_interrupt(); the program says what it says and ends with exit code 130.
struct Interrupted : std::runtime_error {
  explicit Interrupted(const std::string& left = "nothing was written") : std::runtime_error("interrupted; " + left) {}
};

/// From now on SIGINT, SIGTERM and SIGHUP set a flag. Where nobody looks at it for a second (a strip of many seconds, a
/// pipe that nobody reads), or at a second signal, the program ends on the spot, with its temporary files removed.
void catch_interrupts();
bool interrupted();
/// @throws Interrupted when the flag is set.
void check_interrupt();

}  // namespace airlight::cli
