// OpenGL's textures and the one kind of program we run: values at every texel of a window of a grid.
#pragma once
#include <epoxy/gl.h>

#include <limits>
#include <memory>
#include <span>
#include <string>

#include "airlight/engine.h"
#include "engine/gl/headless_context.h"
#include "engine/gl/shader_text.h"

namespace airlight {

/// RGBA32F texels: a 3-D texture where the depth is above 1.
class GlTexture {
 public:
  /// @param rgba  its texels, or nothing
  /// @throws WorkError where it is larger than this OpenGL allows, or memory runs out.
  GlTexture(std::shared_ptr<HeadlessContext> context, Shape shape, std::span<const float> rgba);
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  GLuint name() const { return name_; }
  Shape shape() const { return shape_; }
  GLenum target() const { return shape_.depth > 1 ? GL_TEXTURE_3D : GL_TEXTURE_2D; }
  /// Copies texels out, slice by slice.
  void read(std::span<float> rgba) const;

 private:
  std::shared_ptr<HeadlessContext> context_;
  Shape shape_;
  GLuint name_ = 0;
};

class GridShader {
 public:
  /// @param subject  the pass or function, for messages
  /// @throws WorkError with the compiler's log, in which kernels' files and lines are named.
  GridShader(std::shared_ptr<HeadlessContext> context, const ShaderText& shader, std::string subject);
  ~GridShader();
  GridShader(const GridShader&) = delete;
  GridShader& operator=(const GridShader&) = delete;

  struct Window {
    Shape grid;
    int first_row;                                         ///< of the window, counted through all slices of the grid
    int slice;                                             ///< of the targets that the window is written to
    int begin = 0, end = std::numeric_limits<int>::max();  ///< rows of the targets that are filled
  };
  /// Fills one slice of each target, or some of its rows.
  void run(std::span<const float> parameters, std::span<const GlTexture* const> tables,
           std::span<const GlTexture* const> targets, Window window) const;

 private:
  std::shared_ptr<HeadlessContext> context_;
  std::string subject_;
  GLuint program_ = 0;
  GLint place_ = -1, rows_ = -1;
};

/// @throws WorkError where OpenGL reported an error.
void check_gl(const HeadlessContext& context, const std::string& doing);

}  // namespace airlight
