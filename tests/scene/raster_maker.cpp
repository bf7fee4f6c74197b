#include "raster_maker.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <stdexcept>

namespace airlight {

void write_raster(const std::string& path, const RasterDescription& d,
                  const std::function<double(double x, double y, int band)>& value) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDataset* const file =
      driver->Create(path.c_str(), d.width, d.height, d.bands, d.bytes ? GDT_Byte : GDT_Float32, nullptr);
  if (!file) throw std::runtime_error("cannot write " + path);
  if (!d.coordinate_system.empty()) {
    OGRSpatialReference system;
    system.SetFromUserInput(d.coordinate_system.c_str());
    file->SetSpatialRef(&system);
  }
  std::vector<double> g = d.geotransform;
  if (!g.empty()) file->SetGeoTransform(g.data());
  if (g.empty()) g = {0, 1, 0, 0, 0, 1};
  std::vector<float> row(std::size_t(d.width));
  for (int band = 1; band <= d.bands; ++band) {
    if (!d.nodata.empty()) file->GetRasterBand(band)->SetNoDataValue(d.nodata[0]);
    for (int j = 0; j < d.height; ++j) {
      for (int i = 0; i < d.width; ++i) {
        row[std::size_t(i)] =
            float(value(g[0] + g[1] * (i + 0.5) + g[2] * (j + 0.5), g[3] + g[4] * (i + 0.5) + g[5] * (j + 0.5), band));
      }
      if (file->GetRasterBand(band)->RasterIO(GF_Write, 0, j, d.width, 1, row.data(), d.width, 1, GDT_Float32, 0, 0,
                                              nullptr) != CE_None) {
        throw std::runtime_error("cannot write " + path);
      }
    }
  }
  GDALClose(file);
}

}  // namespace airlight
