#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "benchmarks.h"
#include "compare.h"

extern char** environ;

namespace airlight::bench {
namespace {

namespace fs = std::filesystem;

/// Processor time [s], user and system, of `airlight sky` from its start to its end.
double run_sky(const std::string& size, const std::string& output) {
  std::vector<std::string> words{
      AIRLIGHT_PROGRAM, "sky", "--planet", "earth", "--model", "skyview", "--sun-elevation", "25",
      "--sun-azimuth",  "10",  "--size",   size,    "-o",      output};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, AIRLIGHT_PROGRAM, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  rusage used{};
  if (failed || wait4(child, &status, 0, &used) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw WorkError(std::string(AIRLIGHT_PROGRAM) + " sky failed");
  }
  const auto seconds = [](timeval t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::vector<float> read_rgb(const std::string& path) {
  const auto file = OIIO::ImageInput::open(path);
  if (!file) throw WorkError(path + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = file->spec();
  std::vector<float> rgb(3 * std::size_t(spec.width) * std::size_t(spec.height));
  if (spec.format != OIIO::TypeDesc::HALF || spec.get_string_attribute("compression") != "zip")
    throw WorkError(path + ": not zipped half floats");
  if (!file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, rgb.data())) throw WorkError(path + ": " + file->geterror());
  return rgb;
}

std::vector<float> expected_rgb(int width, int height) {
  constexpr double degree = std::numbers::pi / 180;
  const Sky sky(built_in_atmosphere("earth"), "skyview", make_engine("double"));
  std::vector<float> rgb;
  sky.render({.width = width, .height = height}, direction(10 * degree, 25 * degree), {},
             [&](int, int, std::span<const float> rgba) {
               for (std::size_t i = 0; i < rgba.size(); ++i) {
                 if (i % 4 != 3) rgb.push_back(std::min(rgba[i], 65504.f));  // where half floats end
               }
               return true;
             });
  return rgb;
}

}  // namespace

void command(Report& report) {
  const int width = report.timing() ? 4096 : 512, height = width / 2;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  report.section("airlight sky --model skyview --size " + size + ", half-float zip EXR, from nothing to file");
  const fs::path folder = fs::temp_directory_path() / ("airlight-bench-" + std::to_string(getpid()));
  fs::create_directory(folder);
  const std::string path = folder / "sky.exr";
  double best = 1e9;
  for (int round = 0; round < (report.timing() ? 5 : 1); ++round) best = std::min(best, run_sky(size, path));
  // Half floats keep 11 bits: 2.4e-4 where they are normal; the rest is float against double.
  report.check("99 % of values against double", difference(read_rgb(path), expected_rgb(width, height), 0.99), 6e-4);
  fs::remove_all(folder);
  if (report.timing()) report.add({"user and system time of the process", best, "CPU-s", 1.5});
}

}  // namespace airlight::bench
