// The height of the land: elevation files, one inside the other, and procedural relief beyond them. Knows no triangle.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/local_frame.h"
#include "scene/relief.h"
#include "scene/sun_position.h"

namespace airlight {

/// An elevation file, anything that GDAL reads.
struct ElevationFile {
  std::string file;
  int band = 1;
  double height_scale = 1;   ///< file's unit to metres
  double height_offset = 0;  ///< added after scaling [m]
  double cell_size = 0;      ///< for files without coordinates: [m], the file's middle lying at the scene's origin
  double blend = 1000;       ///< width over which its edge becomes what surrounds it [m]
};

struct LandSettings {
  std::vector<ElevationFile> files;  ///< later ones lie on top of earlier ones
  std::optional<ReliefSettings>
      relief;                   ///< beyond the files; none: the sphere at the mean height of the first file's border
  std::optional<Place> origin;  ///< where the scene's frame stands; none: the middle of the first file
  double planet_radius = 6'371'000;      ///< [m]
  std::optional<double> plain_altitude;  ///< [m] beyond everything; none: the mean along the first file's border, or 0
  double extent = 100'000;               ///< half the side of the square that has relief [m]; plain beyond
};

/// The land's height, everywhere on the planet. const use is thread-safe; parts of files are read when first asked for.
class Land {
 public:
  /// @throws InputError naming the file and what is wrong with it.
  explicit Land(LandSettings settings);
  ~Land();
  Land(Land&&) noexcept;
  Land& operator=(Land&&) noexcept;

  const LandSettings& settings() const;
  const LocalFrame& frame() const;
  Place origin() const;

  /// Altitude of the ground [m] at distances east and north of the origin along the sphere [m].
  /// @param cell  smooths what is smaller than this [m]; 0: all there is
  double altitude(double east, double north, double cell = 0) const;
  /// The same for many places (east, north): faster where there is relief.
  void altitudes(std::span<const std::array<double, 2>> places, double cell, std::span<double> altitudes) const;
  /// The smallest cell [m] that shows anything new in a square around a place; infinite on the plain.
  double finest_cell(double east, double north, double half_width) const;
  /// No ground lies higher [m].
  double highest() const;
  /// Altitude of the land beyond everything [m]: a sphere around the planet's centre.
  double plain_altitude() const;
  /// Half the side of the square that is not plain [m]; at most one radius.
  double extent() const;

  /// A place on the ground. Latitude and longitude are those of the files' own planet.
  GroundPoint ground_at(const Place& place) const;

  /// Where a point of the ground lies in the first file: (0, 0) its top left corner, (1, 1) its bottom right; none: no
  /// file.
  std::optional<std::array<double, 2>> file_coordinates(double east, double north) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
