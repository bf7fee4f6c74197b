#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "airlight/parameters.h"

namespace airlight {

/// How a published system that answers in red, green and blue becomes a picture. Its air is its own: the atmosphere that a Sky
/// is made with gives the Sun's place alone.
struct ColourModel {
  std::vector<double> wavelengths;  ///< [nm] nominal, of red, green, blue; empty: colours that stand for no wavelengths
  double luminance;                 ///< [cd/m^2] of a radiance of 1 in its own unit, in pictures
  std::string_view tone;            ///< the tone curve of its own: "clip" or one that is named after it
  double sun_radius = 0;            ///< [rad] of the Sun's disc that it draws; 0: none, or one of its own making
};

/// A model of the sky.
struct ModelInfo {
  std::string_view name, summary;
  std::span<const ParameterInfo> parameters = {};
  std::span<const Preset> presets = {};
  const ColourModel* colours = nullptr;  ///< set: it answers in red, green and blue
  bool gathers = false;  ///< its pictures gather frames: parameters frame, frames, frame_rate, time, still, blend
};
std::vector<ModelInfo> models();
/// @throws InputError with "did you mean".
ModelInfo model_info(std::string_view name);

}  // namespace airlight
