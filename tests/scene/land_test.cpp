#include "scene/land.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "airlight/error.h"
#include "raster_maker.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

// A hill that files in different projections describe: a function of latitude and longitude [degrees].
double hill(double longitude, double latitude) {
  const double x = (longitude - 9.0) * 111'000 * std::cos(47 * degree), y = (latitude - 47.0) * 111'000;
  return 800 + 1500 * std::exp(-(x * x + y * y) / (3000.0 * 3000.0)) + 100 * std::sin(x / 900) * std::cos(y / 700);
}

/// Longitude and latitude of the central point are 9 E, 47 N: on the central meridian of UTM zone 32, where east is 500 km.
/// Inverse transverse Mercator near the meridian on WGS 84, to 0.1 m within 10 km (third order in the distance).
std::array<double, 2> from_utm32(double easting, double northing) {
  constexpr double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f), k0 = 0.9996;
  const double m = northing / k0;  // meridian arc; footpoint latitude by Newton's method
  double phi = m / a;
  const auto arc = [&](double p) {
    return a * ((1 - e2 / 4 - 3 * e2 * e2 / 64 - 5 * e2 * e2 * e2 / 256) * p -
                (3 * e2 / 8 + 3 * e2 * e2 / 32 + 45 * e2 * e2 * e2 / 1024) * std::sin(2 * p) +
                (15 * e2 * e2 / 256 + 45 * e2 * e2 * e2 / 1024) * std::sin(4 * p) -
                35 * e2 * e2 * e2 / 3072 * std::sin(6 * p));
  };
  for (int i = 0; i < 10; ++i) phi -= (arc(phi) - m) / (a * (1 - e2));
  const double s = std::sin(phi), n = a / std::sqrt(1 - e2 * s * s), r = a * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
  const double d = (easting - 500'000) / (n * k0), t = std::tan(phi);
  return {9 + (d - (1 + 2 * t * t) * d * d * d / 6) / std::cos(phi) / degree, (phi - n * t / r * d * d / 2) / degree};
}

TEST(Land, projected_and_geographic_files_of_one_hill_agree) {
  const Folder folder;
  write_raster(folder / "geographic.tif",
               {.width = 400,
                .height = 400,
                .coordinate_system = "EPSG:4326",
                .geotransform = {8.9, 0.0005, 0, 47.1, 0, -0.0005}},
               [](double x, double y, int) { return hill(x, y); });
  write_raster(folder / "projected.tif",
               {.width = 400,
                .height = 500,
                .coordinate_system = "EPSG:32632",
                .geotransform = {492'000, 40, 0, 5'215'000, 0, -40}},
               [](double x, double y, int) {
                 const auto p = from_utm32(x, y);
                 return hill(p[0], p[1]);
               });
  const Place middle{47 * degree, 9 * degree};
  const auto load = [&](const std::string& name) {
    LandSettings settings;
    settings.files = {{folder / name}};
    settings.origin = middle;
    return Land(settings);
  };
  const Land geographic = load("geographic.tif"), projected = load("projected.tif");
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-5000, 5000);
  for (int i = 0; i < 2000; ++i) {
    const double east = place(random), north = place(random);
    // Cubic interpolation of 40 m cells of waves of 4.4 km and more leaves centimetres; a shift by one pixel would be 20 m.
    EXPECT_NEAR(geographic.altitude(east, north), projected.altitude(east, north), 0.3) << east << ' ' << north;
  }
  // And both agree with the hill at a place found by latitude and longitude.
  for (const auto& [latitude, longitude] : {std::pair{47.01, 9.02}, {46.97, 8.98}, {47.03, 9.0}}) {
    const GroundPoint g = projected.ground_at({latitude * degree, longitude * degree});
    EXPECT_NEAR(g.altitude, hill(longitude, latitude), 0.3);
    // East and north are metres on the ellipsoid: a degree of latitude at 47 N has 111.17 km (Rapp 1991, or any table).
    EXPECT_NEAR(g.north, (latitude - 47) * 111'170, 10);
  }
}

TEST(Land, values_are_kept_inside_and_blend_into_the_plain_within_the_stated_width) {
  const Folder folder;
  // 6 km x 6 km, 100 m at its border, a plateau of 600 m from 300 m inward.
  write_raster(folder / "plateau.tif", {.width = 200, .height = 200, .geotransform = {}}, [](double x, double y, int) {
    return std::min(std::min(x, 200 - x), std::min(y, 200 - y)) < 10 ? 100.0 : 600.0;
  });
  LandSettings settings;
  settings.files = {{.file = folder / "plateau.tif", .cell_size = 30, .blend = 1000}};
  const Land land(settings);
  EXPECT_NEAR(land.plain_altitude(), 100, 1e-3);
  EXPECT_NEAR(land.altitude(0, 0), 600, 1e-3);
  EXPECT_NEAR(land.altitude(2400, -2400), 600, 1e-3);
  EXPECT_NEAR(land.altitude(3500, 0), 100, 1e-3);
  EXPECT_EQ(land.altitude(4100, 0), land.plain_altitude());
  // Rows run south.
  write_raster(folder / "slope.tif", {.width = 200, .height = 200, .geotransform = {}},
               [](double x, double y, int) { return 1000 + x - 3 * y; });
  settings.files = {{.file = folder / "slope.tif", .cell_size = 30}};
  const Land slope(settings);
  EXPECT_NEAR(slope.altitude(300, 0) - slope.altitude(0, 0), 10, 1e-3);
  EXPECT_NEAR(slope.altitude(0, 300) - slope.altitude(0, 0), 30, 1e-3);
  // No step anywhere along a walk out of the file: the blend's steepest is 1.5 of the height over the width.
  for (double east = 2500, last = slope.altitude(2500, 100); east < 5000; east += 10) {
    const double here = slope.altitude(east, 100);
    EXPECT_LT(std::abs(here - last), 10 * 1.6 * 700 / 1000.0 + 1);
    last = here;
  }
}

TEST(Land, a_finer_file_lies_inside_a_coarser_one) {
  const Folder folder;
  write_raster(folder / "coarse.tif", {.width = 100, .height = 100, .geotransform = {}},
               [](double, double, int) { return 200.0; });
  write_raster(folder / "fine.tif", {.width = 400, .height = 400, .geotransform = {}},
               [](double, double, int) { return 300.0; });
  LandSettings settings;
  settings.files = {{.file = folder / "coarse.tif", .cell_size = 200},
                    {.file = folder / "fine.tif", .cell_size = 10, .blend = 500}};
  const Land land(settings);
  EXPECT_NEAR(land.altitude(0, 0), 300, 1e-3);
  EXPECT_NEAR(land.altitude(1400, 0), 300, 1e-3);
  EXPECT_NEAR(land.altitude(2001, 0), 200, 1e-3)
      << "blended inside its own border, where the coarse file has better data than none";
  EXPECT_GT(land.altitude(1750, 0), 210);
  EXPECT_LT(land.altitude(1750, 0), 290);
  EXPECT_NEAR(land.finest_cell(0, 0, 10), 10, 0.1);
  EXPECT_NEAR(land.finest_cell(6000, 0, 10), 200, 1);
  EXPECT_TRUE(std::isinf(land.finest_cell(50'000, 0, 10)));
}

TEST(Land, missing_values_inside_are_filled_smoothly_and_those_at_the_border_are_outside) {
  const Folder folder;
  for (const double missing : {-9999.0, -32768.0, 1e38, std::nan("")}) {
    for (const bool declared : {true, false}) {
      RasterDescription d{.width = 200, .height = 200, .geotransform = {}};
      if (declared && !std::isnan(missing)) d.nodata = {missing};
      write_raster(folder / "holes.tif", d, [&](double x, double y, int) {
        const bool hole = std::hypot(x - 100, y - 100) < 15, wedge = x + y < 100;
        return hole || wedge ? missing : 500.0 + x;
      });
      LandSettings settings;
      settings.files = {{.file = folder / "holes.tif", .cell_size = 30, .blend = 600}};
      const Land land(settings);
      // In the hole, 900 m wide, the slope of 1 in 30 goes on: 500 + 100 in its middle, within the pyramid's blur.
      EXPECT_NEAR(land.altitude(0, 0), 600, 8);
      EXPECT_NEAR(land.altitude(300, 0), 610, 8);
      // Data next to the hole are untouched.
      EXPECT_NEAR(land.altitude(600, 0), 620, 0.01);
      // The wedge in the north-west is outside: the plain, a blend's width away.
      EXPECT_EQ(land.altitude(-2800, 2800), land.plain_altitude());
      EXPECT_GT(land.plain_altitude(), 500);
      EXPECT_LT(land.plain_altitude(), 700);
      for (double t = -3000; t < 3000; t += 20) {
        EXPECT_GT(land.altitude(t, -t), 450) << "a missing value shines through at " << t;
        EXPECT_LT(land.altitude(t, -t), 750);
      }
    }
  }
}

TEST(Land, units_of_the_file_and_of_the_scene_apply) {
  const Folder folder;
  write_raster(folder / "flat.tif", {.width = 10, .height = 10, .geotransform = {}},
               [](double, double, int) { return 100.0; });
  LandSettings settings;
  settings.files = {{.file = folder / "flat.tif", .height_scale = 0.3048, .height_offset = 7, .cell_size = 100}};
  EXPECT_NEAR(Land(settings).altitude(0, 0), 37.48, 1e-5);
}

TEST(Land, blocks_read_at_need_agree_with_a_small_copy) {
  // 3000 values a side: held at half resolution, full resolution in blocks of 256.
  const Folder folder;
  const auto wave = [](double x, double y, int) { return 300 + 50 * std::sin(x * 0.02) + 40 * std::cos(y * 0.03); };
  write_raster(folder / "large.tif", {.width = 3000, .height = 2600, .geotransform = {}}, wave);
  LandSettings settings;
  settings.extent = 30'000;
  settings.files = {{.file = folder / "large.tif", .cell_size = 10}};
  const Land land(settings);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-9000, 9000);
  for (int i = 0; i < 3000; ++i) {
    // Every tenth place on a seam between two blocks.
    const double east = i % 10 ? place(random) : (256 * (i / 10 % 8) - 900) * 10.0, north = place(random);
    const double x = 1500 + east / 10, y = 1300 - north / 10;
    // Cubic interpolation of a wave of 200 pixels: fourth order, 50 x 0.03^4.
    EXPECT_NEAR(land.altitude(east, north), wave(x, y, 1), 1e-3) << east;
    EXPECT_NEAR(land.altitude(east, north, 20), wave(x, y, 1), 0.1) << "averaged over 2 x 2";
  }
}

TEST(Land, bad_files_are_refused_by_name) {
  const Folder folder;
  const auto complaint = [](ElevationFile file, std::optional<Place> origin = {}) -> std::string {
    LandSettings settings;
    settings.files = {std::move(file)};
    settings.origin = origin;
    try {
      const Land land(settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(complaint({"nowhere.tif"}), "nowhere.tif: no such file");
  EXPECT_EQ(complaint({folder.path().string()}), folder.path().string() + ": expected a file, got a folder");
  const std::string text = folder / "text.tif";
  FILE* file = std::fopen(text.c_str(), "w");
  std::fputs("no raster", file);
  std::fclose(file);
  EXPECT_NE(complaint({text}).find(text + ": GDAL cannot read it as a raster"), std::string::npos);
  write_raster(folder / "nowhere.tif", {.geotransform = {}}, [](double, double, int) { return 1.0; });
  EXPECT_NE(complaint({folder / "nowhere.tif"}).find("says not where it lies"), std::string::npos);
  EXPECT_NE(complaint({.file = folder / "nowhere.tif", .band = 2, .cell_size = 10}).find("band = 2: expected 1 .. 1"),
            std::string::npos);
  write_raster(folder / "empty.tif", {.geotransform = {}}, [](double, double, int) { return std::nan(""); });
  EXPECT_NE(complaint({.file = folder / "empty.tif", .cell_size = 10}).find("every value is missing"),
            std::string::npos);
  write_raster(folder / "alps.tif", {.coordinate_system = "EPSG:4326", .geotransform = {8, 0.001, 0, 47, 0, -0.001}},
               [](double, double, int) { return 1.0; });
  EXPECT_EQ(complaint({folder / "alps.tif"}), "accepted");
  EXPECT_NE(complaint({folder / "alps.tif"}, Place{46 * degree, 12 * degree}).find("expected within 100 km"),
            std::string::npos);
  write_raster(folder / "flat.tif", {.coordinate_system = "EPSG:4326", .geotransform = {8, 0, 0, 47, 0, 0}},
               [](double, double, int) { return 1.0; });
  EXPECT_NE(complaint({folder / "flat.tif"}), "accepted");
}

TEST(Land, longitudes_across_the_date_line_are_one_place) {
  const Folder folder;
  write_raster(folder / "fiji.tif",
               {.width = 200,
                .height = 100,
                .coordinate_system = "EPSG:4326",
                .geotransform = {179.9, 0.001, 0, -16.9, 0, -0.001}},
               [](double x, double, int) { return 1000 * (x - 179.9); });
  LandSettings settings;
  settings.files = {{folder / "fiji.tif"}};
  settings.origin = Place{-16.95 * degree, -179.99 * degree};
  const Land land(settings);
  EXPECT_NEAR(land.altitude(0, 0), 110, 0.1);
  EXPECT_NEAR(land.ground_at({-16.95 * degree, 179.95 * degree}).altitude, 50, 0.1);
}

TEST(Land, relief_is_the_same_every_time_and_keeps_its_bounds) {
  LandSettings settings;
  settings.relief = ReliefSettings{};
  settings.extent = 80'000;
  const Land land(settings), again(settings);
  double highest = 0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-81'000, 81'000);
  for (int i = 0; i < 3000; ++i) {
    const double east = place(random), north = place(random), altitude = land.altitude(east, north);
    EXPECT_EQ(altitude, again.altitude(east, north));
    EXPECT_GE(altitude, 0);
    EXPECT_LE(altitude, settings.relief->height);
    highest = std::max(highest, altitude);
    if (std::max(std::abs(east), std::abs(north)) >= settings.extent) {
      EXPECT_EQ(altitude, land.plain_altitude());
    }
    // Steep but no cliffs of noise: 80 degrees over a metre.
    EXPECT_LT(std::abs(land.altitude(east + 1, north) - altitude), 5.7);
  }
  EXPECT_GT(highest, 0.6 * settings.relief->height);
}

}  // namespace
}  // namespace airlight
