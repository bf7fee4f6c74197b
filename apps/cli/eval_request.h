// One line of `airlight eval`: a model's adapter or a kernel function, and its inputs. No state, no files: fuzzed by
// tests/fuzz/fuzz_jsonl.cpp.
//
// Numbers that JSON does not have are the strings "nan", "inf" and "-inf", both ways.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/kernel_index.h"
#include "model/adapter.h"

namespace airlight::cli {

struct EvalRequest {
  nlohmann::json id;                 ///< echoed; null where the line has none
  const Adapter* adapter = nullptr;  ///< with its checked inputs; or
  Values values;
  const FunctionInfo* function = nullptr;
  std::vector<double> uniforms, varying;  ///< as Engine::evaluate takes them
  std::string error;                      ///< not empty: the line cannot be answered, and why
};

/// {"id":"k1","fn":"core.phase_rayleigh","inputs":{"one_minus_cos":0.5}}: structs are objects (their padding may be
/// left out), vectors are arrays. Never throws for what the text holds.
/// @param adapters  are looked for first
EvalRequest parse_eval_request(std::string_view text, std::span<const Adapter> adapters);

/// {"id":…,"value":[…],"outputs":{"name":[…]}}; "outputs" only for kernel functions with OUT arguments.
/// @param results  the components of the return value, then those of the OUT arguments
nlohmann::ordered_json eval_answer(const EvalRequest& request, const std::vector<double>& results);

/// True for a field that only fills a struct up to 16 bytes: nobody has to name it, and lists leave it out.
bool is_padding(const ArgumentInfo& field);

/// True for an argument that is the same for all lanes.
bool is_uniform(KernelType type);

/// "Float", "Vec3", "struct Air": as the kernel says it.
std::string type_name(KernelType type, std::string_view struct_name = {});

}  // namespace airlight::cli
