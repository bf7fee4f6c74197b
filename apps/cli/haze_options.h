// The words of `airlight haze`.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "commands.h"
#include "options.h"
#include "render/haze_depth.h"
#include "render/haze_view.h"

namespace airlight::cli {

struct HazeOptions {
  // the picture
  std::string color, color_channels, depth = "Z", depth_file, depth_kind = "z", bad_depth = "error", sky = "fill";
  double unit = 1, scale = 1;
  std::optional<double> near, far, constant;
  std::string eye, up_axis = "z";
  // its camera
  std::string projection;
  std::optional<double> field_of_view, azimuth, elevation, roll, altitude;
  bool exr_camera = false;
  double north = 0;
  // the air
  std::string scene;
  AirOptions air;
  SunOptions sun;
  std::string model, engine = "simd";
  bool no_air_shadows = false;
  // what is written
  std::vector<std::string> outputs;
  std::string exposure = "auto", tone = "filmic";
  bool full_float = false, no_sun = false;

  void add_to(const Verb& verb);

  /// @throws InputError for words that mean nothing or do not go together.
  DepthMeaning depth_meaning() const;  ///< but for the eye
  UpAxis up() const;
  bool fill_sky() const;
  bool bad_depth_is_sky() const;
  std::optional<std::array<double, 3>> eye_position() const;
  /// What these words change in a camera. @param complete  nothing was known of it: the lens must be said
  void change(Camera& camera, bool complete) const;
};

}  // namespace airlight::cli
