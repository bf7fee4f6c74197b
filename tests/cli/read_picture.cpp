#include "read_picture.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace airlight {

Picture read_picture(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  const std::size_t pixels = std::size_t(spec.width) * std::size_t(spec.height), channels = std::size_t(spec.nchannels);
  Picture picture{spec.width, spec.height, std::vector<float>(3 * pixels), {}, {}};
  std::vector<float> all(channels * pixels);
  input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, all.data());
  for (std::size_t c = 0; c < channels; ++c) {
    const std::string& name = spec.channelnames[c];
    const std::size_t colour = name == "R" ? 0 : name == "G" ? 1 : name == "B" ? 2 : 3;
    auto& layer = picture.layers[name];
    if (colour == 3) layer.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      if (colour < 3)
        picture.rgb[3 * i + colour] = all[channels * i + c];
      else
        layer[i] = all[channels * i + c];
    }
  }
  for (const auto& attribute : spec.extra_attribs)
    picture.header += attribute.name().string() + " = " + attribute.get_string() + '\n';
  return picture;
}

}  // namespace airlight
