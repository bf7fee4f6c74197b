// GLSL around kernels: one shader computes a pass, or a function, at every texel of a grid.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/headless_context.h"
#include "engine/kernel_index.h"

namespace airlight {

/// All names begin with `main_`:
///   ivec4 main_place     width, height and depth of the grid; the row, counted through all slices, of the window's first
///   main_Parameters      uniform block: a pass's structs in order; a function's uniform arguments, packed
///   main_table0, ...     a pass's tables; a function's varying arguments, four components a texel, plane below plane
///   main_image0, ...     the window's images (compute); draw buffers in OpenGL ES
struct ShaderText {
  std::string text;
  std::vector<std::string> files;  ///< what the source numbers in the compiler's messages stand for
  int tables = 0;
  int outputs = 0;
};
ShaderText pass_shader(GlApi api, const KernelGroup& group, const PassInfo& pass);
ShaderText function_shader(GlApi api, const KernelGroup& group, const FunctionInfo& function);

/// A triangle over the whole window, for OpenGL ES.
extern const char* const window_vertex_shader;

/// Planes of four components that a function's varying arguments or results fill.
int planes(int components);
int uniform_components(const FunctionInfo& function);
int varying_components(const FunctionInfo& function);
int result_components(const FunctionInfo& function);

/// A compiler's log with "3:45" (Mesa) and "3(45)" (NVIDIA) turned into "kernels/core/math.glsl:45".
std::string name_files(std::string_view log, std::span<const std::string> files);

}  // namespace airlight
