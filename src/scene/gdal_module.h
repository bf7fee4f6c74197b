// GDAL and PROJ live in a module, loaded by those who have elevation files or places: with all they bring along they
// take 50 ms to load.
#pragma once
#include <memory>
#include <string>

#include "scene/geography.h"
#include "scene/raster_file.h"

namespace airlight {

struct GdalModule {
  std::unique_ptr<RasterFile> (*open_raster)(const std::string& path);
  std::unique_ptr<Geography> (*make_geography)(const Place& origin, const std::string& coordinate_system);
  bool (*is_geographic)(const std::string& coordinate_system, const std::string& name);
  Place (*place_in)(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point);
};

/// The name of the module's one symbol, a GdalModule; it changes with the struct.
inline constexpr const char* gdal_module_symbol = "airlight_gdal_module_1";

}  // namespace airlight
