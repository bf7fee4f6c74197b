#include "haze_input.h"

#include <fmt/core.h>

#include <cmath>

#include "airlight/error.h"
#include "number.h"

namespace airlight::cli {
namespace {

/// "R,G,B": these; a name without commas: a layer, and of what channels.
std::vector<const InputChannel*> find_channels(const InputPicture& picture, const std::string& text,
                                               const std::string& option, const std::vector<std::string>& of_layer) {
  std::vector<const InputChannel*> found;
  if (text.find(',') == std::string::npos) {
    for (const std::string& name : of_layer)
      found.push_back(&picture.channel(text.empty() ? name : text + '.' + name, option));
    return found;
  }
  for (const std::string_view name : comma_separated(text))
    found.push_back(&picture.channel(std::string(name), option));
  return found;
}

std::vector<const InputChannel*> find_colors(const InputPicture& picture, const std::string& text) {
  const std::string option = "--color-channels";
  auto found = find_channels(picture, text, option, {"R", "G", "B"});
  if (found.size() != 3 && found.size() != 4)
    throw InputError(fmt::format("{} = {}: expected three names, or four with alpha", option, text));
  const std::string alpha = text.empty() ? "A" : text + ".A";
  if (text.find(',') == std::string::npos && picture.has(alpha)) found.push_back(&picture.channel(alpha, option));
  return found;
}

constexpr std::array<double, 8> srgb{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

std::string pixel_name(std::size_t i, int width) {
  return fmt::format("pixel ({}, {})", i % std::size_t(width), i / std::size_t(width));
}

}  // namespace

HazeInput::HazeInput(const HazeOptions& options, DepthKind kind) : color_(open_picture(options.color)) {
  depth_ = options.depth_file.empty() ? color_ : open_picture(options.depth_file);
  if (depth_.width != color_.width || depth_.height != color_.height)
    throw InputError(fmt::format("--depth-file '{}' is {} x {} pixels, --color '{}' {} x {}", depth_.path, depth_.width,
                                 depth_.height, color_.path, color_.width, color_.height));
  colors_ = find_colors(color_, options.color_channels);
  if (kind == DepthKind::position) {
    depths_ = find_channels(depth_, options.depth, "--depth", {"X", "Y", "Z"});
    if (depths_.size() != 3) throw InputError(fmt::format("--depth = {}: expected three names", options.depth));
  } else {
    depths_ = {&depth_.channel(options.depth, "--depth")};
  }
  for (const InputChannel* c : depths_)
    if (c->half)
      notes_.push_back(fmt::format(
          "channel '{}' is of 16-bit floats, whose steps are 1/2000 of the depth: 32-bit floats are better", c->name));
  for (std::size_t i = 0; color_.chromaticities && i < srgb.size(); ++i) {
    if (std::abs((*color_.chromaticities)[i] - srgb[i]) < 0.002) continue;
    notes_.push_back("the file's chromaticities are not those of sRGB, as which its colours are taken");
    break;
  }
}

std::vector<float> HazeInput::read_color(double scale) {
  const float nothing[] = {0, 0, 0, 0};
  const auto planes = read_planes(color_, colors_, std::span(nothing).first(colors_.size()));
  std::vector<float> rgba(4 * planes[0].size(), 1.0f);
  long broken = 0;
  for (std::size_t i = 0; i < planes[0].size(); ++i) {
    bool whole = true;
    for (std::size_t c = 0; c < 3; ++c) rgba[4 * i + c] = float(double(planes[c][i]) * scale);
    if (has_alpha()) rgba[4 * i + 3] = planes[3][i];
    for (std::size_t c = 0; c < 4; ++c) whole &= std::isfinite(rgba[4 * i + c]);
    if (whole) continue;
    ++broken;
    for (std::size_t c = 0; c < 3; ++c) rgba[4 * i + c] = 0;
    if (!std::isfinite(rgba[4 * i + 3])) rgba[4 * i + 3] = 0;
  }
  if (broken) notes_.push_back(fmt::format("pixels whose colour is NaN or infinite, taken as black: {}", broken));
  return rgba;
}

std::vector<float> HazeInput::read_distance(const DepthMeaning& meaning, const HazeView& view, bool bad_is_sky) {
  const bool position = meaning.kind == DepthKind::position;
  // Where a file has no pixel there is sky: at the far end of each kind.
  const float end = meaning.kind == DepthKind::reversed || position ? 0
                    : meaning.kind == DepthKind::buffer || meaning.kind == DepthKind::logarithmic
                        ? 1
                        : std::numeric_limits<float>::infinity();
  const float nothing[] = {end, end, end};
  const auto planes = read_planes(depth_, depths_, std::span(nothing).first(depths_.size()));
  const std::size_t width = std::size_t(depth_.width);
  std::vector<float> result(planes[0].size(), std::numeric_limits<float>::infinity());
  long bad = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto line = view.look((double(i % width) + 0.5) / depth_.width, (double(i / width) + 0.5) / depth_.height);
    if (!line) continue;  // outside a fisheye's circle
    const double metres = position ? distance(meaning, {planes[0][i], planes[1][i], planes[2][i]})
                                   : distance(meaning, double(planes[0][i]), line->cosine);
    if (std::isnan(metres) && !bad_is_sky)
      throw InputError(fmt::format("'{}', channel '{}', {}: depth = {}: expected {} (or give --bad-depth sky)",
                                   depth_.path, depths_[0]->name, pixel_name(i, depth_.width), planes[0][i],
                                   legal_depth(meaning.kind)));
    bad += std::isnan(metres);
    if (!std::isnan(metres)) result[i] = float(metres);
  }
  if (bad) notes_.push_back(fmt::format("pixels without valid depth, taken as sky: {}", bad));
  return result;
}

}  // namespace airlight::cli
