// What other programs call depth, as a distance.
#pragma once
#include <array>
#include <limits>
#include <string_view>

namespace airlight {

enum class DepthKind {
  z,            ///< length along the camera's axis
  distance,     ///< length along the line of sight
  position,     ///< the point itself, three channels
  buffer,       ///< d of a perspective z-buffer: 0 at near, 1 at far
  reversed,     ///< the same, 1 at near, 0 at far
  logarithmic,  ///< log(z / near) / log(far / near); or with a constant C, log(C z + 1) / log(C far + 1)
};

struct DepthMeaning {
  DepthKind kind = DepthKind::z;
  double near = 0,
         far = std::numeric_limits<double>::infinity();  ///< in the file's unit; nothing from `far` on: it is the sky
  double constant = 0;                                   ///< of a logarithmic depth; 0: by near
  double unit = 1;                                       ///< metres per unit of the file
  std::array<double, 3> eye{};                           ///< of positions, in the file's axes and unit
};

/// Distance [m] from the eye; infinite: the sky. NaN for what is no depth of this kind: NaN, negative, outside 0 .. 1.
/// @param cosine  of the angle between the line of sight and the camera's axis
double distance(const DepthMeaning& meaning, double value, double cosine);

/// (0, 0, 0), with which renderers clear the channels, is the sky, as infinite positions are.
double distance(const DepthMeaning& meaning, const std::array<double, 3>& position);

/// The values that a kind may have, for messages.
std::string_view legal_depth(DepthKind kind);

}  // namespace airlight
