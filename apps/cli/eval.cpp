// `airlight eval`: models' adapters and kernel functions by name on any engine; test vectors for people who port a kernel.
#include <fmt/core.h>

#include <map>
#include <memory>

#include "airlight/engine.h"
#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "eval_request.h"
#include "interrupt.h"
#include "json_line.h"
#include "jsonl.h"
#include "options.h"
#include "parameter_json.h"
#include "sky/engine_caller.h"
#include "text_output.h"

namespace airlight::cli {
namespace {

struct EvalOptions {
  std::string engine = "double", output = "-";
  bool list = false, json = false;
};

int result_components(const FunctionInfo& function) {
  int count = function.returns_nothing ? 0 : components(function.result);
  for (const ArgumentInfo& argument : function.arguments) count += argument.out ? components(argument.type) : 0;
  return count;
}

struct Job {
  EvalRequest request;
  std::vector<double> results;
};

/// One call of the engine for all requests of one function and equal uniform arguments.
void evaluate_together(Engine& engine, std::span<Job* const> group) {
  const EvalRequest& first = group.front()->request;
  const std::size_t count = group.size(), taken = first.varying.size(), given = result_components(*first.function);
  std::vector<double> varying(taken * count), results(given * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < taken; ++c) varying[c * count + i] = group[i]->request.varying[c];
  try {
    engine.evaluate(*first.function, first.uniforms, varying, static_cast<int>(count), results);
  } catch (const std::runtime_error& error) {
    for (Job* job : group) job->request.error = error.what();
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < given; ++c) group[i]->results.push_back(results[c * count + i]);
}

void evaluate_adapter(Engine& engine, Job& job) {
  try {
    job.results = evaluate(*job.request.adapter, job.request.values, engine);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::runtime_error& error) {
    job.request.error = error.what();
  }
}

/// Bit patterns, so that a NaN is equal to itself and the order is total.
std::string bytes(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

int answer_vectors(const EvalOptions& options) {
  const auto engine = engine_named(options.engine);
  bool all_answered = true;
  const auto answer_chunk = [&](const std::string& name, std::span<const LineReader::Line> lines) {
    std::vector<Job> jobs;
    for (const LineReader::Line& line : lines) {
      jobs.push_back({parse_eval_request(line.text, all_adapters()), {}});
      if (line.too_long) jobs.back().request.error = fmt::format("longer than {} bytes", LineReader::longest);
    }
    std::map<std::pair<const FunctionInfo*, std::string>, std::vector<Job*>> groups;
    for (Job& job : jobs) {
      if (!job.request.error.empty()) continue;
      if (job.request.function) groups[{job.request.function, bytes(job.request.uniforms)}].push_back(&job);
      check_interrupt();
      if (job.request.adapter) evaluate_adapter(*engine, job);
    }
    for (const auto& [key, group] : groups) {
      check_interrupt();
      evaluate_together(*engine, group);
    }
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto& [request, results] = jobs[i];
      all_answered = all_answered && request.error.empty();
      texts.push_back(
          to_line(request.error.empty()
                      ? eval_answer(request, results)
                      : error_answer(request.id, fmt::format("{}:{}: {}", name, lines[i].number, request.error))));
    }
    return texts;
  };
  answer_lines("-", options.output, "eval", answer_chunk);
  return all_answered ? ok : failed;
}

nlohmann::ordered_json described(const ArgumentInfo& argument) {
  nlohmann::ordered_json json{{"name", argument.name}, {"type", type_name(argument.type, argument.struct_name)}};
  if (argument.type == KernelType::Struct) {
    for (const ArgumentInfo& field : kernel_struct(argument.struct_name).fields)
      if (!is_padding(field)) json["fields"].push_back(described(field));
    return json;
  }
  json["unit"] = argument.unit;
  if (!argument.out) json["range"] = {argument.low, argument.high};
  return json;
}

nlohmann::ordered_json described(const Adapter& adapter) {
  nlohmann::ordered_json json{
      {"fn", adapter.name}, {"text", adapter.text}, {"arguments", nlohmann::ordered_json::array()}};
  for (const ParameterInfo& key : adapter.inputs) json["arguments"].push_back(parameter_json(key));
  json["result"] = {{"type", adapter.outputs}, {"unit", adapter.unit}};
  json["bound"] = adapter.bound;
  json["scale"] = adapter.scale;
  json["evaluable"] = true;
  json["engines"] =
      adapter.double_only ? std::vector<std::string>{"double"} : std::vector<std::string>{"double", "simd", "gl"};
  return json;
}

/// A kernel function that an adapter of the same name hides is not listed: it cannot be called.
bool hidden(const FunctionInfo& function) { return find_adapter(all_adapters(), function.name) != nullptr; }

std::string list_as_json() {
  auto list = nlohmann::ordered_json::array();
  for (const Adapter& adapter : all_adapters()) list.push_back(described(adapter));
  for (const FunctionInfo& function : kernel_functions()) {
    if (hidden(function)) continue;
    nlohmann::ordered_json json{
        {"fn", function.name}, {"text", function.text}, {"arguments", nlohmann::ordered_json::array()}};
    for (const ArgumentInfo& argument : function.arguments)
      json[argument.out ? "outputs" : "arguments"].push_back(described(argument));
    json["result"] = {{"type", function.returns_nothing ? "void" : type_name(function.result)},
                      {"unit", function.unit}};
    json["bound"] = function.bound;
    json["scale"] = function.scale;
    json["evaluable"] = function.evaluable;
    json["engines"] = {"double", "simd", "gl"};
    json["source"] = fmt::format("{}:{}", function.file, function.line);
    list.push_back(std::move(json));
  }
  return list.dump(2) + '\n';
}

void list_argument(const ArgumentInfo& argument, int indent, std::string& text) {
  text += fmt::format("{:{}}{} {}{}", "", indent, type_name(argument.type, argument.struct_name), argument.name,
                      argument.out ? " (out)" : "");
  if (!argument.unit.empty()) text += fmt::format(" [{}]", argument.unit);
  if (!argument.out && argument.low < argument.high) text += fmt::format(" {:g} .. {:g}", argument.low, argument.high);
  text += '\n';
  if (argument.type == KernelType::Struct)
    for (const ArgumentInfo& field : kernel_struct(argument.struct_name).fields)
      if (!is_padding(field)) list_argument(field, indent + 4, text);
}

void list_adapter(const Adapter& adapter, std::string& text) {
  text += fmt::format("{} -> {} [{}], bound {:g} * max(|value|, {:g}){}\n    {}\n", adapter.name, adapter.outputs,
                      adapter.unit, adapter.bound, adapter.scale, adapter.double_only ? ", engine double alone" : "",
                      adapter.text);
  for (const ParameterInfo& key : adapter.inputs) text += "    " + parameter_line(key) + '\n';
}

std::string list_as_text() {
  std::string text;
  for (const Adapter& adapter : all_adapters()) list_adapter(adapter, text);
  for (const FunctionInfo& function : kernel_functions()) {
    if (hidden(function)) continue;
    text += fmt::format("{} -> {} [{}], bound {:g} * max(|value|, {:g}){}\n    {}\n", function.name,
                        function.returns_nothing ? "void" : type_name(function.result), function.unit, function.bound,
                        function.scale, function.evaluable ? "" : ", reads tables", function.text);
    for (const ArgumentInfo& argument : function.arguments) list_argument(argument, 4, text);
  }
  return text;
}

int run_eval(const EvalOptions& options) {
  if (!options.list) return answer_vectors(options);
  write_text(options.output, options.json ? list_as_json() : list_as_text());
  return ok;
}

}  // namespace

void add_eval(CommandLine& line) {
  const auto options = std::make_shared<EvalOptions>();
  const Verb eval = line.verb("eval", "Kernel functions by name: JSON lines from standard input, answers out");
  add_engine(eval, options->engine);
  eval.option("-o,--output", options->output, "where the answers go; - is standard output (default -)")
      .type_name("FILE");
  const Option list = eval.flag("--list", options->list, "every function with its arguments, units, ranges and bound");
  eval.flag("--json", options->json, "the list as JSON").needs(list);
  eval.runs([options] { return run_eval(*options); });
}

}  // namespace airlight::cli
