#include "sky/engine_caller.h"

#include <stdexcept>

#include "airlight/error.h"
#include "engine/kernel_index.h"

namespace airlight {
namespace {

[[noreturn]] void not_set(std::string_view kernel, std::string_view argument) {
  throw std::logic_error(std::string(kernel) + ": nothing sets " + std::string(argument));
}

/// Appends the numbers of one argument or field.
void append(std::vector<double>& numbers, const ArgumentInfo& argument, const Fields& given, std::string_view kernel) {
  const std::size_t count = std::size_t(components(argument.type));
  const auto found = given.find(argument.name);
  const bool missing = found == given.end();
  if (missing && !argument.name.starts_with("pad")) not_set(kernel, argument.name);
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(missing || i >= found->second.size() ? 0 : found->second[i]);
}

void append_struct(std::vector<double>& numbers, const ArgumentInfo& argument, const KernelCaller::Structs& given,
                   std::string_view kernel) {
  const auto found = given.find(argument.name);
  if (found == given.end()) not_set(kernel, argument.name);
  for (const ArgumentInfo& field : kernel_struct(argument.struct_name).fields)
    append(numbers, field, found->second, kernel);
}

bool same_for_all_lanes(KernelType type) {
  return type == KernelType::Scalar || type == KernelType::Scalar4 || type == KernelType::Int;
}

}  // namespace

std::vector<double> EngineCaller::call(std::string_view name, const Fields& numbers, const Structs& structs) {
  const FunctionInfo& function = kernel_function(name);
  std::vector<double> uniforms, varying;
  int results = function.returns_nothing ? 0 : components(function.result);
  for (const ArgumentInfo& argument : function.arguments) {
    if (argument.out)
      results += components(argument.type);
    else if (argument.type == KernelType::Struct)
      append_struct(uniforms, argument, structs, name);
    else
      append(same_for_all_lanes(argument.type) ? uniforms : varying, argument, numbers, name);
  }
  std::vector<double> answer(std::size_t(results), 0.0);
  engine_.evaluate(function, uniforms, varying, 1, answer);
  return answer;
}

std::vector<Table> EngineCaller::run(std::string_view name, const Structs& structs, const Tables& tables, Shape shape) {
  const PassInfo& pass = kernel_pass(name);
  std::vector<double> parameters;
  for (const ArgumentInfo& argument : pass.parameters) append_struct(parameters, argument, structs, name);
  std::vector<Table> inputs;
  for (const ArgumentInfo& argument : pass.tables) {
    const auto found = tables.find(argument.name);
    if (found == tables.end()) not_set(name, argument.name);
    inputs.push_back(found->second);
  }
  return engine_.run(pass, parameters, inputs, shape);
}

std::vector<double> EngineCaller::read(const Table& table) {
  std::vector<double> rgba(4 * table.shape.texels());
  engine_.read(table, rgba);
  return rgba;
}

std::vector<double> evaluate(const Adapter& adapter, const Values& inputs, Engine& engine) {
  if (adapter.double_only && engine.name() != "double")
    throw InputError(std::string(adapter.name) + ": runs on engine double alone, not on " + std::string(engine.name()));
  EngineCaller caller(engine);
  return adapter.call(caller, inputs);
}

}  // namespace airlight
