#include "image/picture_reader.h"

#include <algorithm>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "load_module.h"
#include "optics/srgb.h"

namespace airlight {
namespace {

template <class Function>
Function& from_module(const char* symbol) {
  return *reinterpret_cast<Function*>(
      load_from_module("airlight_openimageio", symbol, "reading pictures needs OpenImageIO"));
}

}  // namespace

bool InputPicture::has(const std::string& name) const {
  return std::ranges::any_of(channels, [&](const InputChannel& c) { return c.name == name; });
}

const InputChannel& InputPicture::channel(const std::string& name, const std::string& option) const {
  for (const InputChannel& c : channels)
    if (c.name == name) return c;
  std::vector<std::string_view> names;
  for (const InputChannel& c : channels) names.push_back(c.name);
  throw InputError(option + ": '" + path + "' has no channel '" + name + "'" + did_you_mean(name, names));
}

InputPicture open_picture(const std::string& path) {
  static OpenPicture& open = from_module<OpenPicture>(open_picture_symbol);
  return open(path);
}

ColourPicture read_colours(const std::string& path) {
  static ReadColours& read = from_module<ReadColours>(read_colours_symbol);
  ColourPicture picture = read(path);
  if (!picture.encoded) return picture;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    if (i % 4 != 3) picture.rgba[i] = float(decode_srgb(double(picture.rgba[i])));
  return picture;
}

std::vector<std::vector<float>> read_planes(const InputPicture& picture, std::span<const InputChannel* const> channels,
                                            std::span<const float> outside) {
  static ReadPlanes& read = from_module<ReadPlanes>(read_planes_symbol);
  return read(picture, channels, outside);
}

}  // namespace airlight
