// Ctrl-C, noticed between pieces of work, so that the way out cleans up as any other failure does.
#pragma once
#include <exception>

namespace airlight::cli {

/// Thrown by check_interrupt(); the program ends with exit code 130.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on SIGINT, SIGTERM and SIGHUP set a flag. Where nobody looks at it for a second (a strip of many seconds, a
/// pipe that nobody reads), or at a second signal, the program ends on the spot, with its temporary files removed.
void catch_interrupts();
bool interrupted();
/// @throws Interrupted when the flag is set.
void check_interrupt();

}  // namespace airlight::cli
