// airlight_bench: checks each answer, then times it.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "benchmarks.h"

namespace airlight::bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

int run(const std::string& json, bool check) {
  Report report(!check);
  report.describe("processor", processor());
  report.describe("engine", make_engine("simd")->device());
#if defined(__VERSION__)
  report.describe("compiler", __VERSION__);
#endif
  const MachineLimits limits = measure_limits(report);
  march(report, limits);
  tables(report);
  pictures(report, limits);
  rays(report, limits);
  command(report);
  if (!json.empty()) report.write_json(json);
  return report.verdict();
}

}  // namespace
}  // namespace airlight::bench

int main(int argc, char** argv) {
  CLI::App app("Checks each answer, then times it, in processor time. Exit code 1: an answer is wrong, or a required figure is missed.");
  std::string json;
  bool check = false;
  app.add_option("--json", json, "write the table there too")->type_name("FILE");
  app.add_flag("--check", check, "only check the answers, at reduced size; nothing is timed");
  CLI11_PARSE(app, argc, argv);
  try {
    return airlight::bench::run(json, check);
  } catch (const std::exception& error) {
    fmt::print(stderr, "airlight_bench: {}\n", error.what());
    return 2;
  }
}
