// The files of `airlight haze`: colour with coverage, and depth.
#pragma once
#include <string>
#include <vector>

#include "haze_options.h"
#include "image/picture_reader.h"

namespace airlight::cli {

class HazeInput {
 public:
  /// Reads the headers and finds the channels. @throws InputError
  HazeInput(const HazeOptions& options, DepthKind kind);
  HazeInput(const HazeInput&) = delete;
  HazeInput& operator=(const HazeInput&) = delete;

  const InputPicture& picture() const { return color_; }  ///< header of the colour
  bool has_alpha() const { return colors_.size() == 4; }

  /// Linear sRGB [cd/m^2], four numbers a pixel; without alpha all is covered.
  std::vector<float> read_color(double scale);
  /// Distance of each pixel [m]; infinite: the sky. @throws InputError naming the first pixel that has no depth.
  std::vector<float> read_distance(const DepthMeaning& meaning, const HazeView& view, bool bad_is_sky);

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  InputPicture color_, depth_;
  std::vector<const InputChannel*> colors_, depths_;  // of the two pictures
  std::vector<std::string> notes_;
};

}  // namespace airlight::cli
