#pragma once
#include <memory>
#include <span>

#include "airlight/engine.h"
#include "engine/kernel_index.h"

namespace airlight {

/// Runs passes as OpenGL 4.5 compute shaders, without a window. Safe to share between threads: calls wait for each other, and the
/// caller's own current context is put back after each.
/// @param groups  what PassInfo::group and FunctionInfo::group count; tests bring kernels of their own
/// @throws WorkError where no OpenGL 4.5 core context can be had through EGL.
std::shared_ptr<Engine> make_gl_engine(std::span<const KernelGroup> groups = kernel_groups());

/// The same passes as draws of OpenGL ES 3.0, which is what WebGL2 is: proves the browser's path. Its name is "gles".
/// @throws WorkError where no OpenGL ES 3.0 context with float render targets can be had through EGL.
std::shared_ptr<Engine> make_gles_engine(std::span<const KernelGroup> groups = kernel_groups());

}  // namespace airlight
