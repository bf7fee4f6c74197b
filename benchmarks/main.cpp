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

const std::vector<std::string> benchmarks{"march", "tables", "pictures", "published", "rays", "precomputed", "command"};

int run(const std::string& json, bool check, const std::vector<std::string>& chosen) {
  Report report(!check);
  report.describe("processor", processor());
  report.describe("engine", make_engine("simd")->device());
#if defined(__VERSION__)
  report.describe("compiler", __VERSION__);
#endif
  const MachineLimits limits = measure_limits(report);
  for (const std::string& name : chosen.empty() ? benchmarks : chosen) {
    if (name == "march") march(report, limits);
    if (name == "tables") tables(report);
    if (name == "pictures") pictures(report, limits);
    if (name == "published") published(report, limits);
    if (name == "rays") rays(report, limits);
    if (name == "precomputed") precomputed(report);
    if (name == "command") command(report);
  }
  if (!json.empty()) report.write_json(json);
  return report.verdict();
}

}  // namespace
}  // namespace airlight::bench

int main(int argc, char** argv) {
  CLI::App app(
      "Checks each answer, then times it, in processor time. Exit code 1: an answer is wrong, or a required figure is "
      "missed.");
  std::string json;
  bool check = false;
  std::vector<std::string> chosen;
  app.add_option("--json", json, "write the table there too")->type_name("FILE");
  app.add_flag("--check", check, "only check the answers, at reduced size; nothing is timed");
  app.add_option("benchmark", chosen,
                 "march, tables, pictures, published, rays, precomputed, command (default all); the machine's limits "
                 "are always measured")
      ->check(CLI::IsMember(airlight::bench::benchmarks));
  CLI11_PARSE(app, argc, argv);
  try {
    return airlight::bench::run(json, check, chosen);
  } catch (const std::exception& error) {
    fmt::print(stderr, "airlight_bench: {}\n", error.what());
    return 2;
  }
}
