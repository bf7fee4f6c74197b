// Ridges against the sky: where an eye looks first for what triangles leave out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/terrain.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A window on the land, as wide and as fine as a part of a picture of 1920 pixels that shows 50 degrees.
struct Window {
  double east, north, above_ground;  // of the eye [m]
  double azimuth, elevation;         // of the middle [degrees]
  std::uint32_t seed;
};

constexpr int columns = 300, rows = 240;
constexpr double pixel = 2 * 0.46631 / 1920;  // tan 25 degrees

/// For each column the row, in pixels from the top, where land begins; `rows` where the window shows none.
std::vector<double> silhouette(const Terrain& terrain, const LevelOfDetail& detail, const Window& window) {
  constexpr int parts = 4;  // of a pixel
  const double azimuth = window.azimuth * degree, elevation = window.elevation * degree;
  std::vector<double> line;
  std::vector<SceneRay> rays(rows * parts);
  std::vector<TerrainHit> hits(rays.size());
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows * parts; ++y) {
      const double a = azimuth + (x + 0.5 - columns / 2) * pixel,
                   e = elevation - ((y + 0.5) / parts - rows / 2) * pixel;
      rays[std::size_t(y)] = {detail.eye, {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)}};
    }
    terrain.hits(rays, hits);
    const auto first = std::ranges::find_if(hits, &TerrainHit::hit);
    line.push_back(double(first - hits.begin()) / parts);
  }
  return line;
}

TEST(Silhouette, triangles_of_two_pixels_show_the_ridges_of_those_eight_times_finer) {
  // The first two look at crests that run downhill, the third at gentle summits far away, the last at a pass.
  const Window windows[] = {{-24'000, -13'500, 650, 79.5, 1.3, 11},
                            {-24'000, -13'500, 650, 85, 2, 11},
                            {12'000, -6000, 1500, 300, 0, 4},
                            {5000, 9000, 300, 20, 2, 2}};
  for (const Window& window : windows) {
    LandSettings settings;
    settings.relief = ReliefSettings{.seed = window.seed, .height = 3000, .wavelength = 7000, .ruggedness = 1};
    const auto land = std::make_shared<Land>(settings);
    LevelOfDetail detail;
    detail.eye = land->frame().position(
        {window.east, window.north, land->altitude(window.east, window.north) + window.above_ground});
    detail.pixel_angle = pixel;
    detail.pixels = 2;
    const double a = window.azimuth * degree, e = window.elevation * degree;
    detail.axis = {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
    detail.half_angle = std::hypot(columns, rows) / 2 * pixel;
    const std::vector<double> coarse = silhouette(Terrain(land, detail), detail, window);
    detail.pixels = 0.25;
    detail.unseen_pixels = 400;  // nothing is asked there
    const std::vector<double> fine = silhouette(Terrain(land, detail), detail, window);

    int apart = 0;
    for (std::size_t x = 1; x + 1 < columns; ++x) {
      ASSERT_GT(fine[x], 0) << "sky above";
      ASSERT_LT(fine[x], rows) << "land below";
      // To any side: a cliff's edge may lie one column farther.
      const auto [high, low] = std::minmax({fine[x - 1], fine[x], fine[x + 1]});
      const double beside = std::max(high - coarse[x], coarse[x] - low);
      apart += beside > 1;
      // Gullies that are narrower than two to four triangles fade out, on what is seen edge-on triangles of four pixels. They are a
      // fifth as deep as wide.
      EXPECT_LE(beside, 3) << "column " << x << ", towards " << window.azimuth << " degrees";
    }
    EXPECT_LE(apart, columns / 10) << "columns more than a pixel away, towards " << window.azimuth << " degrees";
  }
}

}  // namespace
}  // namespace airlight
