#include "parameter_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "airlight/error.h"
#include "airlight/model_info.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "image/picture_reader.h"
#include "image/whole_picture.h"
#include "optics/srgb.h"

namespace airlight::cli {
namespace {

bool is_picture(const ParameterInfo& key) { return key.kind == ParameterInfo::Kind::picture; }

std::uint8_t byte(double v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0))); }

void write_png(const std::string& path, const ParameterPicture& picture) {
  std::vector<std::uint8_t> bytes(picture.rgba.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double v = std::clamp(double(picture.rgba[i]), 0.0, 1.0);
    bytes[i] = byte(i % 4 == 3 ? v : encode_srgb(v));
  }
  OutputFile file(path);
  const auto png = encode_picture()({"png", picture.width, picture.height, bytes, {}, {}, 4});
  file.write({reinterpret_cast<const char*>(png.data()), png.size()});
  file.commit();
}

void write_exr(const std::string& path, const ParameterPicture& picture) {
  PictureFormat format;
  format.half = false;
  format.layers = {"A"};
  PictureFile file(path, picture.width, picture.height, format, {});
  const LayerRows alpha{&picture.rgba[3], 4};
  file.write_rows(0, picture.height, picture.rgba, {&alpha, 1});
  file.finish();
}

}  // namespace

std::vector<std::string> picture_files(std::string_view model, const Parameters& given) {
  std::vector<std::string> files;
  for (const ParameterInfo& key : model_info(model).parameters) {
    if (!is_picture(key)) continue;
    const auto found = given.find(key.name);
    if (found == given.end()) continue;
    if (const auto* path = std::get_if<std::string>(&found->second)) files.push_back(*path);
  }
  return files;
}

void read_pictures(std::string_view model, Parameters& given) {
  for (const ParameterInfo& key : model_info(model).parameters) {
    if (!is_picture(key)) continue;
    const auto found = given.find(key.name);
    if (found == given.end()) continue;
    const auto* path = std::get_if<std::string>(&found->second);
    if (!path) continue;
    try {
      found->second = std::make_shared<const ParameterPicture>(read_painted(*path));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}.{}: {}", model, key.name, error.what()));
    }
  }
}

ParameterPicture read_painted(const std::string& path) {
  ColourPicture colours = read_colours(path);
  constexpr int most = 4096;
  if (colours.width < 2 || colours.height < 2 || colours.width > most || colours.height > most)
    throw InputError(
        fmt::format("'{}' has {} x {} pixels: expected 2 .. {} a side", path, colours.width, colours.height, most));
  return {path, colours.width, colours.height, std::move(colours.rgba)};
}

void write_painted(const std::string& path, const ParameterPicture& picture) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png") return write_png(path, picture);
  if (ending == ".exr") return write_exr(path, picture);
  throw InputError(fmt::format("-o {}: expected .png or .exr", path));
}

}  // namespace airlight::cli
