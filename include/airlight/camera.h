#pragma once
#include <array>

namespace airlight {

/// Unit vector in the frame (east, north, up).
using Direction = std::array<double, 3>;

/// Direction from azimuth (from north, clockwise) and elevation above the horizontal [rad].
Direction direction(double azimuth, double elevation);

enum class Projection {
  equirectangular,  ///< azimuth left to right, the camera's azimuth in the middle; zenith at the top
  fisheye,          ///< equidistant, around the camera's axis; black outside the circle of the field of view
  cube,             ///< one face; the six faces are rendered by face number
  perspective,
};

struct Camera {
  Projection projection = Projection::equirectangular;
  int width = 1024, height = 512;
  double altitude = 2;                          ///< [m] above the ground sphere
  double azimuth = 0, elevation = 0, roll = 0;  ///< of the optical axis [rad]; azimuth from north, clockwise
  double field_of_view = 1.5707963267948966;    ///< horizontal (fisheye: full circle) [rad]
  int face = 0;                                 ///< cube: +x, -x, +y, -y, +z, -z = east, west, north, south, up, down
};

/// The unit vector seen at picture coordinates (0, 0) top left .. (1, 1) bottom right.
Direction view_direction(const Camera& camera, double u, double v);

}  // namespace airlight
