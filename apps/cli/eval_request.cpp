#include "eval_request.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "airlight/error.h"
#include "json_line.h"

namespace airlight::cli {
namespace {

using nlohmann::json;

double read_number(const json& value, const std::string& name) {
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  throw InputError(fmt::format("{} = {}: expected a number, \"nan\", \"inf\" or \"-inf\"", name, excerpt(value)));
}

void read_argument(const ArgumentInfo& argument, const json& value, const std::string& name,
                   std::vector<double>& numbers) {
  switch (argument.type) {
    case KernelType::Bool:
      if (!value.is_boolean()) throw InputError(fmt::format("{} = {}: expected true or false", name, excerpt(value)));
      numbers.push_back(value.get<bool>() ? 1 : 0);
      return;
    case KernelType::Int: {
      constexpr double largest = 16'777'216;  // 2^24: exact as a float, which is how engines may carry it
      const double number = value.is_number() ? value.get<double>() : std::nan("");
      if (!(std::abs(number) <= largest) || number != std::floor(number))
        throw InputError(
            fmt::format("{} = {}: expected a whole number {} .. {}", name, excerpt(value), -largest, largest));
      numbers.push_back(number);
      return;
    }
    case KernelType::Struct: {
      if (!value.is_object())
        throw InputError(
            fmt::format("{} = {}: expected an object, struct {}", name, excerpt(value), argument.struct_name));
      Fields fields(value, name + '.');
      for (const ArgumentInfo& field : kernel_struct(argument.struct_name).fields) {
        const std::string key(field.name);
        static const json zero = 0;
        const json* const given = is_padding(field) ? fields.find(key) : &fields.get(key);
        read_argument(field, given ? *given : zero, fields.path(key), numbers);
      }
      fields.expect_no_more();
      return;
    }
    case KernelType::Float:
    case KernelType::Scalar:
      numbers.push_back(read_number(value, name));
      return;
    default: {
      const std::size_t size = components(argument.type);
      if (!value.is_array() || value.size() != size)
        throw InputError(fmt::format("{} = {}: expected an array of {} numbers", name,
                                     value.is_array() ? fmt::format("an array of {}", value.size()) : excerpt(value),
                                     size));
      for (std::size_t i = 0; i < size; ++i) numbers.push_back(read_number(value[i], fmt::format("{}[{}]", name, i)));
    }
  }
}

/// An adapter's inputs are read as they are; what each may be is the adapter's to say.
ParameterValue read_parameter(const json& value, const std::string& name) {
  if (value.is_boolean()) return std::vector<double>{value.get<bool>() ? 1.0 : 0.0};
  if (value.is_string()) return value.get<std::string>();
  std::vector<double> numbers;
  if (!value.is_array()) return std::vector<double>{read_number(value, name)};
  constexpr std::size_t most = 4096;
  if (value.size() > most) throw InputError(fmt::format("{}: expected at most {} numbers", name, most));
  for (std::size_t i = 0; i < value.size(); ++i)
    numbers.push_back(read_number(value[i], fmt::format("{}[{}]", name, i)));
  return numbers;
}

void read_adapter_inputs(const json& inputs, EvalRequest& request) {
  Parameters given;
  for (const auto& [key, value] : inputs.items()) given.emplace(key, read_parameter(value, "inputs." + key));
  request.values = check_parameters(request.adapter->inputs, given, "inputs.");
}

void read(const json& object, std::span<const Adapter> adapters, EvalRequest& request) {
  Fields fields(object, "");
  fields.find("id");
  fields.get("fn");
  const std::string name = fields.text("fn", "");
  request.adapter = find_adapter(adapters, name);
  static const json none = json::object();
  const json* const given = fields.find("inputs");
  if (given && !given->is_object()) throw InputError(fmt::format("inputs = {}: expected an object", excerpt(*given)));
  if (request.adapter) {
    fields.expect_no_more();
    read_adapter_inputs(given ? *given : none, request);
    return;
  }
  const FunctionInfo& function = kernel_function(name);
  if (!function.evaluable)
    throw InputError(fmt::format("fn = {}: reads tables; only functions of numbers can be evaluated", function.name));
  fields.expect_no_more();
  Fields inputs(given ? *given : none, "inputs.");
  for (const ArgumentInfo& argument : function.arguments) {
    if (argument.out) continue;
    const std::string key(argument.name);
    read_argument(argument, inputs.get(key), inputs.path(key),
                  is_uniform(argument.type) ? request.uniforms : request.varying);
  }
  inputs.expect_no_more();
  request.function = &function;
}

json written(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return number;
}

}  // namespace

bool is_padding(const ArgumentInfo& field) { return field.name.starts_with("pad"); }

bool is_uniform(KernelType type) {
  return type == KernelType::Scalar || type == KernelType::Scalar4 || type == KernelType::Int ||
         type == KernelType::Struct;
}

std::string type_name(KernelType type, std::string_view struct_name) {
  switch (type) {
    case KernelType::Float:
      return "Float";
    case KernelType::Vec2:
      return "Vec2";
    case KernelType::Vec3:
      return "Vec3";
    case KernelType::Vec4:
      return "Vec4";
    case KernelType::Bool:
      return "Bool";
    case KernelType::Scalar:
      return "Scalar";
    case KernelType::Scalar4:
      return "Scalar4";
    case KernelType::Int:
      return "int";
    case KernelType::Struct:
      return "struct " + std::string(struct_name);
    case KernelType::Table2:
      return "Table2";
    case KernelType::Table3:
      return "Table3";
  }
  return "?";
}

EvalRequest parse_eval_request(std::string_view text, std::span<const Adapter> adapters) {
  EvalRequest request;
  try {
    read(parse_object(text, request.id), adapters, request);
  } catch (const InputError& error) {
    request.error = error.what();
  }
  return request;
}

nlohmann::ordered_json eval_answer(const EvalRequest& request, const std::vector<double>& results) {
  nlohmann::ordered_json answer{{"id", request.id}, {"value", json::array()}};
  if (request.adapter) {
    json numbers = json::array();
    for (const double number : results) numbers.push_back(written(number));
    answer["value"] = numbers;
    return answer;
  }
  const FunctionInfo& function = *request.function;
  auto next = results.begin();
  const auto take = [&next](KernelType type) {
    json numbers = json::array();
    for (int i = 0; i < components(type); ++i) {
      const double number = *next++;
      if (type == KernelType::Bool)
        numbers.push_back(number != 0);
      else
        numbers.push_back(written(number));
    }
    return numbers;
  };
  if (!function.returns_nothing) answer["value"] = take(function.result);
  for (const ArgumentInfo& argument : function.arguments)
    if (argument.out) answer["outputs"][std::string(argument.name)] = take(argument.type);
  return answer;
}

}  // namespace airlight::cli
