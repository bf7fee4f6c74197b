// Elevation files for tests.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "../scratch_folder.h"

namespace airlight {

struct RasterDescription {
  int width = 64, height = 64, bands = 1;
  std::string coordinate_system{};     ///< anything that GDAL understands: "EPSG:32632"; empty: none
  std::vector<double> geotransform{};  ///< six numbers, or none
  std::vector<double> nodata{};        ///< one number, or none
  bool bytes = false;                  ///< 8 bits in place of floats
};

/// Writes a GeoTIFF whose values are those of a function of the coordinates of the pixels' centres, and of the band.
void write_raster(const std::string& path, const RasterDescription& description,
                  const std::function<double(double x, double y, int band)>& value);

}  // namespace airlight
