#include <algorithm>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "engine/kernel_index.h"

namespace airlight {
namespace {

template <class Info>
const Info& find(std::span<const Info> all, std::string_view name, const char* what) {
  const auto found = std::ranges::find(all, name, &Info::name);
  if (found != all.end()) return *found;
  std::vector<std::string_view> names;
  for (const Info& i : all) names.push_back(i.name);
  throw InputError("unknown " + std::string(what) + " '" + std::string(name) + "'" + did_you_mean(name, names));
}

}  // namespace

const FunctionInfo& kernel_function(std::string_view name) { return find(kernel_functions(), name, "kernel function"); }
const PassInfo& kernel_pass(std::string_view name) { return find(kernel_passes(), name, "pass"); }
const StructInfo& kernel_struct(std::string_view name) { return find(kernel_structs(), name, "parameter struct"); }

int components(KernelType type) {
  switch (type) {
    case KernelType::Vec2:
      return 2;
    case KernelType::Vec3:
      return 3;
    case KernelType::Vec4:
    case KernelType::Scalar4:
      return 4;
    case KernelType::Struct:
    case KernelType::Table2:
    case KernelType::Table3:
      return 0;
    default:
      return 1;
  }
}

}  // namespace airlight
