// The engines that tests compare.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "airlight/engine.h"
#include "engine/kernel_index.h"

namespace airlight {

// The index of tests/kernels/glsl, which the same generator writes.
std::span<const FunctionInfo> language_functions();
std::span<const PassInfo> language_passes();

namespace test {

/// All but double: the instruction sets compiled in, gl, gles.
std::vector<std::string> engine_names();

struct FoundEngine {
  std::shared_ptr<Engine> engine;
  std::string missing;  ///< why there is none
};
/// One engine a name, shared by all tests: shaders are compiled once.
const FoundEngine& find_engine(const std::string& name);
/// The same for the kernels of tests/kernels/glsl.
const FoundEngine& find_language_engine(const std::string& name);

}  // namespace test
}  // namespace airlight

/// Skips the test visibly where this machine has no such engine.
#define AIRLIGHT_SKIP_WITHOUT(find, name) \
  if (!find(name).engine) GTEST_SKIP() << (name) << " is missing: " << find(name).missing
/// Defines `engine`, or skips.
#define AIRLIGHT_ENGINE_OR_SKIP(find, name) \
  AIRLIGHT_SKIP_WITHOUT(find, name);        \
  Engine& engine = *find(name).engine
