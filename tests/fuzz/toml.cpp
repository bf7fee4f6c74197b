// toml++ itself, so that it is instrumented like the rest. Its assertions are off, as in the library that Debian ships: some
// claim what bad input breaks although the code after them reports it well; address and undefined-behaviour sanitizers judge.
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
