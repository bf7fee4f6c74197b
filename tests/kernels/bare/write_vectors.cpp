// write_vectors FILE: evaluates every kernel function in double at random arguments and keeps what came out.
#include <cstdio>
#include <cstring>

#include "airlight/engine.h"
#include "arguments.h"
#include "bare/vectors.h"

int main(int argc, char** argv) {
  using namespace airlight;
  std::FILE* file = argc == 2 ? std::fopen(argv[1], "wb") : nullptr;
  if (!file) return std::fprintf(stderr, "usage: write_vectors FILE\n"), 2;
  const auto engine = make_engine("double");
  test::Random random;
  constexpr int draws = 4, count = 101;
  const auto put = [&](const std::vector<double>& numbers) {
    if (!numbers.empty()) std::fwrite(numbers.data(), sizeof(double), numbers.size(), file);
  };
  for (const FunctionInfo& f : kernel_functions()) {
    if (!f.evaluable) continue;
    for (int draw = 0; draw < draws; ++draw) {
      const test::Arguments a = test::draw_arguments(f, count, random);
      std::vector<double> results(std::size_t(test::result_count(f)) * count);
      engine->evaluate(f, a.uniforms, a.varying, count, results);
      test::VectorHeader header{};
      std::strncpy(header.name, std::string(f.name).c_str(), sizeof header.name - 1);
      header.bound = f.bound;
      header.scale = f.scale;
      header.group = f.group;
      header.slot = f.slot;
      header.uniforms = int(a.uniforms.size());
      header.varying = int(a.varying.size()) / count;
      header.results = int(results.size()) / count;
      header.count = count;
      std::fwrite(&header, sizeof header, 1, file);
      put(a.uniforms);
      put(a.varying);
      put(results);
    }
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
