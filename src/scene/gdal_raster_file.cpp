// RasterFile by GDAL.
#include <gdal_priv.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <vector>

#include "airlight/error.h"
#include "scene/gdal_functions.h"
#include "scene/gdal_quiet.h"

namespace airlight {
namespace {

void register_formats() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    // Its default grows with the machine's memory.
    constexpr GIntBig most = 256 << 20;
    if (GDALGetCacheMax64() > most) GDALSetCacheMax64(most);
  });
}

double metres_per_unit(const std::string& unit) {
  if (unit == "ft" || unit == "foot" || unit == "feet" || unit == "Foot") return 0.3048;
  if (unit == "US survey foot" || unit == "us-ft" || unit == "Foot_US" || unit == "ftUS") return 1200.0 / 3937;
  if (unit == "km") return 1000;
  return 1;
}

struct Deleter {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

class GdalRasterFile : public RasterFile {
 public:
  explicit GdalRasterFile(const std::string& path);

  const std::string& path() const override { return path_; }
  int width() const override { return dataset_->GetRasterXSize(); }
  int height() const override { return dataset_->GetRasterYSize(); }
  int bands() const override { return dataset_->GetRasterCount(); }
  const std::string& coordinate_system() const override { return coordinate_system_; }
  std::optional<std::array<double, 6>> geotransform() const override { return geotransform_; }
  double integer_range(int band) const override;
  void read(int band, int column, int row, int width, int height, int out_width, int out_height,
            float* out) const override;

 private:
  std::string path_, coordinate_system_;
  std::unique_ptr<GDALDataset, Deleter> dataset_;
  std::optional<std::array<double, 6>> geotransform_;
  mutable std::mutex mutex_;
};

GdalRasterFile::GdalRasterFile(const std::string& path) : path_(path) {
  register_formats();
  const GdalQuiet quiet;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path + ": no such file");
  if (std::filesystem::is_directory(path, error)) throw InputError(path + ": expected a file, got a folder");
  dataset_.reset(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
  if (!dataset_) {
    const std::string why = CPLGetLastErrorMsg();  // none where no format knows it
    throw InputError(path + ": GDAL cannot read it as a raster" + (why.empty() ? "" : ": " + why));
  }
  GDALDataset& dataset = *dataset_;
  if (dataset.GetRasterCount() < 1 || dataset.GetRasterXSize() < 2 || dataset.GetRasterYSize() < 2) {
    throw InputError(path + ": " + std::to_string(dataset.GetRasterXSize()) + " x " +
                     std::to_string(dataset.GetRasterYSize()) + " values in " +
                     std::to_string(dataset.GetRasterCount()) + " bands: expected at least 2 x 2 in one");
  }
  coordinate_system_ = dataset.GetProjectionRef();
  std::array<double, 6> transform{};
  if (dataset.GetGeoTransform(transform.data()) == CE_None) {
    const double determinant = transform[1] * transform[5] - transform[2] * transform[4];
    if (!std::isfinite(determinant) || determinant == 0 || !std::isfinite(transform[0] + transform[3])) {
      throw InputError(path + ": its geotransform is singular or not finite");
    }
    geotransform_ = transform;
  }
}
double GdalRasterFile::integer_range(int band) const {
  const std::lock_guard lock(mutex_);
  switch (dataset_->GetRasterBand(band)->GetRasterDataType()) {
    case GDT_Byte:
      return 255;
    case GDT_UInt16:
      return 65535;
    default:
      return 0;
  }
}

void GdalRasterFile::read(int number, int column, int row, int width, int height, int out_width, int out_height,
                          float* out) const {
  const std::lock_guard lock(mutex_);
  const GdalQuiet quiet;
  GDALRasterBand& band = *dataset_->GetRasterBand(number);
  GDALRasterIOExtraArg extra;
  INIT_RASTERIO_EXTRA_ARG(extra);
  extra.eResampleAlg = out_width < width || out_height < height ? GRIORA_Average : GRIORA_NearestNeighbour;
  const auto refuse = [&] {
    throw InputError(path_ + ": band " + std::to_string(number) + " cannot be read: " + CPLGetLastErrorMsg());
  };
  if (band.RasterIO(GF_Read, column, row, width, height, out, out_width, out_height, GDT_Float32, 0, 0, &extra) !=
      CE_None) {
    refuse();
  }
  const std::size_t count = std::size_t(out_width) * std::size_t(out_height);
  const float missing = std::numeric_limits<float>::quiet_NaN();
  int declared = 0;
  const double nodata = band.GetNoDataValue(&declared);
  for (std::size_t i = 0; i < count; ++i) {
    const bool none = declared ? out[i] == static_cast<float>(nodata) : out[i] == -9999.0f || out[i] == -32768.0f;
    if (none || !std::isfinite(out[i])) out[i] = missing;
  }
  if (!declared && (band.GetMaskFlags() & GMF_ALL_VALID) == 0) {
    std::vector<GByte> mask(count);
    if (band.GetMaskBand()->RasterIO(GF_Read, column, row, width, height, mask.data(), out_width, out_height, GDT_Byte,
                                     0, 0, nullptr) != CE_None) {
      refuse();
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (mask[i] == 0) out[i] = missing;
    }
  }
  const double unit = metres_per_unit(band.GetUnitType());
  const double scale = band.GetScale() * unit, offset = band.GetOffset() * unit;
  if (scale == 1 && offset == 0) return;
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<float>(out[i] * scale + offset);
}

}  // namespace

namespace gdal_module {
std::unique_ptr<RasterFile> open_raster(const std::string& path) { return std::make_unique<GdalRasterFile>(path); }
}  // namespace gdal_module
}  // namespace airlight
