// airlight_bench: checks each answer, then times it.
#include <fmt/core.h>

#include <algorithm>
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

namespace {

constexpr char usage[] =
    "usage: airlight_bench [--check] [--json FILE] [march|tables|pictures|published|rays|precomputed|command]...\n"
    "Checks each answer, then times it, in processor time; all benchmarks where none is named, and always the "
    "machine's "
    "limits.\n"
    "  --check  only check the answers, at reduced size; nothing is timed\n"
    "  --json   write the table there too\n"
    "Exit code 1: an answer is wrong, or a required figure is missed.\n";

}  // namespace

int main(int argc, char** argv) {
  using airlight::bench::benchmarks;
  std::string json;
  bool check = false;
  std::vector<std::string> chosen;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h") {
      fmt::print("{}", usage);
      return 0;
    } else if (word == "--check") {
      check = true;
    } else if (word == "--json" && i + 1 < argc) {
      json = argv[++i];
    } else if (std::ranges::find(benchmarks, word) != benchmarks.end()) {
      chosen.push_back(word);
    } else {
      fmt::print(stderr, "airlight_bench: {}: unknown, or without its value\n{}", word, usage);
      return 2;
    }
  }
  try {
    return airlight::bench::run(json, check, chosen);
  } catch (const std::exception& error) {
    fmt::print(stderr, "airlight_bench: {}\n", error.what());
    return 2;
  }
}
