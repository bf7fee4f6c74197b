// A program of its own, with a context, a world and conventions of its own (y up, kilometres, reversed depth), that puts Airlight's
// haze over its frame. It links nothing of Airlight's: kernels and tables are files.
//
// usage: embed_gl KERNELS TABLES FOLDER    writes FOLDER/hazed.ppm, and scene.f32 (colour, depth) and hazed.f32 for those who check
#include <epoxy/egl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>

#include "airlight_files.h"

namespace {

constexpr int width = 640, height = 360;
constexpr float near_plane = 1e-4f;        // [km]
constexpr float white_luminance = 25'000;  // a matt white wall in the sun [cd/m2]
constexpr float pi = 3.14159265f;
constexpr float azimuth = 20 * pi / 180, elevation = -4 * pi / 180, field_of_view = 60 * pi / 180;

using Vector = std::array<float, 3>;

void open_context() {
  const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  eglBindAPI(EGL_OPENGL_API);
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
      !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted)))
    throw std::runtime_error("skipped: no OpenGL 4.5 without a window (EGL, surfaceless)");
}

GLuint compile(GLenum stage, const std::string& text) {
  const char* start = text.c_str();
  const GLuint program = glCreateShaderProgramv(stage, 1, &start);
  std::array<char, 4096> log{};
  glGetProgramInfoLog(program, log.size(), nullptr, log.data());
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw std::runtime_error(std::string("shader: ") + log.data());
  return program;
}

GLuint pipeline(GLuint vertex, GLuint fragment) {
  GLuint name = 0;
  glCreateProgramPipelines(1, &name);
  glUseProgramStages(name, GL_VERTEX_SHADER_BIT, vertex);
  glUseProgramStages(name, GL_FRAGMENT_SHADER_BIT, fragment);
  return name;
}

GLuint target(GLenum format) {
  GLuint texture = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, 1, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return texture;
}

void set(GLuint program, const char* name, const Vector& v) {
  glProgramUniform3fv(program, glGetUniformLocation(program, name), 1, v.data());
}
void set(GLuint program, const char* name, float v) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), v);
}

// The world: hills from 2 to 42 km ahead as a grid of 400 x 400 squares, and nine towers, all made of gl_VertexID.
const char* const world_vertex = R"(#version 450 core
out gl_PerVertex { vec4 gl_Position; };
uniform vec3 eye, right, up, forward;
uniform float near_plane;
out vec3 world;
out vec3 albedo;
float hills(vec2 p) {
  return 0.25 + 0.3 * sin(0.9 * p.x + 0.4 * sin(0.7 * p.y)) * sin(0.55 * p.y) + 0.06 * sin(3.1 * p.x + 2.3 * p.y);
}
void main() {
  if (gl_InstanceID == 0) {
    int square = gl_VertexID / 6, corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
    vec2 part = (vec2(square % 400, square / 400) + vec2(corner % 2, corner / 2)) / 400.0;
    vec2 ahead = vec2((part.x - 0.5) * 60.0, -2.0 - 40.0 * part.y * part.y);
    world = vec3(ahead.x, hills(ahead), ahead.y);
    albedo = mix(vec3(0.07, 0.1, 0.04), vec3(0.3, 0.27, 0.24), smoothstep(0.2, 0.5, world.y));
  } else {
    int face = gl_VertexID / 6 % 6, corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
    vec3 p = vec3(corner % 2, corner / 2, face % 2);
    p = face < 2 ? p : face < 4 ? p.yzx : p.zxy;
    vec2 foot = vec2(-1.5 + 1.1 * float(gl_InstanceID), -3.0 - 0.35 * float(gl_InstanceID * gl_InstanceID));
    world = vec3(foot.x, hills(foot) - 0.05, foot.y) + p * vec3(0.25, 0.8, 0.25);
    albedo = vec3(0.6, 0.55, 0.5);
  }
  vec3 p = world - eye;
  // Reversed depth with an infinite far plane: z = near, w = depth. `right` and `up` are as long as the picture's half sides at depth 1.
  gl_Position = vec4(dot(p, right) / dot(right, right), dot(p, up) / dot(up, up), near_plane, dot(p, forward));
})";
const char* const world_fragment = R"(#version 450 core
in vec3 world;
in vec3 albedo;
uniform vec3 eye, sun;
out vec4 colour;
void main() {
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  if (dot(normal, world - eye) > 0.0) normal = -normal;
  colour = vec4(albedo * (max(dot(normal, sun), 0.0) * vec3(1.0, 0.95, 0.85) + vec3(0.12, 0.15, 0.2)), 1.0);
})";
const char* const screen_vertex = R"(#version 450 core
out gl_PerVertex { vec4 gl_Position; };
out vec2 at;
void main() {
  at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
  gl_Position = vec4(at, 0.0, 1.0);
})";

std::vector<float> read(GLuint framebuffer, GLenum format, int components) {
  std::vector<float> pixels(std::size_t(width * height * components));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadPixels(0, 0, width, height, format, GL_FLOAT, pixels.data());
  return pixels;
}

void write(const fs::path& path, const void* bytes, std::size_t size, const std::string& head = {}) {
  std::ofstream file(path, std::ios::binary);
  file << head;
  file.write(static_cast<const char*>(bytes), std::streamsize(size));
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

void run(const fs::path& kernels, const fs::path& folder_of_tables, const fs::path& out) {
  open_context();
  const Tables tables(folder_of_tables);
  const std::vector<float> observer_sun = tables.index["observer"]["sun"];
  const Vector sun{observer_sun[0], observer_sun[2], -observer_sun[1]};        // y up, -z north
  const Vector eye{0, float(tables.index["observer"]["altitude"]) / 1000, 0};  // the tables are this observer's
  const float across = std::tan(field_of_view / 2), along = across * height / width;
  const float s = std::sin(azimuth), c = std::cos(azimuth), rise = std::sin(elevation), level = std::cos(elevation);
  const Vector forward{level * s, rise, -level * c}, right{c * across, 0, s * across},
      up{-rise * s * along, level * along, rise * c * along};

  GLuint nothing = 0, scene = 0, haze = 0;
  glCreateVertexArrays(1, &nothing);
  glBindVertexArray(nothing);
  glViewport(0, 0, width, height);
  const GLuint colour = target(GL_RGBA32F), depth = target(GL_DEPTH_COMPONENT32F), result = target(GL_RGBA32F);
  glCreateFramebuffers(1, &scene);
  glNamedFramebufferTexture(scene, GL_COLOR_ATTACHMENT0, colour, 0);
  glNamedFramebufferTexture(scene, GL_DEPTH_ATTACHMENT, depth, 0);
  glCreateFramebuffers(1, &haze);
  glNamedFramebufferTexture(haze, GL_COLOR_ATTACHMENT0, result, 0);

  // The engine's own frame.
  const GLuint world = compile(GL_VERTEX_SHADER, world_vertex), paint = compile(GL_FRAGMENT_SHADER, world_fragment);
  set(world, "eye", eye), set(world, "right", right), set(world, "up", up), set(world, "forward", forward);
  set(world, "near_plane", near_plane), set(paint, "eye", eye), set(paint, "sun", sun);
  glBindFramebuffer(GL_FRAMEBUFFER, scene);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glClearDepth(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glBindProgramPipeline(pipeline(world, paint));
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * 400 * 400, 1);
  glDrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, 36, 10, 0);

  // Airlight over it.
  std::set<std::string> seen;
  std::ifstream own(SHADER);
  const GLuint fog =
      compile(GL_FRAGMENT_SHADER, "#version 450 core\n" + kernel_text(kernels, "prelude/prelude.glsl", seen) +
                                      kernel_text(kernels, "skyview/skyview.glsl", seen) +
                                      std::string(std::istreambuf_iterator<char>(own), {}));
  set(fog, "right", right), set(fog, "up", up), set(fog, "forward", forward);
  set(fog, "near_plane", near_plane), set(fog, "white_luminance", white_luminance);
  glBindTextureUnit(0, colour), glProgramUniform1i(fog, glGetUniformLocation(fog, "scene_colour"), 0);
  glBindTextureUnit(1, depth), glProgramUniform1i(fog, glGetUniformLocation(fog, "scene_depth"), 1);
  tables.bind(fog, 2);
  glBindFramebuffer(GL_FRAMEBUFFER, haze);
  glDisable(GL_DEPTH_TEST);
  glBindProgramPipeline(pipeline(compile(GL_VERTEX_SHADER, screen_vertex), fog));
  glDrawArrays(GL_TRIANGLES, 0, 3);

  std::vector<float> before = read(scene, GL_RGBA, 4), hazed = read(haze, GL_RGBA, 4);
  const std::vector<float> depths = read(scene, GL_DEPTH_COMPONENT, 1);
  std::vector<unsigned char> bytes;
  for (int row = height - 1; row >= 0; --row) {  // OpenGL's rows begin at the bottom
    for (int i = row * width; i < (row + 1) * width; ++i) {
      for (int k = 0; k < 3; ++k)
        bytes.push_back(
            (unsigned char)(255.5f * std::pow(1 - std::exp(-std::max(hazed[4 * i + k], 0.0f) / 8'000), 1 / 2.2f)));
      before[4 * i + 3] = depths[i];
    }
  }
  write(out / "scene.f32", before.data(), 4 * before.size());
  write(out / "hazed.f32", hazed.data(), 4 * hazed.size());
  write(out / "hazed.ppm", bytes.data(), bytes.size(), "P6 640 360 255\n");
  std::cout << "hazed.ppm: " << width << " x " << height << " on " << glGetString(GL_RENDERER) << '\n';
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count != 4) throw std::runtime_error("usage: embed_gl KERNELS TABLES FOLDER");
    run(words[1], words[2], words[3]);
  } catch (const std::exception& error) {
    std::cerr << "embed_gl: " << error.what() << '\n';
    return 1;
  }
}
