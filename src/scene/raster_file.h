// A raster on disk, read through GDAL: whichever format, window by window.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>

namespace airlight {

/// An open file. Thread-safe: reads queue up.
class RasterFile {
 public:
  virtual ~RasterFile() = default;

  virtual const std::string& path() const = 0;
  virtual int width() const = 0;
  virtual int height() const = 0;
  virtual int bands() const = 0;

  /// Coordinate system as WKT; empty: the file does not say.
  virtual const std::string& coordinate_system() const = 0;
  /// Coordinates = (g[0] + g[1] column + g[2] row, g[3] + g[4] column + g[5] row); none: the file does not say.
  virtual std::optional<std::array<double, 6>> geotransform() const = 0;

  /// Largest value of the band's type where that is an integer of 8 or 16 bits (255, 65535), else 0.
  virtual double integer_range(int band) const = 0;

  /// A window of a band, averaged down to out_width x out_height values; the band's own scale, offset and unit of length
  /// (feet) are applied. Missing values (nodata, mask, NaN, -9999 and -32768 where no nodata is declared) are NaN.
  /// @throws InputError where the file cannot be read.
  virtual void read(int band, int column, int row, int width, int height, int out_width, int out_height,
                    float* out) const = 0;
};

/// @throws InputError naming the file.
std::unique_ptr<RasterFile> open_raster(const std::string& path);

}  // namespace airlight
