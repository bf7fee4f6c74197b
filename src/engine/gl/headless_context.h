#pragma once
#include <epoxy/egl.h>

#include <mutex>
#include <string>

namespace airlight {

enum class GlApi { desktop, es };  ///< OpenGL 4.5 core, OpenGL ES 3.0

/// An OpenGL context without a window.
class HeadlessContext {
 public:
  /// Tries Mesa's surfaceless platform, then each EGL device, then the default display; a graphics processor goes before Mesa's
  /// software driver.
  /// @throws WorkError naming what was tried.
  explicit HeadlessContext(GlApi api);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  GlApi api() const { return api_; }
  const std::string& renderer() const { return renderer_; }

  /// While it lives, the context is current on this thread and other threads wait for it. Then what was current before is so
  /// again. May be nested.
  class Current {
   public:
    explicit Current(HeadlessContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    std::lock_guard<std::recursive_mutex> lock_;
    HeadlessContext& context_;
    EGLDisplay display_;
    EGLSurface draw_, read_;
    EGLContext previous_;
  };

 private:
  GlApi api_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string renderer_;
  std::recursive_mutex mutex_;
};

}  // namespace airlight
