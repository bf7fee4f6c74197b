#include "engines.h"

#include <map>

#include "engine/cpu/cpu_engine.h"
#include "engine/cpu/cpu_targets.h"
#ifdef AIRLIGHT_HAS_GL
#include "engine/gl/gl_engine.h"
#endif

namespace airlight {

std::span<const KernelGroup> language_groups();

#define AIRLIGHT_SET(set) extern const KernelTarget target_language_##set;
AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET

namespace test {
namespace {

// Groups count from core; there the folder of tests has nothing.
#define AIRLIGHT_SET(set) const KernelTarget* const groups_##set[] = {&target_language_##set, &target_language_##set};
AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET

std::shared_ptr<Engine> make_language_cpu_engine(const std::string& name) {
#define AIRLIGHT_SET(set) \
  if (name == #set) return make_cpu_engine(CpuTarget{#set, groups_##set});
  AIRLIGHT_KERNEL_SETS
#undef AIRLIGHT_SET
  throw std::runtime_error("not compiled for this processor");
}

#ifdef AIRLIGHT_HAS_GL
std::shared_ptr<Engine> make_gl(const std::string& name, std::span<const KernelGroup> groups) {
  return name == "gl" ? make_gl_engine(groups) : make_gles_engine(groups);
}
#else
std::shared_ptr<Engine> make_gl(const std::string&, std::span<const KernelGroup>) {
  throw std::runtime_error("built without OpenGL");
}
#endif

template <class Make>
const FoundEngine& find(std::map<std::string, FoundEngine>& kept, const std::string& name, const Make& make) {
  const auto [at, fresh] = kept.try_emplace(name);
  if (fresh) {
    try {
      if (!name.starts_with("gl") && !available(name)) throw std::runtime_error("this processor does not have it");
      at->second.engine = make();
    } catch (const std::exception& error) {
      at->second.missing = error.what();
    }
  }
  return at->second;
}

}  // namespace

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const InstructionSet& set : instruction_sets()) names.emplace_back(set.name);
  names.insert(names.end(), {"gl", "gles"});
  return names;
}

const FoundEngine& find_engine(const std::string& name) {
  static std::map<std::string, FoundEngine> kept;
  return find(kept, name,
              [&] { return name.starts_with("gl") ? make_gl(name, kernel_groups()) : make_cpu_engine(name); });
}

const FoundEngine& find_language_engine(const std::string& name) {
  static std::map<std::string, FoundEngine> kept;
  return find(kept, name, [&] {
    return name.starts_with("gl") ? make_gl(name, language_groups()) : make_language_cpu_engine(name);
  });
}

}  // namespace test
}  // namespace airlight
