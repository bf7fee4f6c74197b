#include "engine/gl/shader_text.h"

#include <cassert>
#include <regex>

namespace airlight {
namespace {

// Indices: KernelType.
constexpr const char* type_names[] = {"Float",   "Vec2", "Vec3", "Vec4",   "Bool",  "Scalar",
                                      "Scalar4", "int",  "",     "Table2", "Table3"};
const char* spelled(KernelType type) { return type_names[static_cast<int>(type)]; }
bool is_uniform(KernelType type) {
  return type == KernelType::Scalar || type == KernelType::Scalar4 || type == KernelType::Int ||
         type == KernelType::Struct;
}
int size_of(const ArgumentInfo& a) {
  return a.type == KernelType::Struct ? kernel_struct(a.struct_name).numbers : components(a.type);
}

std::string numbered(const char* name, int i) { return name + std::to_string(i); }

/// Version, kernels with their own line numbers, and what every main() needs.
void begin(ShaderText& shader, GlApi api, const KernelGroup& group) {
  shader.text = api == GlApi::es ? "#version 300 es\n" : "#version 450 core\n";
  for (const KernelSource* source : group.sources) {
    shader.text += "#line 1 " + std::to_string(shader.files.size()) + "\n";
    shader.files.emplace_back(source->file);
    std::string_view rest = source->text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
      const std::string_view line = rest.substr(0, end);
      // For the C++ compiler: here the group's sources already come in order, each once.
      const bool other = line.starts_with("#pragma") || line.starts_with("#include");
      shader.text += other ? std::string_view("\n") : line;
      rest.remove_prefix(end);
    }
    shader.text += "\n";
  }
}

/// The rest: declarations, then main() with `body`, which sets main_out0, main_out1, ... from ivec2 main_at.
void end(ShaderText& shader, GlApi api, const std::string& subject, const std::string& declarations,
         const std::string& body) {
  std::string& t = shader.text;
  t += "#line 1 " + std::to_string(shader.files.size()) + "\n";
  shader.files.push_back("main() of " + subject);
  t += "uniform ivec4 main_place;\n" + declarations;
  if (api == GlApi::es) {
    for (int i = 0; i < shader.outputs; ++i)
      t += "layout(location = " + std::to_string(i) + ") out vec4 " + numbered("main_out", i) + ";\n";
    t += "void main() {\n  ivec2 main_at = ivec2(gl_FragCoord.xy);\n" + body + "}\n";
    return;
  }
  t += "layout(local_size_x = 8, local_size_y = 8) in;\n";
  for (int i = 0; i < shader.outputs; ++i)
    t += "layout(rgba32f) writeonly uniform image2D " + numbered("main_image", i) + ";\n";
  t += "uniform ivec2 main_rows;\n"
       "void main() {\n  ivec2 main_at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, main_rows.x);\n"
       "  if (main_at.x >= imageSize(main_image0).x || main_at.y >= main_rows.y) return;\n";
  for (int i = 0; i < shader.outputs; ++i) t += "  vec4 " + numbered("main_out", i) + ";\n";
  t += body;
  for (int i = 0; i < shader.outputs; ++i)
    t += "  imageStore(" + numbered("main_image", i) + ", main_at, " + numbered("main_out", i) + ");\n";
  t += "}\n";
}

// One value of a type from numbered components: component(at) spells one of them.
template <class Component>
std::string value_of(KernelType type, int at, const Component& component) {
  if (type == KernelType::Bool) return "(" + component(at) + " > 0.5)";
  std::string list = component(at);
  for (int i = 1; i < components(type); ++i) list += ", " + component(at + i);
  return std::string(spelled(type)) + "(" + list + ")";
}
template <class Component>
std::string value_of(const ArgumentInfo& a, int at, const Component& component) {
  if (a.type != KernelType::Struct) return value_of(a.type, at, component);
  std::string list;
  for (const ArgumentInfo& field : kernel_struct(a.struct_name).fields) {
    list += (list.empty() ? "" : ", ") + value_of(field.type, at, component);
    at += components(field.type);
  }
  return std::string(a.struct_name) + "(" + list + ")";
}

void list_components(std::vector<std::string>& into, KernelType type, const std::string& name) {
  if (type == KernelType::Bool)
    into.push_back("(" + name + " ? 1.0 : 0.0)");
  else if (components(type) == 1)
    into.push_back("float(" + name + ")");
  else
    for (int i = 0; i < components(type); ++i) into.push_back(name + "." + "xyzw"[i]);
}

}  // namespace

const char* const window_vertex_shader =
    "#version 300 es\n"
    "void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }\n";

int planes(int components) { return (components + 3) / 4; }

int uniform_components(const FunctionInfo& function) {
  int sum = 0;
  for (const ArgumentInfo& a : function.arguments) sum += !a.out && is_uniform(a.type) ? size_of(a) : 0;
  return sum;
}
int varying_components(const FunctionInfo& function) {
  int sum = 0;
  for (const ArgumentInfo& a : function.arguments) sum += !a.out && !is_uniform(a.type) ? size_of(a) : 0;
  return sum;
}
int result_components(const FunctionInfo& function) {
  int sum = function.returns_nothing ? 0 : components(function.result);
  for (const ArgumentInfo& a : function.arguments) sum += a.out ? size_of(a) : 0;
  return sum;
}

ShaderText pass_shader(GlApi api, const KernelGroup& group, const PassInfo& pass) {
  ShaderText shader;
  begin(shader, api, group);
  shader.tables = int(pass.tables.size());
  shader.outputs = int(pass.outputs.size());
  std::string declarations, call;
  if (!pass.parameters.empty()) {
    // Structs hold Scalar4s, then Scalars, padded to 16 bytes: their numbers one after the other are std140.
    declarations += "layout(std140) uniform main_Parameters {\n";
    for (std::size_t i = 0; i < pass.parameters.size(); ++i) {
      declarations +=
          "  " + std::string(pass.parameters[i].struct_name) + " " + numbered("main_struct", int(i)) + ";\n";
      call += numbered("main_struct", int(i)) + ", ";
    }
    declarations += "};\n";
  }
  for (int i = 0; i < shader.tables; ++i) {
    declarations += std::string("uniform ") + spelled(pass.tables[i].type) + " " + numbered("main_table", i) + ";\n";
    call += numbered("main_table", i) + ", ";
  }
  call += pass.slices ? "main_uvw" : "main_uvw.xy";
  for (int i = 1; i < shader.outputs; ++i) call += ", " + numbered("main_out", i);
  std::string body =
      "  int main_row = main_place.w + main_at.y;\n"
      "  vec3 main_texel = vec3(ivec3(main_at.x, main_row % main_place.y, main_row / main_place.y)) + 0.5;\n"
      "  vec3 main_uvw = main_texel / vec3(main_place.xyz);\n";
  for (int i = 1; i < shader.outputs; ++i) body += "  " + numbered("main_out", i) + " = vec4(0.0);\n";
  body += "  main_out0 = " + std::string(pass.kernel_name) + "(" + call + ");\n";
  end(shader, api, std::string(pass.name), declarations, body);
  return shader;
}

ShaderText function_shader(GlApi api, const KernelGroup& group, const FunctionInfo& function) {
  ShaderText shader;
  begin(shader, api, group);
  const int uniforms = planes(uniform_components(function)), varyings = planes(varying_components(function));
  shader.tables = varyings > 0 ? 1 : 0;
  shader.outputs = planes(result_components(function));
  std::string declarations, body, call;
  if (uniforms > 0)
    declarations +=
        "layout(std140) uniform main_Parameters { vec4 main_uniform[" + std::to_string(uniforms) + "]; };\n";
  if (varyings > 0) declarations += "uniform sampler2D main_table0;\n";
  for (int i = 0; i < varyings; ++i) {
    body += "  vec4 " + numbered("main_in", i) + " = texelFetch(main_table0, main_at + ivec2(0, " + std::to_string(i) +
            " * main_place.y), 0);\n";
  }
  const auto uniform = [](int at) { return "main_uniform[" + std::to_string(at / 4) + "]." + "xyzw"[at % 4]; };
  const auto varying = [](int at) { return numbered("main_in", at / 4) + "." + "xyzw"[at % 4]; };
  std::vector<std::string> results;
  if (!function.returns_nothing) list_components(results, function.result, "main_result");
  int uniform_at = 0, varying_at = 0;
  for (std::size_t i = 0; i < function.arguments.size(); ++i) {
    const ArgumentInfo& a = function.arguments[i];
    call += call.empty() ? "" : ", ";
    if (a.out) {
      const std::string name = numbered("main_argument", int(i));
      body += std::string("  ") + spelled(a.type) + " " + name + " = " + spelled(a.type) + "(" +
              (a.type == KernelType::Bool ? "false" : "0.0") + ");\n";
      call += name;
      list_components(results, a.type, name);
    } else if (is_uniform(a.type)) {
      call += value_of(a, uniform_at, uniform);
      uniform_at += size_of(a);
    } else {
      call += value_of(a, varying_at, varying);
      varying_at += size_of(a);
    }
  }
  body += "  ";
  if (!function.returns_nothing) body += std::string(spelled(function.result)) + " main_result = ";
  body += std::string(function.kernel_name) + "(" + call + ");\n";
  results.resize(std::size_t(4 * shader.outputs), "0.0");
  for (int i = 0; i < shader.outputs; ++i) {
    body += "  " + numbered("main_out", i) + " = vec4(" + results[4 * i] + ", " + results[4 * i + 1] + ", " +
            results[4 * i + 2] + ", " + results[4 * i + 3] + ");\n";
  }
  end(shader, api, std::string(function.name), declarations, body);
  return shader;
}

std::string name_files(std::string_view log, std::span<const std::string> files) {
  // "0:12(34): error", "0(12) : error", "ERROR: 0:12: ..."
  static const std::regex place(R"(^(ERROR: |WARNING: )?(\d+)(?:\((\d+)\)|:(\d+)(?:\(\d+\))?))");
  std::string named;
  while (!log.empty()) {
    const std::size_t length = std::min(log.find('\n'), log.size() - 1) + 1;
    const std::string line(log.substr(0, length));
    log.remove_prefix(length);
    std::smatch match;
    if (std::regex_search(line, match, place) && std::stoul(match[2]) < files.size()) {
      named += files[std::stoul(match[2])] + ":" + (match[3].matched ? match[3].str() : match[4].str()) +
               match.suffix().str();
    } else {
      named += line;
    }
  }
  return named;
}

}  // namespace airlight
