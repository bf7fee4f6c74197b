#include "sky/channel_colours.h"

#include "optics/colour.h"

namespace airlight {

ChannelColours srgb_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths) {
  ChannelColours weights;
  for (const Xyz& xyz : colour_weights(atmosphere, wavelengths)) weights.push_back(xyz_to_srgb(xyz));
  return weights;
}

ChannelColours primaries(double luminance) {
  return {{luminance, 0, 0}, {0, luminance, 0}, {0, 0, luminance}, {0, 0, 0}};
}

}  // namespace airlight
