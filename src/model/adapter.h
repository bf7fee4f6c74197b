// Functions that a model's specification names, with the inputs it names: words, presets and defaults become arguments of kernel
// functions, which run on whichever engine is asked. `airlight eval` finds them before the kernel functions of the same name.
#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/engine.h"
#include "model/model.h"
#include "model/parameters.h"

namespace airlight {

/// Runs kernels by their outside names: models know no engine.
class KernelCaller {
 public:
  virtual ~KernelCaller() = default;

  using Structs = std::map<std::string, Fields, std::less<>>;
  using Tables = std::map<std::string, Table, std::less<>>;

  /// A function of numbers. @param numbers  all arguments but structs, by name  @param structs  by argument; padding may be left out
  /// @returns the components of the return value, then of the OUT arguments
  virtual std::vector<double> call(std::string_view function, const Fields& numbers, const Structs& structs = {}) = 0;

  /// A pass over a grid; equal questions are answered once. @returns its outputs, the return value first
  virtual std::vector<Table> run(std::string_view pass, const Structs& structs, const Tables& tables, Shape shape) = 0;
  /// A table from RGBA values.
  virtual Table upload(Shape shape, std::span<const double> rgba) = 0;
  /// A table's RGBA values, u fastest.
  virtual std::vector<double> read(const Table& table) = 0;
};

struct Adapter {
  std::string_view name;  ///< "codeflow.phase"
  std::string_view text;  ///< one sentence
  std::vector<ParameterInfo> inputs;
  std::string_view outputs, unit;  ///< what comes back, in order; its unit
  std::function<std::vector<double>(KernelCaller&, const Values&)> call;
  bool double_only = false;  ///< prepares data on the host: engine `double` alone
  double bound = 3e-4;       ///< engines differ from double by at most bound * max(|value|, scale)
  double scale = 1;
};

std::span<const Adapter> all_adapters();
/// Null where no adapter has that name.
const Adapter* find_adapter(std::span<const Adapter> adapters, std::string_view name);

// One list a system, in its model's file; src/model/adapters.cpp joins them.
std::vector<Adapter> codeflow_adapters();
std::vector<Adapter> hoffman_preetham_adapters();
std::vector<Adapter> jetlag_adapters();
std::vector<Adapter> rama_adapters();
std::vector<Adapter> realworldz_adapters();

}  // namespace airlight
