#include "engine/gl/gl_engine.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "airlight/error.h"
#include "engine/gl/grid_shader.h"

namespace airlight {
namespace {

const GlTexture& texture_of(const Table& table) { return *static_cast<const GlTexture*>(table.storage.get()); }

std::vector<float> to_float(std::span<const double> values) {
  std::vector<float> floats(values.size());
  std::ranges::transform(values, floats.begin(), [](double v) { return static_cast<float>(v); });
  return floats;
}

class GlEngine final : public Engine {
 public:
  GlEngine(GlApi api, std::span<const KernelGroup> groups)
      : context_(std::make_shared<HeadlessContext>(api)), groups_(groups) {
    const HeadlessContext::Current current(*context_);
    if (api == GlApi::es) {
      if (!epoxy_has_gl_extension("GL_EXT_color_buffer_float")) {
        throw WorkError(context_->renderer() + " cannot draw into float textures (GL_EXT_color_buffer_float)");
      }
      glDisable(GL_DITHER);  // on by default in OpenGL ES
    }
  }

  std::string_view name() const override { return context_->api() == GlApi::es ? "gles" : "gl"; }
  std::string device() const override { return context_->renderer(); }

  void read(const Table& table, std::span<double> rgba) override {
    assert(rgba.size() == 4 * table.shape.texels());
    std::vector<float> texels(rgba.size());
    texture_of(table).read(texels);
    std::ranges::copy(texels, rgba.begin());
  }

  void evaluate(const FunctionInfo& function, std::span<const double> uniforms, std::span<const double> varying,
                int count, std::span<double> results) override {
    if (!function.evaluable)
      throw InputError(std::string(function.name) + " reads tables: it cannot be evaluated by itself");
    const int columns = varying_components(function), rows = result_components(function);
    assert(uniforms.size() == std::size_t(uniform_components(function)));
    assert(varying.size() == std::size_t(columns) * std::size_t(count) &&
           results.size() == std::size_t(rows) * std::size_t(count));
    const GridShader& shader = shader_of("function " + std::string(function.name), [&] {
      return function_shader(context_->api(), groups_[function.group], function);
    });
    std::vector<float> block = to_float(uniforms);
    block.resize(std::size_t(4 * planes(uniform_components(function))));
    // A set of arguments is a texel; what does not fit into one texture of a size that every OpenGL has goes into the next.
    constexpr int width = 1024, most_rows = 128;
    for (int first = 0; first < count; first += width * most_rows) {
      const int sets = std::min(count - first, width * most_rows);
      const Shape grid{std::min(sets, width), (sets + width - 1) / width, 1};
      std::vector<const GlTexture*> tables;
      std::unique_ptr<GlTexture> arguments;
      if (columns > 0) {
        std::vector<float> packed(4 * std::size_t(planes(columns)) * grid.texels());
        for (int c = 0; c < columns; ++c) {
          for (std::size_t i = 0; i < std::size_t(sets); ++i) {
            packed[4 * ((c / 4) * grid.texels() + i) + c % 4] =
                static_cast<float>(varying[std::size_t(c) * count + first + i]);
          }
        }
        arguments = std::make_unique<GlTexture>(context_, Shape{grid.width, grid.height * planes(columns), 1}, packed);
        tables.push_back(arguments.get());
      }
      const auto targets = make_targets(planes(rows), grid);
      shader.run(block, tables, pointers(targets), {grid, 0, 0});
      std::vector<float> texels(4 * grid.texels());
      for (int c = 0; c < rows; ++c) {
        if (c % 4 == 0) targets[c / 4]->read(texels);
        for (std::size_t i = 0; i < std::size_t(sets); ++i)
          results[std::size_t(c) * count + first + i] = texels[4 * i + c % 4];
      }
    }
  }

 protected:
  std::shared_ptr<void> make_table(Shape shape, std::span<const double> rgba) override {
    return std::make_shared<GlTexture>(context_, shape, to_float(rgba));
  }

  std::shared_ptr<void> make_empty(Shape shape) override {
    return std::make_shared<GlTexture>(context_, shape, std::span<const float>());
  }

  void run_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
                int begin, int end, std::span<const std::shared_ptr<void>> outputs) override {
    const GridShader& shader = shader_of(pass);
    const auto tables = bind(pass, inputs);
    const auto block = to_float(parameters);
    std::vector<const GlTexture*> targets;
    for (const auto& output : outputs) targets.push_back(static_cast<const GlTexture*>(output.get()));
    for (int slice = begin / shape.height; slice * shape.height < end; ++slice) {
      const int first = slice * shape.height;
      shader.run(block, tables, targets,
                 {shape, first, slice, std::max(begin - first, 0), std::min(end - first, shape.height)});
    }
    if (end - begin < shape.height * shape.depth) {
      const HeadlessContext::Current current(*context_);
      glFinish();
    }
  }

  void draw_rows(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
                 int begin, int end, std::span<float> rgba) override {
    // The further outputs of a pass are computed and dropped.
    const auto targets = make_targets(int(pass.outputs.size()), {shape.width, end - begin, 1});
    shader_of(pass).run(to_float(parameters), bind(pass, inputs), pointers(targets), {shape, begin, 0});
    targets.front()->read(rgba);
  }

 private:
  std::vector<std::shared_ptr<GlTexture>> make_targets(int count, Shape shape) const {
    std::vector<std::shared_ptr<GlTexture>> targets;
    for (int i = 0; i < count; ++i)
      targets.push_back(std::make_shared<GlTexture>(context_, shape, std::span<const float>()));
    return targets;
  }
  static std::vector<const GlTexture*> pointers(const std::vector<std::shared_ptr<GlTexture>>& textures) {
    std::vector<const GlTexture*> list;
    for (const auto& t : textures) list.push_back(t.get());
    return list;
  }

  std::vector<const GlTexture*> bind(const PassInfo& pass, std::span<const Table> inputs) const {
    std::vector<const GlTexture*> tables;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const GlTexture& texture = texture_of(inputs[i]);
      if ((texture.target() == GL_TEXTURE_3D) != (pass.tables[i].type == KernelType::Table3)) {
        throw WorkError("pass " + std::string(pass.name) + ", table " + std::string(pass.tables[i].name) +
                        ": a Table3 has a depth of at " + "least 2, a Table2 of 1; this one has " +
                        std::to_string(texture.shape().depth));
      }
      tables.push_back(&texture);
    }
    return tables;
  }

  const GridShader& shader_of(const PassInfo& pass) {
    return shader_of("pass " + std::string(pass.name),
                     [&] { return pass_shader(context_->api(), groups_[pass.group], pass); });
  }
  /// Compiled once and kept.
  template <class Text>
  const GridShader& shader_of(const std::string& subject, const Text& text) {
    const HeadlessContext::Current current(*context_);  // also guards the map
    auto& shader = shaders_[subject];
    if (!shader) shader = std::make_unique<GridShader>(context_, text(), subject);
    return *shader;
  }

  std::shared_ptr<HeadlessContext> context_;
  std::span<const KernelGroup> groups_;
  std::map<std::string, std::unique_ptr<GridShader>> shaders_;
};

}  // namespace

std::shared_ptr<Engine> make_gl_engine(std::span<const KernelGroup> groups) {
  return std::make_shared<GlEngine>(GlApi::desktop, groups);
}
std::shared_ptr<Engine> make_gles_engine(std::span<const KernelGroup> groups) {
  return std::make_shared<GlEngine>(GlApi::es, groups);
}

}  // namespace airlight
