// The frames that examples/embed_gl wrote, before and after its haze, against `Sky::haze` asked for the same pixels.
//
// usage: embed_gl_check FOLDER   with the atmosphere, observer and sun that the tables were made for
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "airlight/sky.h"
#include "render/haze_depth.h"
#include "render/haze_picture.h"

namespace {

using namespace airlight;

constexpr int width = 640, height = 360;
constexpr double degree = 0.017453292519943295;

std::vector<float> frame(const std::string& path) {
  std::vector<float> rgba(4 * width * height), rows(rgba.size());
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("skipped: no " + path);  // no OpenGL, which the example has said
  file.read(reinterpret_cast<char*>(rows.data()), std::streamsize(rows.size() * sizeof(float)));
  if (!file) throw std::runtime_error(path + " is too short");
  for (int y = 0; y < height; ++y)  // OpenGL's rows begin at the bottom
    std::copy_n(&rows[4 * std::size_t(width * (height - 1 - y))], 4 * width, &rgba[4 * std::size_t(width * y)]);
  return rgba;
}

int check(const std::string& folder) {
  std::vector<float> expected = frame(folder + "/scene.f32");
  const std::vector<float> hazed = frame(folder + "/hazed.f32");

  // The example's camera and conventions in our own words.
  Camera camera{.projection = Projection::perspective, .width = width, .height = height};
  camera.azimuth = 20 * degree, camera.elevation = -4 * degree, camera.field_of_view = 60 * degree;
  const HazeView view = haze_view(camera);
  const DepthMeaning meaning{
      .kind = DepthKind::reversed, .near = 1e-4, .far = std::numeric_limits<double>::infinity(), .unit = 1000};
  constexpr float white_luminance = 25'000;
  std::vector<float> distances;
  int land = 0;
  for (std::size_t i = 0; i < std::size_t(width * height); ++i) {
    const auto line = view.look((double(i % width) + 0.5) / width, (double(i / width) + 0.5) / height);
    distances.push_back(float(distance(meaning, double(expected[4 * i + 3]), line->cosine)));
    land += std::isfinite(distances.back());
    for (std::size_t k = 0; k < 3; ++k) expected[4 * i + k] *= white_luminance;
    expected[4 * i + 3] = std::isfinite(distances.back()) ? 1.0f : 0.0f;
  }
  const Sky sky(built_in_atmosphere("earth-hazy"), "skyview");
  HazeSettings settings;
  settings.altitude = 800;
  settings.sun = direction(100 * degree, 25 * degree);
  settings.sun_disc = false;
  HazePicture(sky, view, settings).rows(0, distances, expected);

  double worst = 0, mean = 0;
  for (std::size_t i = 0; i < std::size_t(width * height); ++i) {
    const float* truth = &expected[4 * i];
    const double brightest = std::max({truth[0], truth[1], truth[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(double(hazed[4 * i + k]) - double(truth[k])) / brightest;
      if (!(error <= worst)) worst = error;  // NaN counts
    }
    mean += brightest / (width * height);
  }
  std::printf("%d of %d pixels show land; mean %.0f cd/m2; largest difference %.2g of a pixel's brightest channel\n",
              land, width * height, mean, worst);
  // The same tables, looked up by other compilers in floats: directions near the horizon are good to a hundredth of a texel
  // (dome_uv's bound, 1e-3), which changes the sky by less than that.
  constexpr double bound = 1e-3;
  const bool both = land > width * height / 5 && land < width * height * 4 / 5;
  if (!both) std::puts("expected land and sky, each on a fifth of the picture at least");
  if (!(worst <= bound)) std::printf("expected at most %g\n", bound);
  return both && worst <= bound ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count != 2) throw std::runtime_error("usage: embed_gl_check FOLDER");
    return check(words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embed_gl_check: %s\n", error.what());
    return 2;
  }
}
