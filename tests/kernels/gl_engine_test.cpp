// What is the OpenGL engines' own: messages, limits, threads.
#include "engine/gl/gl_engine.h"

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "airlight/error.h"
#include "engine/gl/shader_text.h"
#include "engines.h"

namespace airlight::test {
namespace {

class OpenGl : public testing::TestWithParam<std::string> {};

std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const WorkError& error) {
    return error.what();
  }
  return "no WorkError";
}

// A kernel of two files; the second has a mistake in its fourth line.
constexpr KernelSource good{"kernels/broken/good.glsl", "#pragma once\nFN Float broken_good(Float x) { return x; }\n"};
constexpr KernelSource bad{"kernels/broken/bad.glsl",
                           "#pragma once\n#include \"broken/good.glsl\"\n// A comment.\nFN Vec4 broken_pass(Vec2 uv) { "
                           "return missing(uv); }\n"};
constexpr std::string_view broken_outputs[] = {"broken"};

TEST_P(OpenGl, a_kernel_that_does_not_compile_is_named_with_its_line) {
  AIRLIGHT_SKIP_WITHOUT(find_engine, GetParam());
  const KernelSource* const sources[] = {kernel_groups()[0].sources[0], &good, &bad};
  const KernelGroup groups[] = {{"broken", sources}};
  const PassInfo pass{"broken.broken", "broken_pass", {}, {}, broken_outputs, false, bad.file, 4, 0, 0};
  const auto broken = GetParam() == "gl" ? make_gl_engine(groups) : make_gles_engine(groups);
  const std::string message = message_of([&] { broken->run(pass, {}, {}, {2, 2, 1}); });
  EXPECT_NE(message.find("kernels/broken/bad.glsl:4"), std::string::npos) << message;
  EXPECT_NE(message.find("pass broken.broken"), std::string::npos) << message;
  EXPECT_NE(message.find("missing"), std::string::npos) << message;
  // Asked again, it fails again instead of running what was not compiled.
  EXPECT_EQ(message_of([&] { broken->run(pass, {}, {}, {2, 2, 1}); }), message);
}

TEST_P(OpenGl, a_table_beyond_the_limit_is_refused_with_the_limit) {
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam());
  const Shape shape{1 << 20, 1, 1};
  const std::string message = message_of([&] { engine.upload(shape, std::vector<double>(4 * shape.texels())); });
  EXPECT_NE(message.find("1048576 x 1 texels"), std::string::npos) << message;
  EXPECT_NE(message.find("at most"), std::string::npos) << message;
}

TEST_P(OpenGl, a_flat_table_is_refused_where_a_volume_is_read) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const PassInfo& pass = *std::ranges::find(language_passes(), "language_lookup3_pass", &PassInfo::kernel_name);
  const Table flat = engine.upload({2, 2, 1}, std::vector<double>(16));
  const Table inputs[] = {flat, flat};
  EXPECT_NE(message_of([&] { engine.run(pass, {}, inputs, {2, 2, 1}); }).find("table grid"), std::string::npos);
}

TEST_P(OpenGl, threads_may_share_an_engine_and_keep_their_own_context) {
  AIRLIGHT_ENGINE_OR_SKIP(find_engine, GetParam());
  const FunctionInfo& f = kernel_function("core.phase_rayleigh");
  const auto work = [&](double x, std::vector<double>& results) {
    const std::vector<double> in(1000, x);
    for (int i = 0; i < 5; ++i) engine.evaluate(f, {}, in, 1000, results);
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);  // as it was before
  };
  std::vector<double> first(1000), second(1000);
  std::thread other([&] { work(1.0, first); });
  work(0.0, second);
  other.join();
  // 3 / (16 pi) (1 + cos^2)
  EXPECT_NEAR(first[999], 0.0596831, 1e-6);
  EXPECT_NEAR(second[999], 2 * 0.0596831, 1e-6);
}

TEST_P(OpenGl, a_table_may_outlive_its_engine) {
  AIRLIGHT_SKIP_WITHOUT(find_engine, GetParam());
  auto own = GetParam() == "gl" ? make_gl_engine() : make_gles_engine();
  Table table = own->upload({2, 2, 1}, std::vector<double>(16, 1.0));
  own.reset();
  table = {};
}

INSTANTIATE_TEST_SUITE_P(engines, OpenGl, testing::Values("gl", "gles"),
                         [](const auto& tested) { return tested.param; });

TEST(CompilerLog, sources_become_files_whichever_way_the_driver_numbers_them) {
  const std::string files[] = {"kernels/prelude/prelude.glsl", "kernels/core/math.glsl", "main() of core.ln"};
  EXPECT_EQ(name_files("1:45(12): error: `x' undeclared\n", files),
            "kernels/core/math.glsl:45: error: `x' undeclared\n");  // Mesa
  EXPECT_EQ(name_files("1(45) : error C1503: undefined\n", files),
            "kernels/core/math.glsl:45 : error C1503: undefined\n");  // NVIDIA
  EXPECT_EQ(name_files("ERROR: 2:7: 'y' : no such\nend", files),
            "main() of core.ln:7: 'y' : no such\nend");  // AMD, ANGLE
  EXPECT_EQ(name_files("error: 12 things\n9:1: unknown source", files), "error: 12 things\n9:1: unknown source");
}

}  // namespace
}  // namespace airlight::test
