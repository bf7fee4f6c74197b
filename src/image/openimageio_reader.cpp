// The part of OpenImageIO's module that reads; see picture_reader.h.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "airlight/error.h"
#include "image/picture_reader.h"

namespace airlight {
namespace {

std::unique_ptr<OIIO::ImageInput> open(const std::string& path, const OIIO::ImageSpec* wishes = nullptr) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError("cannot read '" + path + "': no such file");
  if (!std::filesystem::is_regular_file(status)) throw InputError("cannot read '" + path + "': not a regular file");
  auto input = OIIO::ImageInput::open(path, wishes);
  if (!input) throw InputError("cannot read '" + path + "': " + OIIO::geterror());
  return input;
}

template <std::size_t n>
std::optional<std::array<double, n>> numbers(const OIIO::ImageSpec& spec, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const OIIO::ParamValue* found = spec.find_attribute(name);
    if (!found || found->type().numelements() * found->type().aggregate != int(n)) continue;
    if (found->type().basetype != OIIO::TypeDesc::FLOAT) continue;
    std::array<double, n> values{};
    const auto* data = static_cast<const float*>(found->data());
    std::copy_n(data, n, values.begin());
    return values;
  }
  return {};
}

}  // namespace

extern "C" InputPicture airlight_open_picture(const std::string& path) {
  const auto input = open(path);
  InputPicture picture;
  picture.path = path;
  std::set<std::string> taken;
  OIIO::ImageSpec spec;
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    spec = input->spec(part);
    if (spec.deep) throw InputError("cannot read '" + path + "': pixels are deep; flatten them first");
    if (part == 0) {
      picture.width = spec.full_width;
      picture.height = spec.full_height;
      // OpenImageIO's own names for OpenEXR's attributes, or those of other formats.
      picture.world_to_camera = numbers<16>(spec, {"worldtocamera", "worldToCamera"});
      picture.world_to_ndc = numbers<16>(spec, {"worldtoNDC", "worldToNDC", "worldtoscreen"});
      picture.chromaticities = numbers<8>(spec, {"chromaticities"});
    }
    // A part of another size cannot be laid over the others.
    if (spec.full_width != picture.width || spec.full_height != picture.height) continue;
    const std::string own(spec.get_string_attribute("oiio:subimagename"));
    for (int i = 0; i < spec.nchannels; ++i) {
      std::string name = spec.channelnames[std::size_t(i)];
      if (taken.contains(name)) name = (own.empty() ? std::to_string(part) : own) + "." + name;
      if (!taken.insert(name).second) continue;
      picture.channels.push_back({name, part, i, spec.channelformat(i) == OIIO::TypeDesc::HALF});
    }
  }
  if (picture.width < 1 || picture.height < 1 || picture.channels.empty())
    throw InputError("cannot read '" + path + "': the picture is empty");
  return picture;
}

extern "C" ColourPicture airlight_read_colours(const std::string& path) {
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // else OpenImageIO multiplies colours with alpha
  const auto input = open(path, &wishes);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep) throw InputError("cannot read '" + path + "': pixels are deep; flatten them first");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
    throw InputError("cannot read '" + path + "': the picture is empty");
  const auto channels = std::size_t(spec.nchannels), pixels = std::size_t(spec.width) * std::size_t(spec.height);
  std::vector<float> values(channels * pixels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    throw InputError("cannot read '" + path + "': " + input->geterror());
  ColourPicture picture{spec.width, spec.height, std::vector<float>(4 * pixels, 1.0f),
                        !spec.format.is_floating_point()};
  const char* const names[] = {"R", "G", "B"};
  for (int c = 0; c < 4; ++c) {
    // Grey: one channel is all three.
    int from = c == 3 ? spec.alpha_channel : spec.channelindex(names[c]);
    if (from < 0 && c < 3) from = spec.nchannels < 3 ? 0 : c;
    if (from < 0) continue;
    for (std::size_t i = 0; i < pixels; ++i)
      picture.rgba[4 * i + std::size_t(c)] = values[channels * i + std::size_t(from)];
  }
  return picture;
}

extern "C" std::vector<std::vector<float>> airlight_read_planes(const InputPicture& picture,
                                                                std::span<const InputChannel* const> channels,
                                                                std::span<const float> outside) {
  const auto input = open(picture.path);
  const auto width = std::size_t(picture.width), height = std::size_t(picture.height);
  std::vector<std::vector<float>> planes;
  std::vector<float> window;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const InputChannel& channel = *channels[c];
    const OIIO::ImageSpec spec = input->spec(channel.part);
    window.resize(std::size_t(spec.width) * std::size_t(spec.height));
    if (!input->read_image(channel.part, 0, channel.index, channel.index + 1, OIIO::TypeDesc::FLOAT, window.data()))
      throw InputError("cannot read '" + picture.path + "', channel '" + channel.name + "': " + input->geterror());
    std::vector<float>& plane = planes.emplace_back(width * height, outside[c]);
    const int left = spec.x - spec.full_x, top = spec.y - spec.full_y;  // of the data in the display window
    const int begin = std::max(left, 0), end = std::min(left + spec.width, picture.width);
    for (int y = std::max(top, 0); y < std::min(top + spec.height, picture.height); ++y) {
      if (begin < end)
        std::copy_n(&window[std::size_t(y - top) * std::size_t(spec.width) + std::size_t(begin - left)], end - begin,
                    &plane[std::size_t(y) * width + std::size_t(begin)]);
    }
  }
  return planes;
}

}  // namespace airlight
