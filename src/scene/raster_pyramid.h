// One band of a raster at every resolution, smooth between its values.
#pragma once
#include <memory>
#include <vector>

#include "scene/raster_file.h"

namespace airlight {

/// The whole raster is held at a resolution of at most 2048 values a side; finer levels are read in blocks where they are
/// asked for. const use is thread-safe.
///
/// Missing values inside the outline are filled smoothly: each takes the mean of its neighbours in the finest coarser level
/// that has any, bilinearly interpolated. Missing values that reach the border lie outside the outline.
class RasterPyramid {
 public:
  /// @param lowest, highest  values beyond count as missing
  RasterPyramid(std::shared_ptr<const RasterFile> file, int band, float lowest, float highest);
  ~RasterPyramid();
  RasterPyramid(RasterPyramid&&) noexcept;
  RasterPyramid& operator=(RasterPyramid&&) noexcept;

  /// Value at a place in pixels of the file, (0, 0) its top left corner; Catmull-Rom between values, constant beyond the edge.
  /// @param cell  in pixels; values of about that size are averaged first
  double at(double column, double row, double cell) const;

  /// Distance [pixels] to the outline: positive inside, negative outside.
  double inside(double column, double row) const;
  /// Mean of the values along the outline.
  double border_mean() const;
  /// Largest value of the whole raster at the resolution that is held.
  double highest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
