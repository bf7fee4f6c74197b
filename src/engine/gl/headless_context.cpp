#include "engine/gl/headless_context.h"

#include <dlfcn.h>
#include <epoxy/gl.h>

#include <array>
#include <utility>
#include <vector>

#include "airlight/error.h"

namespace airlight {
namespace {

struct Place {
  std::string name;
  EGLDisplay display;
};

std::vector<Place> places() {
  std::vector<Place> found;
  const auto has = [](const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); };
  if (has("EGL_MESA_platform_surfaceless")) {
    found.push_back({"surfaceless platform",
                     eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
  }
  if (has("EGL_EXT_platform_device") && (has("EGL_EXT_device_base") || has("EGL_EXT_device_enumeration"))) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count);
    for (int i = 0; i < count; ++i) {
      found.push_back(
          {"device " + std::to_string(i), eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
    }
  }
  found.push_back({"default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
  return found;
}

std::string egl_error() {
  char text[32];
  std::snprintf(text, sizeof text, "EGL error 0x%04x", unsigned(eglGetError()));
  return text;
}

EGLContext create(EGLDisplay display, GlApi api, std::string& why) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    why = "no display (" + egl_error() + ")";
    return EGL_NO_CONTEXT;
  }
  if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context") ||
      !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
    why = "no contexts without a window";
    return EGL_NO_CONTEXT;
  }
  const EGLint core[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  eglBindAPI(api == GlApi::es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, api == GlApi::es ? es : core);
  if (context == EGL_NO_CONTEXT) why = "refused the context (" + egl_error() + ")";
  return context;
}

bool is_software(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"}) {
    if (renderer.find(name) != std::string::npos) return true;
  }
  return false;
}

// libepoxy ends the program where a library is missing, so look first.
bool has_library(std::initializer_list<const char*> any_of) {
  for (const char* name : any_of) {
    if (dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return true;  // kept open: the engine is about to use it
  }
  return false;
}

}  // namespace

HeadlessContext::HeadlessContext(GlApi api) : api_(api) {
  const std::string wanted = api == GlApi::es ? "OpenGL ES 3.0" : "OpenGL 4.5 core";
  const bool library =
      api == GlApi::es ? has_library({"libGLESv2.so.2"}) : has_library({"libOpenGL.so.0", "libGL.so.1"});
  if (!epoxy_has_egl() || !library)
    throw WorkError("no " + wanted + ": the OpenGL and EGL libraries are not installed");

  std::string tried;
  for (const Place& place : places()) {
    std::string why;
    const EGLContext context = create(place.display, api, why);
    if (context == EGL_NO_CONTEXT) {
      tried += (tried.empty() ? "" : "; ") + place.name + ": " + why;
      continue;
    }
    const EGLDisplay first_display = std::exchange(display_, place.display);
    const EGLContext first_context = std::exchange(context_, context);
    std::string renderer;
    try {
      const Current current(*this);
      renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    } catch (const WorkError& error) {
      tried += (tried.empty() ? "" : "; ") + place.name + ": " + error.what();
    }
    if (!renderer.empty() && (first_context == EGL_NO_CONTEXT || !is_software(renderer))) {
      if (first_context != EGL_NO_CONTEXT) eglDestroyContext(first_display, first_context);
      renderer_ = renderer;
      if (!is_software(renderer)) break;
    } else {
      eglDestroyContext(display_, context_);
      display_ = first_display;
      context_ = first_context;
    }
  }
  if (context_ == EGL_NO_CONTEXT) throw WorkError("no " + wanted + " context through EGL (" + tried + ")");
}

// Displays are shared by the whole process, so none is terminated.
HeadlessContext::~HeadlessContext() { eglDestroyContext(display_, context_); }

HeadlessContext::Current::Current(HeadlessContext& context)
    : lock_(context.mutex_),
      context_(context),
      display_(eglGetCurrentDisplay()),
      draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)),
      previous_(eglGetCurrentContext()) {
  if (previous_ == context.context_) return;
  if (!eglMakeCurrent(context.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_)) {
    throw WorkError("cannot make the OpenGL context current (" + egl_error() + ")");
  }
}

HeadlessContext::Current::~Current() {
  if (previous_ == context_.context_) return;
  if (previous_ == EGL_NO_CONTEXT)
    eglMakeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  else
    eglMakeCurrent(display_, draw_, read_, previous_);
}

}  // namespace airlight
