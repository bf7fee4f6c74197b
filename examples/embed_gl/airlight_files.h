// Airlight's kernels and tables as files in an OpenGL program: all that an engine has to copy.
#pragma once
#include <epoxy/gl.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;

/// A kernel file and what it includes, each once. Goes behind #version and prelude/prelude.glsl.
inline std::string kernel_text(const fs::path& kernels, const std::string& file, std::set<std::string>& seen) {
  if (!seen.insert(file).second) return {};
  std::ifstream in(kernels / file);
  if (!in) throw std::runtime_error("cannot read " + (kernels / file).string());
  std::string text, line;
  while (std::getline(in, line)) {
    if (line.starts_with("#include \""))
      text += kernel_text(kernels, line.substr(10, line.rfind('"') - 10), seen);
    else if (!line.starts_with("#pragma once"))
      text += line + '\n';
  }
  return text;
}

/// What `airlight tables` wrote: textures for the samplers, numbers for the uniform structs, both by name.
class Tables {
 public:
  explicit Tables(const fs::path& folder) {
    std::ifstream in(folder / "tables.json");
    if (!in) throw std::runtime_error("cannot read " + (folder / "tables.json").string());
    index = nlohmann::json::parse(in);
    for (const auto& [name, table] : index["tables"].items()) {
      const int width = table["width"], height = table["height"], depth = table["depth"];
      std::vector<float> texels(4 * std::size_t(width) * std::size_t(height) * std::size_t(depth));
      std::ifstream raw(folder / std::string(table["raw"]), std::ios::binary);
      raw.read(reinterpret_cast<char*>(texels.data()), std::streamsize(texels.size() * sizeof(float)));
      if (!raw) throw std::runtime_error("cannot read the table " + name);
      // Never filtered by the hardware, whose weights have 8 bits: kernels fetch texels and mix them.
      GLuint texture = 0;
      const GLenum target = depth > 1 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
      glCreateTextures(target, 1, &texture);
      glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      if (depth > 1) {
        glTextureStorage3D(texture, 1, GL_RGBA32F, width, height, depth);
        glTextureSubImage3D(texture, 0, 0, 0, 0, width, height, depth, GL_RGBA, GL_FLOAT, texels.data());
      } else {
        glTextureStorage2D(texture, 1, GL_RGBA32F, width, height);
        glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
      }
      textures_[name] = texture;
    }
  }

  /// Sets the program's uniforms of these names, from texture unit `unit` on; what it does not use is passed over.
  void bind(GLuint program, int unit) const {
    for (const auto& [name, texture] : textures_) {
      const GLint sampler = glGetUniformLocation(program, name.c_str());
      if (sampler < 0) continue;
      glBindTextureUnit(GLuint(unit), texture);
      glProgramUniform1i(program, sampler, unit++);
    }
    for (const char* block : {"air", "observer", "dome", "froxels"}) {
      for (const auto& [field, value] : index[block].items()) {
        const GLint place = glGetUniformLocation(program, (std::string(block) + '.' + field).c_str());
        if (value.is_array())
          glProgramUniform4fv(program, place, 1, value.get<std::vector<float>>().data());
        else
          glProgramUniform1f(program, place, value);
      }
    }
    glProgramUniformMatrix4x3fv(program, glGetUniformLocation(program, "to_srgb"), 1, GL_TRUE, rows("to_srgb").data());
    glProgramUniformMatrix3x4fv(program, glGetUniformLocation(program, "from_srgb"), 1, GL_TRUE,
                                rows("from_srgb").data());
  }

  nlohmann::json index;

 private:
  std::vector<float> rows(const char* matrix) const {
    std::vector<float> numbers;
    for (const auto& row : index[matrix])
      for (const float number : row) numbers.push_back(number);
    return numbers;
  }

  std::map<std::string, GLuint> textures_;
};
