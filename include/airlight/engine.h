#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace airlight {

struct PassInfo;
struct FunctionInfo;
class Stage;

struct Shape {
  int width = 1, height = 1, depth = 1;
  std::size_t texels() const { return std::size_t(width) * std::size_t(height) * std::size_t(depth); }
  bool operator==(const Shape&) const = default;
};

/// A table of RGBA texels that an engine holds, with a hash of everything it was made from.
struct Table {
  Shape shape;
  std::uint64_t hash = 0;
  std::shared_ptr<void> storage;  ///< the engine's own
};

/// Runs passes (pure functions of table coordinates, see docs/architecture.md) over grids. Knows no physics.
/// Results are kept under a hash of the pass, its parameters and its inputs, and rerun only when one of these changed.
class Engine {
 public:
  virtual ~Engine() = default;

  /// "double", "simd" or "gl".
  virtual std::string_view name() const = 0;
  /// What it runs on: "avx512, 2 threads", the GL renderer's name.
  virtual std::string device() const = 0;

  /// A table from RGBA values; equal contents share one table.
  Table upload(Shape shape, std::span<const double> rgba);
  /// A table for one use, such as a batch of questions: not kept, and not compared with what is.
  Table lend(Shape shape, std::span<const double> rgba);

  /// Runs a pass over the whole shape, or takes the kept result.
  /// @param parameters  the pass's parameter blocks one after the other, in the order of its signature
  /// @param inputs      its tables, in the order of its signature
  /// @returns           its outputs, the return value first
  std::vector<Table> run(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs,
                         Shape shape);

  /// Runs a pass whose result nobody will ask for again: it is not kept.
  std::vector<Table> run_once(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs,
                              Shape shape);

  /// Tables that take long to make, by many passes: what is kept under a hash of the name, the parameters and the inputs, in memory or
  /// on disk, else what `make` returns.
  std::vector<Table> make_once(std::string_view name, std::span<const double> parameters, std::span<const Table> inputs,
                               const std::function<std::vector<Table>()>& make);

  /// Keeps what make_once() makes in files of a folder too, from one run of a program to the next. A file that is damaged, or was made
  /// by another version, is made anew.
  /// @param folder   made when it is first needed; empty: nothing is kept on disk, as before the first call
  /// @param message  told what is amiss with a file, in a sentence; may be empty
  void keep_on_disk(std::string folder, std::function<void(const std::string&)> message);

  /// From now on `watch` is told, about ten times a second while tables are being made, which part of the work is done: 0 to 1, never
  /// falling within one question; an estimate where the number of steps shows on the way. It is called from the thread that asks. What it
  /// throws ends the work and comes out of the question: nothing half-made is kept, in memory or on disk, and the engine can be asked again.
  /// When the work is over or given up, it is told 1, and what it throws then is ignored.
  /// @param watch  empty: nobody
  void watch(std::function<void(double done)> watch);

  /// Runs a pass over rows [begin, end) of a picture and writes RGBA floats; nothing is kept.
  /// @param rgba  (end - begin) * width * 4 values
  void draw(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
            int begin, int end, std::span<float> rgba);

  /// Copies a table's texels out.
  virtual void read(const Table& table, std::span<double> rgba) = 0;

  /// Evaluates one kernel function for `count` sets of arguments.
  /// @param uniforms  values of the uniform arguments (Scalars, structs), in the order of the signature
  /// @param varying   argument components, each `count` values, in the order of the signature
  /// @param results   result components (return value, then OUT arguments), each `count` values
  virtual void evaluate(const FunctionInfo& function, std::span<const double> uniforms, std::span<const double> varying,
                        int count, std::span<double> results) = 0;

  /// How often a pass was really run (not taken from what is kept).
  long passes_run(std::string_view pass) const;

 protected:
  virtual std::shared_ptr<void> make_table(Shape shape, std::span<const double> rgba) = 0;
  /// A table to be filled by run_rows().
  virtual std::shared_ptr<void> make_empty(Shape shape) = 0;
  /// Fills rows [begin, end), counted through all slices, of a pass's outputs; where these are not all rows, they are there on return.
  virtual void run_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs,
                        Shape shape, int begin, int end, std::span<const std::shared_ptr<void>> outputs) = 0;
  virtual void draw_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs,
                         Shape shape, int begin, int end, std::span<float> rgba) = 0;

 private:
  friend class Stage;
  struct Kept {
    std::vector<Table> tables;
    std::uint64_t used = 0;
  };
  std::vector<std::shared_ptr<void>> run_pass(const PassInfo& pass, std::span<const double> parameters,
                                              std::span<const Table> inputs, Shape shape);
  void keep(std::uint64_t key, std::vector<Table> tables);
  const std::vector<Table>* find_kept(std::uint64_t key);

  std::map<std::uint64_t, Kept> kept_;
  std::string folder_;
  std::function<void(const std::string&)> message_;
  std::function<void(double)> watch_;
  const Stage* stage_ = nullptr;  // the innermost
  std::size_t kept_texels_ = 0;
  std::map<std::string, long, std::less<>> runs_;
  std::uint64_t clock_ = 0;
};

/// @param name  "double", "simd" (the widest instruction set of this processor, or AIRLIGHT_ISA) or "gl".
/// @throws InputError for an unknown name or an AIRLIGHT_ISA that this machine lacks; WorkError where no OpenGL 4.5 can be had.
std::shared_ptr<Engine> make_engine(std::string_view name);

/// The instruction sets compiled in, best first, and whether this processor has them.
struct InstructionSet {
  std::string_view name;
  int lanes;
  bool available;
};
std::vector<InstructionSet> instruction_sets();

}  // namespace airlight
