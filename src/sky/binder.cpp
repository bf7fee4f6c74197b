#include "sky/binder.h"

#include <algorithm>
#include <stdexcept>

#include "airlight/error.h"
#include "sky/orders.h"

namespace airlight {
namespace {

// A published system has no air that the general passes could ask for: that is the question's mistake. Elsewhere it is the program's.
[[noreturn]] void unbound(const Model& model, const std::string& what) {
  if (model.colours) throw InputError("model " + std::string(model.name) + " does not answer this: " + what);
  throw std::logic_error(what);
}

}  // namespace

std::vector<double> Binder::parameters(const PassInfo& pass, Shape shape) const {
  std::vector<double> numbers;
  for (const ArgumentInfo& argument : pass.parameters) {
    const auto set = structs_.find(argument.name);
    const Fields fields = set != structs_.end() ? set->second
                          : argument.name == "size"
                              ? Fields{{"width", {double(shape.width)}}, {"height", {double(shape.height)}}}
                          : model_.fields ? model_.fields(argument.name, situation_)
                                          : Fields{};
    for (const ArgumentInfo& field : kernel_struct(argument.struct_name).fields) {
      const std::size_t count = std::size_t(components(field.type));
      const auto found = fields.find(field.name);
      if (found == fields.end() && !field.name.starts_with("pad")) {
        unbound(model_, "pass " + std::string(pass.name) + ": nothing sets " + std::string(argument.name) + "." +
                            std::string(field.name));
      }
      for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(found != fields.end() && i < found->second.size() ? found->second[i] : 0);
    }
  }
  return numbers;
}

Table Binder::table(std::string_view argument, const PassInfo& reader) const {
  if (const auto set = tables_.find(argument); set != tables_.end()) return set->second;
  if (model_.orders) {
    const TablePass* const summed[] = {&model_.orders->source, &model_.orders->ground_light};
    for (std::size_t i = 0; i < 2; ++i) {
      if (kernel_pass(summed[i]->pass).outputs[0] == argument) return orders()[i];
    }
  }
  for (const TablePass& made : model_.tables) {
    const PassInfo& pass = kernel_pass(made.pass);
    const auto output = std::ranges::find(pass.outputs, argument);
    if (output == pass.outputs.end()) continue;
    return run(made)[std::size_t(output - pass.outputs.begin())];
  }
  if (host_tables_) {
    if (const auto kept = host_tables_->find(argument); kept != host_tables_->end()) return kept->second;
  }
  if (model_.data) {
    const HostTable made = model_.data(argument, situation_);
    if (!made.rgba.empty()) {
      const Table uploaded = engine_.upload(made.shape, made.rgba);
      if (host_tables_) host_tables_->emplace(argument, uploaded);
      return uploaded;
    }
  }
  unbound(model_, "pass " + std::string(reader.name) + ": no pass of model " + std::string(model_.name) +
                      " makes table " + std::string(argument));
}

std::vector<Table> Binder::orders() const {
  const OrderPasses& passes = *model_.orders;
  std::vector<double> parameters;
  std::vector<Table> inputs;
  for (const std::string_view name : {passes.first_light.pass, passes.next_source.pass, passes.source.pass}) {
    const PassInfo& pass = kernel_pass(name);
    for (const double number : this->parameters(pass, {})) parameters.push_back(number);
    for (const ArgumentInfo& argument : pass.tables) {
      if (argument.name != "light") inputs.push_back(table(argument.name, pass));
    }
  }
  return engine_.make_once("orders", parameters, inputs, [&] { return sum_orders(*this, passes); });
}

std::vector<Table> Binder::inputs(const PassInfo& pass) const {
  std::vector<Table> tables;
  for (const ArgumentInfo& argument : pass.tables) tables.push_back(table(argument.name, pass));
  return tables;
}

std::vector<Table> Binder::run(std::string_view name, Shape shape) const {
  const PassInfo& pass = kernel_pass(name);
  return engine_.run(pass, parameters(pass, shape), inputs(pass), shape);
}

std::vector<Table> Binder::run(const TablePass& made) const {
  const Shape shape = made.shape_for(situation_);
  constexpr std::size_t few = 4096;  // made sooner than read
  if (!made.on_disk || shape.texels() < few) return run(made.pass, shape);
  const PassInfo& pass = kernel_pass(made.pass);
  std::vector<double> numbers = parameters(pass, shape);
  numbers.insert(numbers.end(), {double(shape.width), double(shape.height), double(shape.depth)});
  return engine_.make_once(made.pass, numbers, inputs(pass), [&] { return run_once(made.pass, shape); });
}

std::vector<Table> Binder::run_once(std::string_view name, Shape shape) const {
  const PassInfo& pass = kernel_pass(name);
  return engine_.run_once(pass, parameters(pass, shape), inputs(pass), shape);
}

}  // namespace airlight
