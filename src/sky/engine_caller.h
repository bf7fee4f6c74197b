// Kernels for adapters, on an engine.
#pragma once
#include "airlight/engine.h"
#include "model/adapter.h"

namespace airlight {

class EngineCaller : public KernelCaller {
 public:
  explicit EngineCaller(Engine& engine) : engine_(engine) {}

  std::vector<double> call(std::string_view function, const Fields& numbers, const Structs& structs) override;
  std::vector<Table> run(std::string_view pass, const Structs& structs, const Tables& tables, Shape shape) override;
  Table upload(Shape shape, std::span<const double> rgba) override { return engine_.upload(shape, rgba); }
  std::vector<double> read(const Table& table) override;

 private:
  Engine& engine_;
};

/// Answers an adapter's question on an engine.
/// @throws InputError where the adapter does not run on that engine
std::vector<double> evaluate(const Adapter& adapter, const Values& inputs, Engine& engine);

}  // namespace airlight
