#include "scene/surface_colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"
#include "raster_maker.h"

namespace airlight {
namespace {

constexpr double wavelengths[] = {445, 515, 565, 635};

TerrainHit at(double east, double north, double altitude, double slope) {
  TerrainHit hit;
  hit.ground = {east, north, altitude};
  hit.level = float(std::cos(slope));
  hit.distance = 1;
  return hit;
}

std::array<double, 4> albedo(const SurfaceColour& colour, const TerrainHit& hit, double footprint = 1) {
  std::array<double, 4> result;
  const TerrainHit* const hits[] = {&hit};
  colour.albedo(hits, footprint / hit.distance, result);
  return result;
}

TEST(SurfaceColour, snow_lies_high_and_level_rock_is_steep_grass_is_green) {
  const auto land = std::make_shared<Land>(LandSettings{});
  SurfaceSettings settings;
  settings.variety = 0;
  settings.water_level = 0;
  const SurfaceColour colour(settings, land, wavelengths);
  EXPECT_GT(albedo(colour, at(0, 0, 4000, 0.1))[1], 0.8);
  const auto rock = albedo(colour, at(0, 0, 4000, 1.3)), grass = albedo(colour, at(0, 0, 500, 0.1)),
             water = albedo(colour, at(0, 0, 0, 0));
  EXPECT_LT(rock[1], 0.3);
  EXPECT_GT(grass[2], 1.3 * grass[3]) << "green reflects more than red";
  EXPECT_GT(grass[2], 1.3 * grass[0]) << "and more than blue";
  // Feister & Grewe at 565 nm, the mean of the bins around it.
  EXPECT_NEAR(grass[2], 0.089, 0.005);
  EXPECT_LT(water[1], 0.05);
}

TEST(SurfaceColour, an_image_lies_where_it_belongs) {
  const Folder folder;
  write_raster(
      folder / "ground.tif",
      {.width = 100, .height = 100, .coordinate_system = "EPSG:4326", .geotransform = {8, 0.001, 0, 47, 0, -0.001}},
      [](double, double, int) { return 100.0; });
  // North half red, south half gray at half the code values.
  const RasterDescription image{.width = 50, .height = 50, .bands = 3, .bytes = true};
  write_raster(folder / "image.tif", image,
               [](double, double y, int band) { return y < 25 ? (band == 1 ? 255.0 : 0.0) : 128.0; });
  LandSettings settings;
  settings.files = {{folder / "ground.tif"}};
  const auto land = std::make_shared<Land>(settings);
  SurfaceSettings surface;
  surface.image = folder / "image.tif";
  const SurfaceColour colour(surface, land, wavelengths);
  const auto north = albedo(colour, at(0, 2500, 100, 0)), south = albedo(colour, at(0, -2500, 100, 0));
  EXPECT_GT(north[3], 0.9) << "red at 635 nm";
  EXPECT_LT(north[0], 0.05);
  // sRGB code 128 is 0.2159 of white (IEC 61966-2-1).
  for (const double a : south) EXPECT_NEAR(a, 0.2159, 1e-3);
  surface.image_linear = true;
  surface.image_scale = 0.5;
  for (const double a : albedo(SurfaceColour(surface, land, wavelengths), at(0, -2500, 100, 0)))
    EXPECT_NEAR(a, 0.251, 1e-3);
  // Seen from afar it is averaged: at the seam, some of both.
  const auto mean = albedo(colour, at(0, 0, 100, 0), 5000);
  EXPECT_GT(mean[3], 0.25);
  EXPECT_LT(mean[3], 0.9);
}

TEST(SurfaceColour, bad_images_are_refused_by_name) {
  const Folder folder;
  const auto land = std::make_shared<Land>(LandSettings{});
  SurfaceSettings surface;
  surface.image = "nowhere.png";
  EXPECT_THROW(SurfaceColour(surface, land, wavelengths), InputError);
  write_raster(folder / "two.tif", {.bands = 2}, [](double, double, int) { return 1.0; });
  surface.image = folder / "two.tif";
  EXPECT_THROW(SurfaceColour(surface, land, wavelengths), InputError);
  write_raster(folder / "three.tif", {.bands = 3}, [](double, double, int) { return 1.0; });
  surface.image = folder / "three.tif";
  EXPECT_THROW(SurfaceColour(surface, land, wavelengths), InputError)
      << "no coordinates, and no file to stretch it over";
}

}  // namespace
}  // namespace airlight
