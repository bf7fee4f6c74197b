// The scene's frame on the curved planet.
#pragma once
#include <array>
#include <cmath>

#include "airlight/camera.h"

namespace airlight {

/// A point of the scene [m]: east, north and up from its origin along straight axes. The origin lies on the planet's
/// sphere of altitude 0, whose centre is (0, 0, -radius): far from the origin the ground sinks below the plane up = 0.
using Position = std::array<double, 3>;

/// The same point as one walks to it: distances along the sphere (azimuthal equidistant from the origin), and altitude
/// [m].
struct GroundPoint {
  double east = 0, north = 0, altitude = 0;
};

class LocalFrame {
 public:
  explicit LocalFrame(double radius) : radius_(radius) {}

  double radius() const { return radius_; }  ///< of the planet's sphere [m]

  /// Altitude above the sphere [m].
  double altitude(const Position& p) const {
    // |p - centre|^2 - radius^2 without the squares of the radius, which would leave a metre of noise.
    const double excess = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + 2 * radius_ * p[2];
    return excess / (distance_to_centre(p) + radius_);
  }

  /// Local vertical.
  Direction up(const Position& p) const {
    const double scale = 1 / distance_to_centre(p);
    return {p[0] * scale, p[1] * scale, (p[2] + radius_) * scale};
  }

  /// East, north and up of somebody standing at a point: the scene's own axes, turned by the least angle that makes up vertical.
  struct Axes {
    Direction east, north, up;
  };
  Axes axes(const Position& p) const {
    const Direction u = up(p);
    const double scale = 1 / (1 + u[2]);  // Rodrigues' rotation from (0, 0, 1) to up; nobody stands at the antipodes
    return {{1 - u[0] * u[0] * scale, -u[0] * u[1] * scale, -u[0]},
            {-u[0] * u[1] * scale, 1 - u[1] * u[1] * scale, -u[1]},
            u};
  }

  Position position(const GroundPoint& g) const {
    const double arc2 = (g.east * g.east + g.north * g.north) / (radius_ * radius_);
    // sin(a)/a and 1 - cos(a): series below 0.1 rad (600 km on Earth), where the next term is 3e-13.
    double sinc, versine;
    if (arc2 < 0.01) {
      sinc = 1 - arc2 / 6 * (1 - arc2 / 20 * (1 - arc2 / 42));
      versine = arc2 / 2 * (1 - arc2 / 12 * (1 - arc2 / 30 * (1 - arc2 / 56)));
    } else {
      const double arc = std::sqrt(arc2), half = std::sin(arc / 2);
      sinc = std::sin(arc) / arc;
      versine = 2 * half * half;
    }
    const double across = sinc * (1 + g.altitude / radius_);
    return {g.east * across, g.north * across, g.altitude - (radius_ + g.altitude) * versine};
  }

  GroundPoint ground(const Position& p) const {
    // atan(q)/q: series below 0.1 rad, where the next term is 8e-12.
    const double across2 = p[0] * p[0] + p[1] * p[1], down = p[2] + radius_, q2 = across2 / (down * down);
    double stretch = radius_ / down;
    if (q2 < 0.01 && down > 0) {
      stretch *= 1 - q2 * (1.0 / 3 - q2 * (1.0 / 5 - q2 * (1.0 / 7 - q2 / 9)));
    } else if (across2 > 0) {
      const double across = std::sqrt(across2);
      stretch = radius_ * std::atan2(across, down) / across;
    }
    return {p[0] * stretch, p[1] * stretch, altitude(p)};
  }

 private:
  double distance_to_centre(const Position& p) const {
    return std::sqrt(p[0] * p[0] + p[1] * p[1] + (p[2] + radius_) * (p[2] + radius_));
  }
  double radius_;
};

}  // namespace airlight
