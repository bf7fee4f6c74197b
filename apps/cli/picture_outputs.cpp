#include "picture_outputs.h"

#include <fmt/core.h>

#include <set>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "number.h"

namespace airlight::cli {

std::size_t choose(std::string_view option, std::string_view text, const std::vector<std::string_view>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return i;
  throw InputError(fmt::format("{} = {}: unknown{}", option, text, did_you_mean(text, names)));
}

PictureFormat picture_format(const std::string& exposure, const std::string& tone, bool full_float) {
  PictureFormat format;
  format.half = !full_float;
  if (exposure != "auto") format.exposure_ev = parse_number(exposure, "--exposure", {-100, 100, "EV (or auto)"});
  format.tone_curve = ToneCurve(choose("--tone", tone, {tone_curves.begin(), tone_curves.end()}));
  return format;
}

PictureOutputs::PictureOutputs(const std::vector<std::string>& paths, int width, int height,
                               const PictureFormat& format, const Metadata& metadata)
    : paths_(paths) {
  if (std::set(paths.begin(), paths.end()).size() != paths.size()) throw InputError("-o: the same file is named twice");
  for (const std::string& path : paths)
    files_.push_back(std::make_unique<PictureFile>(path, width, height, format, metadata));
}

void PictureOutputs::write(int begin, int end, std::span<const float> rgba, std::span<const LayerRows> layers) {
  for (const auto& file : files_) file->write_rows(begin, end, rgba, layers);
}

void PictureOutputs::finish() {
  for (const auto& file : files_) file->finish();
}

std::string PictureOutputs::names() const {
  std::string names;
  for (const std::string& path : paths_) names += (names.empty() ? "" : ", ") + path;
  return names;
}

void PictureOutputs::tell_notes() const {
  for (std::size_t i = 0; i < files_.size(); ++i)
    for (const std::string& note : files_[i]->notes()) fmt::print(stderr, "{}: {}\n", paths_[i], note);
}

}  // namespace airlight::cli
