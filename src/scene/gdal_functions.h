// What the module's sources tell each other.
#pragma once
#include "scene/gdal_module.h"

namespace airlight::gdal_module {

std::unique_ptr<RasterFile> open_raster(const std::string& path);
std::unique_ptr<Geography> make_geography(const Place& origin, const std::string& coordinate_system);
bool is_geographic(const std::string& coordinate_system, const std::string& name);
Place place_in(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point);

}  // namespace airlight::gdal_module
