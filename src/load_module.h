// Parts of the program in modules of their own: libraries that take long to load are loaded by those who need them.
#pragma once
#include <dlfcn.h>

#include <filesystem>
#include <string>

#include "airlight/error.h"

namespace airlight {

/// A symbol of a module that lies beside the program (as built) or in lib/airlight (as installed). Never unloaded: the
/// libraries that come with it start threads and keep state.
/// @param name     "airlight_openimageio"
/// @param purpose  begins the complaint: "pictures other than EXR need OpenImageIO". @throws WorkError.
inline void* load_from_module(const std::string& name, const char* symbol, const std::string& purpose) {
  namespace fs = std::filesystem;
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  std::string failures;
  for (const fs::path& folder : {here, here.parent_path() / "lib" / "airlight"}) {
    const fs::path path = folder / (name + ".so");
    if (!fs::exists(path)) {
      failures += "\n  " + path.string() + " does not exist";
    } else if (void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      if (void* found = dlsym(module, symbol)) return found;
      failures += "\n  " + path.string() + " belongs to another version";
    } else {
      failures += std::string("\n  ") + dlerror();
    }
  }
  throw WorkError(purpose + ", which cannot be loaded:" + failures);
}

}  // namespace airlight
