#include "image/whole_picture.h"

#include <dlfcn.h>

#include <filesystem>

#include "airlight/error.h"

namespace airlight {

EncodePicture& encode_picture() {
  // Never unloaded: the libraries that come with it start threads and keep state.
  static EncodePicture* const function = [] {
    namespace fs = std::filesystem;
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    std::string failures;
    for (const fs::path& folder : {here, here.parent_path() / "lib" / "airlight"}) {  // as built, as installed
      const fs::path path = folder / "airlight_openimageio.so";
      if (!fs::exists(path)) {
        failures += "\n  " + path.string() + " does not exist";
      } else if (void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
        if (void* symbol = dlsym(module, encode_picture_symbol)) return reinterpret_cast<EncodePicture*>(symbol);
        failures += "\n  " + path.string() + " belongs to another version";
      } else {
        failures += std::string("\n  ") + dlerror();
      }
    }
    throw WorkError("pictures other than EXR need OpenImageIO, which cannot be loaded:" + failures);
  }();
  return *function;
}

}  // namespace airlight
