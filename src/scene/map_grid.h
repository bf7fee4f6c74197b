// From the scene's plane to a raster's pixels, fast enough for every vertex.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "scene/geography.h"
#include "scene/raster_file.h"

namespace airlight {

/// Map projections are smooth: exact values at 33 x 33 points over the file, Catmull-Rom between them. The error (of fourth
/// order in the spacing) is below 0.01 pixels for files of some hundred kilometres (tested).
class MapGrid {
 public:
  /// @param cell_size  of a file without coordinates, whose middle is put at the origin [m]
  /// @param extent     what is farther east or north than this is not wanted [m]
  /// @throws InputError naming the file: no coordinates, or none near the scene.
  MapGrid(const RasterFile& file, const Geography& geography, double cell_size, double extent);

  /// Pixel coordinates, (0, 0) the file's top left corner, of a place (east, north) [m]; continued linearly beyond the file.
  std::array<double, 2> pixel(double east, double north) const;

  double pixel_width() const { return pixel_width_; }    ///< [m]
  double pixel_height() const { return pixel_height_; }  ///< [m]
  /// Box [m] around the part of the file that is wanted.
  double west() const { return west_; }
  double east() const { return east_; }
  double south() const { return south_; }
  double north() const { return north_; }

 private:
  static constexpr int nodes = 33;
  const std::array<double, 2>& node(int i, int j) const { return grid_[std::size_t(j) * (nodes + 2) + std::size_t(i)]; }

  double west_ = 0, east_ = 0, south_ = 0, north_ = 0;
  double pixel_width_ = 1, pixel_height_ = 1;
  std::vector<std::array<double, 2>> grid_;  ///< one more node on each side
};

/// Where a file's middle lies; none: it has no coordinates. @throws InputError.
std::optional<Place> middle_of(const RasterFile& file);

}  // namespace airlight
