// Lines of sight of somebody else's picture: from our own camera's words, or from the matrices in its header.
#pragma once
#include <functional>
#include <optional>

#include "airlight/camera.h"
#include "image/picture_reader.h"

namespace airlight {

/// What a pixel looks along.
struct SightLine {
  Direction view{0, 1, 0};  ///< unit, in the eye's frame (east, north, up)
  double cosine = 1;        ///< of its angle to the axis that z is measured along; a face's own in a cube
};

struct HazeView {
  /// The line through picture coordinates, (0, 0) top left and (1, 1) bottom right; none outside a fisheye's circle.
  std::function<std::optional<SightLine>(double u, double v)> look;
  Camera camera;  ///< the same camera in words (of a shifted lens the nearest unshifted one), one face of a cube
  int faces = 1;  ///< a cube's lie side by side
  std::optional<std::array<double, 3>> eye;  ///< in the file's own axes and unit, where its matrices say
  double eye_height = 0;                     ///< the eye's coordinate upwards, in the file's unit
};

/// @param camera  projection, pixels, angles; a cube's width is that of one face
HazeView haze_view(const Camera& camera);

enum class UpAxis { y, z };

/// From OpenEXR's standard attributes. Its convention, which is RenderMan's: row vectors (point times matrix); camera space is
/// left-handed, x right, y up, z forward; NDC's (0, 0) and (1, 1) are the display window's upper left and lower right corners. A
/// right-handed camera space (the matrix does not mirror) is taken as OpenGL's, which looks along -z.
/// @param up     of the file's world, right-handed. Compass: z up has x east, y north; y up has x east, -z north
/// @param north  azimuth of that north [rad]
/// @param camera pixels, and the field of view where there is no worldToNDC
/// @throws InputError naming the file where it has no matrix, or one that no lens makes.
HazeView haze_view(const InputPicture& picture, UpAxis up, double north, const Camera& camera);

}  // namespace airlight
