// Arithmetic of vectors in space.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "airlight/camera.h"

namespace airlight::reference {

using Vector = Direction;  ///< of any length: a place [m] from the planet's centre, or a unit direction

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// Where a walk is, and where it looks.
struct Place {
  Vector position;   ///< [m] from the planet's centre
  Vector direction;  ///< unit
};

/// a + t b
inline Vector along(const Vector& a, double t, const Vector& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
inline Vector unit(const Vector& a) {
  const double scale = 1 / length(a);
  return {scale * a[0], scale * a[1], scale * a[2]};
}

/// 1 - cos of the angle between unit vectors, without cancellation at small angles.
inline double one_minus_cos(const Vector& a, const Vector& b) {
  const Vector apart = along(a, -1, b);
  return std::min(0.5 * dot(apart, apart), 2.0);
}

/// Two unit vectors that make a right-handed frame with the unit vector z (Duff et al. 2017, J. Comput. Graph. Tech. 6,
/// 1: continuous but at z = (0, 0, -1), where the sign keeps it finite).
inline std::pair<Vector, Vector> across(const Vector& z) {
  const double sign = std::copysign(1.0, z[2]), a = -1 / (sign + z[2]), b = z[0] * z[1] * a;
  return {{1 + sign * z[0] * z[0] * a, sign * b, -sign * z[0]}, {b, sign + z[1] * z[1] * a, -z[1]}};
}
/// The direction whose components in the frame around z are sine (cos(azimuth), sin(azimuth)) and cosine.
inline Vector around(const Vector& z, double sine, double cosine, double azimuth) {
  const auto [x, y] = across(z);
  const double cx = sine * std::cos(azimuth), cy = sine * std::sin(azimuth);
  return {cx * x[0] + cy * y[0] + cosine * z[0], cx * x[1] + cy * y[1] + cosine * z[1],
          cx * x[2] + cy * y[2] + cosine * z[2]};
}

}  // namespace airlight::reference
