#include "spectral_colours.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "airlight/error.h"
#include "number.h"
#include "optics/colour.h"
#include "scenefile/text_file.h"

namespace airlight::cli {
namespace {

Response read_response(const std::string& path) {
  const std::optional<std::string> text = read_text_file(path);
  if (!text) throw InputError(fmt::format("--sensor = {}: no such file", path));
  return parse_response_csv(*text, path);
}

}  // namespace

std::vector<double> picture_wavelengths(const std::string& text) {
  if (text == "4") return {};
  for (const int count : {8, 16, 40})
    if (text == std::to_string(count)) {
      const double step = 400.0 / count;
      return parse_wavelengths(fmt::format("{}:{}:{}", 380 + step / 2, 780 - step / 2, step), "--wavelengths");
    }
  if (text.find_first_of(":,") == std::string::npos)
    throw InputError(fmt::format("--wavelengths = {}: expected 4, 8, 16, 40, first:last:step or a list, in nm", text));
  auto wavelengths = parse_wavelengths(text, "--wavelengths");
  if (std::ranges::adjacent_find(wavelengths, std::greater_equal<>()) != wavelengths.end())
    throw InputError(fmt::format("--wavelengths = {}: expected increasing wavelengths", text));
  return wavelengths;
}

std::vector<Option> add_spectral_options(const Verb& verb, std::string& wavelengths, bool& spectral,
                                         std::string& sensor) {
  return {verb.option("--wavelengths", wavelengths,
                      "4 (of real time), 8, 16, 40 (bins of 380 .. 780 nm), first:last:step as 360:830:10, or a list "
                      "[nm] (default 4)")
              .type_name("LIST"),
          verb.flag("--spectral", spectral, "radiance at each wavelength as channels of the .exr, too"),
          verb.option("--sensor", sensor,
                      "responses of a camera's three channels, CSV (wavelength,r,g,b), in place of the eye's")
              .type_name("FILE")};
}

SpectralColours::SpectralColours(const Sky& sky, std::span<const double> wavelengths, const std::string& sensor,
                                 bool keep)
    : wavelengths_(wavelengths.begin(), wavelengths.end()), sensor_(sensor), keep_(keep) {
  if (model_info(sky.model()).colours)
    throw InputError(fmt::format("{}: model {} draws in red, green and blue",
                                 keep             ? "--spectral"
                                 : sensor.empty() ? "--wavelengths"
                                                  : "--sensor",
                                 sky.model()));
  const auto four = sky.realtime_wavelengths();
  if (wavelengths_.empty()) wavelengths_.assign(four.begin(), four.end());
  if (!sensor.empty()) {
    weights_ = response_weights(sky.atmosphere(), wavelengths_, read_response(sensor));
    return;
  }
  for (const Xyz& xyz : colour_weights(sky.atmosphere(), wavelengths_)) weights_.push_back(xyz_to_srgb(xyz));
}

std::vector<std::string> SpectralColours::channels() const {
  std::vector<std::string> names;
  for (const double wavelength : wavelengths_) {
    names.push_back(fmt::format("S0.{:g}nm", wavelength));
    const std::size_t point = names.back().find('.', 3);
    if (point != std::string::npos) names.back()[point] = ',';
  }
  return keep_ ? names : std::vector<std::string>{};
}

void SpectralColours::describe(Metadata& metadata) const {
  if (!sensor_.empty()) {
    const auto units = std::ranges::find(metadata, "units", &Metadata::value_type::first);
    if (units != metadata.end()) units->second = "W m-2 sr-1, weighted by the sensor's responses";
    metadata.push_back({"sensor", sensor_});
  }
  if (!keep_) return;
  metadata.push_back({"spectralLayoutVersion", "1.0"});
  metadata.push_back({"emissiveUnits", "W.m^-2.sr^-1.nm^-1"});
}

void SpectralColours::write(PictureOutputs& files, int begin, int end, std::span<const float> values) {
  const std::size_t W = wavelengths_.size(), pixels = values.size() / W;
  rgba_.resize(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::array<double, 3> sum{};
    for (std::size_t w = 0; w < W; ++w)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weights_[w][c] * double(values[i * W + w]);
    for (std::size_t c = 0; c < 3; ++c) rgba_[4 * i + c] = float(sum[c]);
    rgba_[4 * i + 3] = 1;
  }
  std::vector<LayerRows> layers;
  for (std::size_t w = 0; keep_ && w < W; ++w) layers.push_back({values.data() + w, W});
  files.write(begin, end, rgba_, layers);
}

}  // namespace airlight::cli
