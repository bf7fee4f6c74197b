// Apart from the list of all adapters, so that a program may have a list of its own.
#include <algorithm>

#include "model/adapter.h"

namespace airlight {

const Adapter* find_adapter(std::span<const Adapter> adapters, std::string_view name) {
  const auto found = std::ranges::find(adapters, name, &Adapter::name);
  return found == adapters.end() ? nullptr : &*found;
}

}  // namespace airlight
