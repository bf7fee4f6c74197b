#include <tbb/global_control.h>

#include <numbers>

#include "airlight/sky.h"
#include "benchmarks.h"
#include "clock.h"
#include "compare.h"
#include "ray_work.h"

namespace airlight::bench {
namespace {

constexpr double degree = std::numbers::pi / 180;

Camera camera_of(int width, int height, double altitude, double elevation) {
  return {.projection = Projection::perspective,
          .width = width,
          .height = height,
          .altitude = altitude,
          .elevation = elevation * degree};
}

/// The n-th place of a Sun that moves by a hundredth of a degree a frame; in the picture of a camera that looks north and up.
Direction moving_sun(int n) { return direction((10 + 0.01 * n) * degree, (25 + 0.01 * n) * degree); }

std::vector<float> picture(const Sky& sky, const Camera& camera, Direction sun, bool disc) {
  std::vector<float> pixels;
  sky.render(camera, sun, {disc, {}}, [&](int, int, std::span<const float> rgba) {
    pixels.insert(pixels.end(), rgba.begin(), rgba.end());
    return true;
  });
  return pixels;
}

/// Draws and forgets: what the pixels are for is not ours to time.
void frame(const Sky& sky, const Camera& camera, Direction sun, bool disc = true) {
  sky.render(camera, sun, {disc, {}}, [](int, int, std::span<const float>) { return true; });
}

void check(Report& report, const std::string& name, const Sky& sky, const Sky& truth, const Camera& camera, bool disc) {
  const auto got = picture(sky, camera, moving_sun(0), disc), expected = picture(truth, camera, moving_sun(0), disc);
  // Against the brightest of the sky the disc's 1e9 cd/m2 would make all else a shadow: its picture is compared to 1 cd/m2.
  const double floor = disc ? 1 : 0;
  // The worst is a pixel at the horizon or at the disc's edge, where half an ulp of the direction is a step in the light.
  report.check(name + ", 99 % of values against double", difference(got, expected, 0.99, floor), 1e-5);
  report.check(name + ", all values against double", difference(got, expected, 1, floor), 1e-2);
}

}  // namespace

void pictures(Report& report, const MachineLimits& limits) {
  const Atmosphere earth = built_in_atmosphere("earth");
  const auto engine = make_engine("simd"), yardstick = make_engine("double");
  const Sky sky(earth, "skyview", engine), single(earth, "single", engine);
  const Sky true_sky(earth, "skyview", yardstick), true_single(earth, "single", yardstick);
  const int scale = report.timing() ? 1 : 8;

  report.section("skyview, 1920x1080, perspective 90 degrees, moving sun; processor time of all threads");
  const Camera hd = camera_of(1920 / scale, 1080 / scale, 2, 20);
  check(report, "picture", sky, true_sky, hd, false);
  check(report, "picture with the sun's disc", sky, true_sky, hd, true);
  if (report.timing()) {
    int n = 1;
    const Camera tiny = camera_of(16, 9, 2, 20);
    const auto ms = [&](const char* name, const auto& work, std::optional<double> at_most = {}) {
      report.add({name, 1e3 * best_time(work), "CPU-ms", at_most});
    };
    ms(
        "a frame: tables, disc, picture", [&] { frame(sky, hd, moving_sun(n++)); }, 50);
    ms("  sky-view table, and all else at 16x9 pixels", [&] { frame(sky, tiny, moving_sun(n++)); });
    ms("  all else at 16x9 pixels", [&] { frame(sky, tiny, moving_sun(0)); });
    ms("  picture from kept tables", [&] { frame(sky, hd, moving_sun(0)); });
    ms("  picture from kept tables, no disc", [&] { frame(sky, hd, moving_sun(0), false); });
  }

  report.section("Pictures from kept tables, one thread");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto measure = [&](const std::string& name, const Sky& s, const Camera& camera, Work work) {
    if (!report.timing()) return;
    const double pixels = double(camera.width) * camera.height;
    report.add({name,
                1e9 * best_time([&] { frame(s, camera, moving_sun(0), false); }) / pixels,
                "ns/pixel",
                {},
                {},
                limits.at(set_of(s.engine())).pixel(work.exps, work.texels)});
  };
  // Two tables, bilinear, and a phase function; no exps.
  measure("skyview 1920x1080, from the ground", sky, hd, {0, 4 + 4 + 2});
  // All of these pixels see sky, so that every ray crosses every zone; from 400 km all see the ground below the limb.
  const Camera up = camera_of(960 / scale, 540 / scale, 2, 40), down = camera_of(960 / scale, 540 / scale, 4e5, -60);
  check(report, "single", single, true_single, camera_of(120, 68, 2, 40), false);
  measure("single 960x540, from the ground", single, up, ray_work(earth, find_model("single"), false));
  check(report, "skyview from 400 km", sky, true_sky, camera_of(120, 68, 4e5, -60), false);
  measure("skyview 960x540, from 400 km", sky, down, ray_work(earth, find_model("skyview"), true));
}

}  // namespace airlight::bench
