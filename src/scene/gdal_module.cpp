#include "scene/gdal_module.h"

#include "load_module.h"

namespace airlight {
namespace {

const GdalModule& module() {
  static const auto* const loaded = static_cast<const GdalModule*>(
      load_from_module("airlight_gdal", gdal_module_symbol, "elevation files and places on maps need GDAL"));
  return *loaded;
}

}  // namespace

std::unique_ptr<RasterFile> open_raster(const std::string& path) { return module().open_raster(path); }

std::unique_ptr<Geography> make_geography(const Place& origin, const std::string& coordinate_system) {
  return module().make_geography(origin, coordinate_system);
}

bool is_geographic(const std::string& coordinate_system, const std::string& name) {
  return module().is_geographic(coordinate_system, name);
}

Place place_in(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point) {
  return module().place_in(coordinate_system, name, point);
}

}  // namespace airlight
