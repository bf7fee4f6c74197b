// Latitude and longitude, map projections, and the scene's own plane.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>

#include "scene/sun_position.h"

namespace airlight {

/// The plane of distances east and north of a place (azimuthal equidistant on the ellipsoid, so that metres are metres).
class Geography {
 public:
  virtual ~Geography() = default;

  /// Distances east and north [m] of a place. @throws InputError for the far side of the planet.
  virtual std::array<double, 2> plane(const Place& place) const = 0;

  /// Turns points (east, north) into coordinates of another system, in place.
  /// @param name  of the file, for messages. @throws InputError where the system cannot be understood or a point has no image.
  virtual void to_system(const std::string& coordinate_system, const std::string& name,
                         std::span<std::array<double, 2>> points) const = 0;
  /// And back; points too far away become NaN.
  virtual void from_system(const std::string& coordinate_system, const std::string& name,
                           std::span<std::array<double, 2>> points) const = 0;
};

/// @param origin             geodetic
/// @param coordinate_system  WKT that tells which planet it is on; empty: Earth. Earth's systems all become WGS 84.
std::unique_ptr<Geography> make_geography(const Place& origin, const std::string& coordinate_system);

/// Whether coordinates are longitude and latitude in degrees. @throws InputError where the system cannot be understood.
bool is_geographic(const std::string& coordinate_system, const std::string& name);

/// A point of a coordinate system as latitude and longitude on its planet. @throws InputError.
Place place_in(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point);

}  // namespace airlight
