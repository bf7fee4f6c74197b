#include "write_picture.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace airlight {

void write_picture(const std::string& path, const PictureToWrite& picture) {
  OIIO::ImageSpec spec(picture.width, picture.height, int(picture.channels.size()),
                       picture.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  std::vector<float> pixels(picture.channels.size() * std::size_t(picture.width) * std::size_t(picture.height));
  for (const auto& [name, values] : picture.channels) {
    const std::size_t c = spec.channelnames.size();
    spec.channelnames.push_back(name);
    for (std::size_t i = 0; i < values.size(); ++i) pixels[picture.channels.size() * i + c] = values[i];
  }
  const OIIO::TypeDesc matrix = OIIO::TypeDesc::TypeMatrix;
  if (picture.world_to_ndc) spec.attribute("worldtoNDC", matrix, picture.world_to_ndc->data());
  if (picture.world_to_camera) spec.attribute("worldtocamera", matrix, picture.world_to_camera->data());
  const auto out = OIIO::ImageOutput::create(path);
  if (!out || !out->open(path, spec) || !out->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !out->close())
    throw std::runtime_error("cannot write " + path);
}

}  // namespace airlight
