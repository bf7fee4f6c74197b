#include "engine/cpu/cpu_engine.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include "airlight/error.h"
#include "engine/cpu/cpu_targets.h"
#include "engine/kernel_index.h"

namespace airlight {

bool available(std::string_view target) {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (target == "avx2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (target == "avx512") {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
#endif
  return std::ranges::any_of(compiled_targets(), [&](const CpuTarget& t) { return t.name == target; });
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const CpuTarget& t : compiled_targets()) {
    if (t.name != "double") sets.push_back({t.name, t.groups[0]->lanes, available(t.name)});
  }
  return sets;
}

namespace {

class CpuEngine final : public Engine {
 public:
  explicit CpuEngine(const CpuTarget& target) : target_(target), element_(target.groups[0]->element_size) {}

  std::string_view name() const override { return target_.name == "double" ? "double" : "simd"; }
  std::string device() const override {
    return std::string(target_.name) + ", " + std::to_string(target_.groups[0]->lanes) + " lanes, " +
           std::to_string(tbb::info::default_concurrency()) + " threads";
  }

  void read(const Table& table, std::span<double> rgba) override {
    const std::size_t n = 4 * table.shape.texels();
    if (is_double())
      std::memcpy(rgba.data(), table.storage.get(), n * sizeof(double));
    else
      std::copy_n(static_cast<const float*>(table.storage.get()), n, rgba.begin());
  }

  void evaluate(const FunctionInfo& function, std::span<const double> uniforms, std::span<const double> varying,
                int count, std::span<double> results) override {
    if (!function.evaluable)
      throw InputError(std::string(function.name) + " reads tables: it cannot be evaluated by itself");
    target_.groups[function.group]->evals[function.slot]({uniforms.data(), varying.data(), count, results.data()});
  }

 protected:
  std::shared_ptr<void> make_table(Shape shape, std::span<const double> rgba) override {
    auto table = allocate(shape);
    if (is_double())
      std::memcpy(table.get(), rgba.data(), rgba.size_bytes());
    else
      std::ranges::transform(rgba, static_cast<float*>(table.get()), [](double v) { return static_cast<float>(v); });
    return table;
  }

  std::shared_ptr<void> make_empty(Shape shape) override { return allocate(shape); }

  void run_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
                int begin, int end, std::span<const std::shared_ptr<void>> outputs) override {
    PassArguments arguments{};
    for (std::size_t i = 0; i < outputs.size(); ++i) arguments.outputs[i] = outputs[i].get();
    sweep(pass, parameters, inputs, shape, begin, end, arguments);
  }

  void draw_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
                 int begin, int end, std::span<float> rgba) override {
    PassArguments arguments{};
    arguments.outputs[0] = rgba.data();
    arguments.to_float = true;
    sweep(pass, parameters, inputs, shape, begin, end, arguments);
  }

 private:
  bool is_double() const { return element_ == int(sizeof(double)); }

  std::shared_ptr<void> allocate(Shape shape) const {
    const std::size_t bytes = 4 * shape.texels() * std::size_t(element_);
    return {std::aligned_alloc(64, (bytes + 63) / 64 * 64), std::free};
  }

  void sweep(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
             int begin, int end, PassArguments arguments) const {
    std::vector<TableView> views;
    for (const Table& t : inputs) views.push_back({t.storage.get(), t.shape.width, t.shape.height, t.shape.depth});
    arguments.parameters = parameters.data();
    arguments.tables = views.data();
    arguments.width = shape.width;
    arguments.height = shape.height;
    arguments.depth = shape.depth;
    arguments.output_count = arguments.to_float ? 1 : int(pass.outputs.size());
    const PassEntry entry = target_.groups[pass.group]->passes[pass.slot];
    // A tile is a run of rows. Every row is computed alike whichever thread takes it, so results do not depend on threads.
    tbb::parallel_for(tbb::blocked_range<int>(begin, end, std::max(1, 4096 / shape.width)),
                      [&](const tbb::blocked_range<int>& rows) {
                        PassArguments part = arguments;
                        part.row_begin = rows.begin();
                        part.row_end = rows.end();
                        if (part.to_float)
                          part.outputs[0] = static_cast<float*>(arguments.outputs[0]) +
                                            4 * std::size_t(rows.begin() - begin) * std::size_t(shape.width);
                        entry(part);
                      });
  }

  CpuTarget target_;
  int element_;
};

}  // namespace

std::shared_ptr<Engine> make_cpu_engine(const CpuTarget& target) { return std::make_shared<CpuEngine>(target); }

std::shared_ptr<Engine> make_cpu_engine(std::string_view wanted) {
  std::string_view source = "instruction set";
  if (wanted.empty()) {
    if (const char* isa = std::getenv("AIRLIGHT_ISA"); isa && *isa) {
      wanted = isa;
      source = "AIRLIGHT_ISA";
    }
  }
  std::string known;
  for (const CpuTarget& t : compiled_targets()) {
    if (wanted.empty() ? available(t.name) : t.name == wanted) {
      if (!available(t.name))
        throw InputError(std::string(source) + " = " + std::string(wanted) + ": this processor does not have it");
      return make_cpu_engine(t);
    }
    known += (known.empty() ? "" : ", ") + std::string(t.name);
  }
  throw InputError(std::string(source) + " = " + std::string(wanted) + ": expected one of " + known);
}

}  // namespace airlight
