#include "scene/sky_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raster_maker.h"

namespace airlight {
namespace {

Land land_of(const Folder& folder, const std::function<double(double, double)>& height) {
  write_raster(folder / "land.tif", {.width = 400, .height = 400},
               [&](double x, double y, int) { return height((x - 200) * 25, (200 - y) * 25); });
  LandSettings settings;
  settings.files = {{.file = folder / "land.tif", .cell_size = 25}};
  return Land(settings);
}

TEST(SkyView, a_plain_sees_all_of_it) {
  const Land land(LandSettings{});
  const SkyViewMap map = sky_view_map(land, 0, 0, 5000, 32);
  for (const float factor : map.factor) EXPECT_NEAR(factor, 1, 1e-6);
}

TEST(SkyView, a_slope_sees_half_of_one_plus_its_cosine) {
  const Folder folder;
  for (const double tangent : {0.2, 0.6}) {
    const Land land =
        land_of(folder, [&](double east, double north) { return 5000 + tangent * (0.6 * east - 0.8 * north); });
    // Near the middle: the file's border, where the slope ends, is 4 km away.
    const SkyViewMap map = sky_view_map(land, 0, 0, 500, 16);
    // Uphill horizon at the slope's own rise; 16 directions integrate smooth functions to 1e-3. Below it the plain ends.
    EXPECT_NEAR(map.at(0, 0), 0.5 * (1 + 1 / std::sqrt(1 + tangent * tangent)), 0.005) << tangent;
  }
}

TEST(SkyView, the_floor_of_a_long_valley) {
  const Folder folder;
  // Walls that rise at 45 degrees from the valley's axis on, 2 km high: horizon at 45 degrees, except along the valley.
  const Land land = land_of(folder, [](double east, double) { return 1000 + std::min(std::abs(east), 2000.0); });
  const SkyViewMap map = sky_view_map(land, 0, 0, 400, 17);
  // From the axis the horizon at azimuth a from the axis has tan(h) = |sin a|; cosine-weighted sky: mean of cos^2 h =
  // mean of 1 / (1 + sin^2 a) = 1 / sqrt(2). The axis is rounded by the 25 m cells and lies between two columns.
  EXPECT_NEAR(map.at(0, 0), 1 / std::sqrt(2.0), 0.03);
}

TEST(SkyView, a_place_sees_the_same_from_the_middle_and_the_edge_of_a_map) {
  const Folder folder;
  const Land land = land_of(folder, [](double east, double north) {
    return 1000 + 300 * std::sin(0.004 * east + 0.001 * north) + 200 * std::cos(0.005 * north);
  });
  // Half a cell inside the west edge of one, in the middle of the other; as whole cells lie between, both ask for the same places nearby.
  const SkyViewMap edge = sky_view_map(land, 0, 0, 400, 16), middle = sky_view_map(land, -400, 0, 400, 16);
  double most = 0;
  for (int j = 2; j < 14; ++j) {
    const double east = edge.first_east, north = edge.first_north + j * edge.spacing;
    // Farther land is smoothed over cells that lie otherwise: 0.0016 here.
    EXPECT_NEAR(edge.at(east, north), middle.at(east, north), 0.004) << north;
    most = std::max(most, 1 - edge.at(east, north));
  }
  EXPECT_GT(most, 0.07);
}

}  // namespace
}  // namespace airlight
