#pragma once
#include <stdexcept>
#include <string>

namespace airlight {

/// Input that a person can mend: a value out of its range, an unknown key, a file that cannot be read.
/// The message names what, where and the legal range. Programs end with exit code 2 on it.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Work that failed though the input was right: a full disk, a shader that does not compile, a lost device. Exit code 1.
struct WorkError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace airlight
