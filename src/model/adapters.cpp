#include <algorithm>
#include <iterator>

#include "model/adapter.h"

namespace airlight {

std::span<const Adapter> all_adapters() {
  static const std::vector<Adapter> all = [] {
    std::vector<Adapter> joined;
    for (const auto& list :
         {hoffman_preetham_adapters, rama_adapters, codeflow_adapters, jetlag_adapters, realworldz_adapters})
      std::ranges::move(list(), std::back_inserter(joined));
    return joined;
  }();
  return all;
}

}  // namespace airlight
