// What a target (number type + instruction set) exports for each group of kernels: plain pointers and plain data, nothing that
// the linker could merge with another target's.
#pragma once
namespace airlight {

struct TableView {
  const void* texels;  // RGBA of the target's element
  int width, height, depth;
};
struct PassArguments {
  const double* parameters;
  const TableView* tables;
  int width, height, depth;
  int row_begin, row_end;  // rows are counted through all slices: row = slice * height + y
  void* outputs[4];        // whole tables of the target's element, or (to_float) rows from row_begin on, as float
  int output_count;
  bool to_float;
};
struct EvalArguments {
  const double* uniforms;
  const double* varying;  // components, each `count` values
  int count;
  double* results;  // components, each `count` values
  double uniform(int i) const { return uniforms[i]; }
};
using PassEntry = void (*)(const PassArguments&);
using EvalEntry = void (*)(const EvalArguments&);

struct KernelTarget {
  int lanes;
  int element_size;
  const PassEntry* passes;
  const EvalEntry* evals;
};

}  // namespace airlight
