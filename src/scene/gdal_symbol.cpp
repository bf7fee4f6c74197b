// The module's one symbol.
#include "scene/gdal_functions.h"

extern "C" __attribute__((visibility("default"))) const airlight::GdalModule airlight_gdal_module_1{
    airlight::gdal_module::open_raster, airlight::gdal_module::make_geography, airlight::gdal_module::is_geographic,
    airlight::gdal_module::place_in};
