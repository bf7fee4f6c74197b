// `airlight sky --model reference`: a picture by random walks, refined until its error is as small as asked for.
#pragma once
#include <string>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/camera.h"
#include "image/picture_file.h"

namespace airlight::cli {

struct ReferenceSky {
  Atmosphere atmosphere;
  Camera camera;                    ///< of a cube: one face; the six stand side by side
  Direction sun;                    ///< unit, towards its centre
  std::vector<double> wavelengths;  ///< [nm]; empty: the four of real time
  double target_error = 0.01;       ///< median over the pixels of standard error / luminance
  int width() const { return camera.width * (camera.projection == Projection::cube ? 6 : 1); }  ///< of the picture

  std::vector<std::string> outputs;
  PictureFormat format;
  Metadata metadata;
};

/// Writes the picture and, beside the first output, NAME.error.exr: standard error / luminance of each pixel. While it
/// works, NAME.walks holds what was found so far; started again with the same words, it goes on from there.
/// @returns the exit code. @throws InputError, WorkError, Interrupted.
int render_reference_sky(ReferenceSky sky);

}  // namespace airlight::cli
