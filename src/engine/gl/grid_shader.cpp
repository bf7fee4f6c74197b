#include "engine/gl/grid_shader.h"

#include <algorithm>
#include <array>

#include "airlight/error.h"

namespace airlight {
namespace {

/// Slices of textures to draw into or to read from, bound while it lives.
class Framebuffer {
 public:
  Framebuffer() {
    glGenFramebuffers(1, &name_);
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
  }
  ~Framebuffer() { glDeleteFramebuffers(1, &name_); }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  void attach(int index, const GlTexture& texture, int slice) const {
    const GLenum point = GLenum(GL_COLOR_ATTACHMENT0 + index);
    if (texture.target() == GL_TEXTURE_3D)
      glFramebufferTextureLayer(GL_FRAMEBUFFER, point, texture.name(), 0, slice);
    else
      glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.name(), 0);
  }

 private:
  GLuint name_ = 0;
};

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  glGetShaderInfoLog(shader, length, &length, log.data());
  log.resize(std::size_t(length));
  return log;
}
std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  glGetProgramInfoLog(program, length, &length, log.data());
  log.resize(std::size_t(length));
  return log;
}

/// Compiles and attaches; the shader lives as long as its program.
void add_shader(GLuint program, GLenum kind, const char* text, std::span<const std::string> files,
                const std::string& subject) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = compiled ? "" : shader_log(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  if (!compiled) throw WorkError("the shader of " + subject + " does not compile:\n" + name_files(log, files));
}

}  // namespace

void check_gl(const HeadlessContext& context, const std::string& doing) {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  char code[16];
  std::snprintf(code, sizeof code, "0x%04x", unsigned(first));
  throw WorkError("OpenGL error " + std::string(code) + (first == GL_OUT_OF_MEMORY ? " (out of memory)" : "") +
                  " while " + doing + " on " + context.renderer());
}

GlTexture::GlTexture(std::shared_ptr<HeadlessContext> context, Shape shape, std::span<const float> rgba)
    : context_(std::move(context)), shape_(shape) {
  const HeadlessContext::Current current(*context_);
  const std::string size = std::to_string(shape.width) + " x " + std::to_string(shape.height) +
                           (shape.depth > 1 ? " x " + std::to_string(shape.depth) : "");
  GLint most = 0;
  glGetIntegerv(shape.depth > 1 ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &most);
  if (std::max({shape.width, shape.height, shape.depth}) > most) {
    throw WorkError("a table of " + size + " texels is too large for " + context_->renderer() + ": at most " +
                    std::to_string(most) + " each way");
  }
  glGenTextures(1, &name_);
  glBindTexture(target(), name_);
  if (shape.depth > 1)
    glTexStorage3D(target(), 1, GL_RGBA32F, shape.width, shape.height, shape.depth);
  else
    glTexStorage2D(target(), 1, GL_RGBA32F, shape.width, shape.height);
  glTexParameteri(target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  if (!rgba.empty()) {
    if (shape.depth > 1)
      glTexSubImage3D(target(), 0, 0, 0, 0, shape.width, shape.height, shape.depth, GL_RGBA, GL_FLOAT, rgba.data());
    else
      glTexSubImage2D(target(), 0, 0, 0, shape.width, shape.height, GL_RGBA, GL_FLOAT, rgba.data());
  }
  try {
    check_gl(*context_, "making a table of " + size + " texels");
  } catch (...) {
    glDeleteTextures(1, &name_);
    throw;
  }
}

GlTexture::~GlTexture() {
  const HeadlessContext::Current current(*context_);
  glDeleteTextures(1, &name_);
}

void GlTexture::read(std::span<float> rgba) const {
  const HeadlessContext::Current current(*context_);
  const Framebuffer framebuffer;
  for (int slice = 0; slice < shape_.depth; ++slice) {
    framebuffer.attach(0, *this, slice);
    glReadPixels(0, 0, shape_.width, shape_.height, GL_RGBA, GL_FLOAT,
                 rgba.data() + 4 * std::size_t(slice) * std::size_t(shape_.width) * std::size_t(shape_.height));
  }
  check_gl(*context_, "reading a table");
}

GridShader::GridShader(std::shared_ptr<HeadlessContext> context, const ShaderText& shader, std::string subject)
    : context_(std::move(context)), subject_(std::move(subject)) {
  const HeadlessContext::Current current(*context_);
  program_ = glCreateProgram();
  try {
    if (context_->api() == GlApi::es) {
      add_shader(program_, GL_VERTEX_SHADER, window_vertex_shader, {}, subject_);
      add_shader(program_, GL_FRAGMENT_SHADER, shader.text.c_str(), shader.files, subject_);
    } else {
      add_shader(program_, GL_COMPUTE_SHADER, shader.text.c_str(), shader.files, subject_);
    }
    glLinkProgram(program_);
    GLint linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked)
      throw WorkError("the shader of " + subject_ + " does not link:\n" +
                      name_files(program_log(program_), shader.files));
  } catch (...) {
    glDeleteProgram(program_);
    throw;
  }
  glUseProgram(program_);
  for (int i = 0; i < shader.tables; ++i)
    glUniform1i(glGetUniformLocation(program_, ("main_table" + std::to_string(i)).c_str()), i);
  if (context_->api() == GlApi::desktop) {
    for (int i = 0; i < shader.outputs; ++i)
      glUniform1i(glGetUniformLocation(program_, ("main_image" + std::to_string(i)).c_str()), i);
  }
  const GLuint block = glGetUniformBlockIndex(program_, "main_Parameters");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_, block, 0);
  place_ = glGetUniformLocation(program_, "main_place");
  rows_ = glGetUniformLocation(program_, "main_rows");
  check_gl(*context_, "setting up " + subject_);
}

GridShader::~GridShader() {
  const HeadlessContext::Current current(*context_);
  glDeleteProgram(program_);
}

void GridShader::run(std::span<const float> parameters, std::span<const GlTexture* const> tables,
                     std::span<const GlTexture* const> targets, Window window) const {
  const HeadlessContext::Current current(*context_);
  glUseProgram(program_);
  glUniform4i(place_, window.grid.width, window.grid.height, window.grid.depth, window.first_row);
  GLuint block = 0;
  if (!parameters.empty()) {
    glGenBuffers(1, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(parameters.size_bytes()), parameters.data(), GL_STREAM_DRAW);
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    glActiveTexture(GLenum(GL_TEXTURE0 + i));
    glBindTexture(tables[i]->target(), tables[i]->name());
  }
  const Shape size = targets.front()->shape();
  const int begin = window.begin, end = std::min(window.end, size.height);
  if (context_->api() == GlApi::desktop) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      glBindImageTexture(GLuint(i), targets[i]->name(), 0, GL_FALSE, window.slice, GL_WRITE_ONLY, GL_RGBA32F);
    }
    glUniform2i(rows_, begin, end);
    glDispatchCompute(GLuint(size.width + 7) / 8, GLuint(end - begin + 7) / 8, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
  } else {
    const Framebuffer framebuffer;
    std::array<GLenum, 4> buffers{};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      framebuffer.attach(int(i), *targets[i], window.slice);
      buffers[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
    }
    glDrawBuffers(GLsizei(targets.size()), buffers.data());
    glViewport(0, 0, size.width, size.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, begin, size.width, end - begin);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
  }
  glDeleteBuffers(1, &block);
  check_gl(*context_, "running " + subject_);
}

}  // namespace airlight
