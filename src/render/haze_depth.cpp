#include "render/haze_depth.h"

#include <cmath>

namespace airlight {
namespace {

constexpr double sky = std::numeric_limits<double>::infinity(), wrong = std::numeric_limits<double>::quiet_NaN();

/// Length along the camera's axis, in the file's unit.
double along_axis(const DepthMeaning& m, double d) {
  switch (m.kind) {
    case DepthKind::buffer:
    case DepthKind::reversed: {
      // 1 / z is linear in d: 1 / near at one end, 1 / far at the other.
      const double nearness = m.kind == DepthKind::reversed ? d : 1 - d;
      const double inverse = nearness / m.near + (1 - nearness) / m.far;
      return nearness <= 0 || inverse <= 0 ? sky : 1 / inverse;
    }
    case DepthKind::logarithmic:
      if (d >= 1) return sky;
      return m.constant > 0 ? std::expm1(d * std::log1p(m.constant * m.far)) / m.constant
                            : m.near * std::exp(d * std::log(m.far / m.near));
    default:
      return d;
  }
}

bool normalised(DepthKind kind) {
  return kind == DepthKind::buffer || kind == DepthKind::reversed || kind == DepthKind::logarithmic;
}

}  // namespace

double distance(const DepthMeaning& m, double value, double cosine) {
  if (std::isnan(value) || value < 0 || (normalised(m.kind) && value > 1)) return wrong;
  const double length = along_axis(m, value);
  if (length >= m.far) return sky;
  return m.unit * (m.kind == DepthKind::distance ? length : length / cosine);
}

double distance(const DepthMeaning& m, const std::array<double, 3>& p) {
  if (std::isnan(p[0]) || std::isnan(p[1]) || std::isnan(p[2])) return wrong;
  if (p[0] == 0 && p[1] == 0 && p[2] == 0) return sky;
  const double length = std::hypot(p[0] - m.eye[0], p[1] - m.eye[1], p[2] - m.eye[2]);
  return !(length < m.far) ? sky : m.unit * length;
}

std::string_view legal_depth(DepthKind kind) {
  return normalised(kind) ? "0 .. 1" : kind == DepthKind::position ? "numbers" : "0 or more, infinity for the sky";
}

}  // namespace airlight
