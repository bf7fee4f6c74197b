// Air over a finished picture: L = L0 x transmittance + inscatter, pixel by pixel.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "airlight/sky.h"
#include "render/air_light.h"
#include "render/haze_view.h"

namespace airlight {

struct HazeSettings {
  double altitude = 2;                     ///< of the eye [m]
  Direction sun{0, 0, 1};                  ///< unit, in the eye's frame
  bool fill_sky = true;                    ///< else pixels of the sky stay as they are
  bool sun_disc = true;                    ///< in a filled sky
  const AirShadows* shadows = nullptr;     ///< of land, in the eye's frame; must outlive the haze
  std::vector<AirLight> more_lights = {};  ///< beside the Sun; in the eye's frame
};

class HazePicture {
 public:
  HazePicture(const Sky& sky, HazeView view, const HazeSettings& settings);
  ~HazePicture();

  /// Hazes whole rows of the picture.
  ///
  /// With coverage a = alpha and colour premultiplied by it, a pixel becomes M(T B rgb) + a inscatter + (1 - a) sky, where B lifts
  /// linear sRGB to four wavelengths (light_lift.h) and M is its way back; the last term, and alpha 1, only where the sky is filled.
  /// A pixel without depth becomes the sky.
  /// @param begin     the first row
  /// @param distance  of each pixel [m]; infinite: the sky
  /// @param rgba      linear sRGB [cd m^-2], premultiplied; changed in place
  void rows(int begin, std::span<const float> distance, std::span<float> rgba) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Pixels on an object's edge, neither empty nor opaque, may have come without depth: renderers that do not filter depth give that
/// of one sample of the pixel. They get the nearest depth among their eight neighbours.
/// @param alpha  the fourth of each four numbers
void mend_edges(int width, int height, std::span<float> distance, std::span<const float> rgba);

}  // namespace airlight
