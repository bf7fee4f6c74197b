// What the build's generator (tools/kernel_index.py) reads out of kernels/: every function, its arguments, units and bound.
#pragma once
#include <span>
#include <string_view>

namespace airlight {

/// Types of the kernel language, as far as a function's signature may name them.
enum class KernelType { Float, Vec2, Vec3, Vec4, Bool, Scalar, Scalar4, Int, Struct, Table2, Table3 };

struct ArgumentInfo {
  std::string_view name;
  KernelType type;
  std::string_view struct_name;  ///< for Struct
  bool out;                      ///< an OUT argument: a result
  std::string_view unit;
  double low, high;  ///< the range it is meant for; tests draw from it
  bool logarithmic;  ///< draw logarithmically
  std::string_view text;
};

/// A parameter struct: Scalar and Scalar4 fields, in std140 order as they stand.
struct StructInfo {
  std::string_view name;
  std::span<const ArgumentInfo> fields;
  int numbers;  ///< how many numbers it holds
};

struct FunctionInfo {
  std::string_view name;         ///< outside name, "core.phase_rayleigh"
  std::string_view kernel_name;  ///< "phase_rayleigh"
  std::string_view unit;         ///< of its result
  std::string_view text;         ///< first sentence of its comment
  KernelType result;             ///< Struct with no name: void
  bool returns_nothing;
  std::span<const ArgumentInfo> arguments;
  double bound, scale;  ///< engines differ from double by at most bound * max(|value|, scale)
  std::string_view file;
  int line;
  int group;       ///< which translation unit holds it
  int slot;        ///< its place in that unit's list
  bool evaluable;  ///< no tables among its arguments
};

struct PassInfo {
  std::string_view name;                     ///< outside name, "skyview.sky_view"
  std::string_view kernel_name;              ///< "skyview_sky_view_pass"
  std::span<const ArgumentInfo> parameters;  ///< its structs
  std::span<const ArgumentInfo> tables;
  std::span<const std::string_view> outputs;  ///< the return value (named as the pass), then OUT arguments
  bool slices;                                ///< takes Vec3 uvw
  std::string_view file;
  int line, group, slot;
};

/// A kernel file in the order in which a translation unit includes it.
struct KernelSource {
  std::string_view file, text;
};
struct KernelGroup {
  std::string_view name;  ///< folder under kernels/
  std::span<const KernelSource* const> sources;
};

std::span<const FunctionInfo> kernel_functions();
std::span<const PassInfo> kernel_passes();
std::span<const StructInfo> kernel_structs();
std::span<const KernelGroup> kernel_groups();
/// @throws InputError with "did you mean".
const FunctionInfo& kernel_function(std::string_view name);
const PassInfo& kernel_pass(std::string_view name);
const StructInfo& kernel_struct(std::string_view name);
/// How many numbers one value of a type holds (Struct: see StructInfo).
int components(KernelType type);

}  // namespace airlight
