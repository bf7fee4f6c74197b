#include "engine/kernel_version.h"

#include "engine/kernel_index.h"

namespace airlight {

std::uint64_t kernel_version() {
  // FNV-1a (Fowler, Noll & Vo): not cryptographic, but it tells texts apart.
  static const std::uint64_t version = [] {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const KernelGroup& group : kernel_groups())
      for (const KernelSource* source : group.sources)
        for (const char letter : source->text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    return hash;
  }();
  return version;
}

}  // namespace airlight
