#include "frame_names.h"

#include <fmt/core.h>

#include "airlight/error.h"
#include "number.h"

namespace airlight::cli {

FrameRange parse_frames(const std::string& text) {
  constexpr Interval legal{0, 1e8, "frames"}, legal_count{1, 1e8, "frames"};
  const auto number = [&](std::string_view part, const Interval& interval) {
    return parse_whole(part, fmt::format("--frames = {}: ", text) + std::string(part), interval);
  };
  const std::size_t colon = text.find(':'), slash = text.find('/');
  if (colon == std::string::npos) {
    const int total = parse_whole(text, "--frames", legal_count);
    return {0, total - 1, total};
  }
  FrameRange range;
  const std::string_view all = text;
  range.first = number(all.substr(0, colon), legal);
  range.last = number(all.substr(colon + 1, slash == std::string::npos ? slash : slash - colon - 1), legal);
  if (slash != std::string::npos) range.total = number(all.substr(slash + 1), legal_count);
  if (range.last < range.first || (range.total > 0 && range.last >= range.total))
    throw InputError(fmt::format("--frames = {}: expected N, FIRST:LAST or FIRST:LAST/N with FIRST <= LAST < N", text));
  return range;
}

FrameNames::FrameNames(const std::string& pattern) : pattern_(pattern) {
  const auto refuse = [&] {
    throw InputError(fmt::format(
        "-o {}: expected one place for the frame's number, as in frames_%04d.exr, or a movie's name, as in day.mp4",
        pattern));
  };
  const std::size_t begin = pattern.find('%'), end = pattern.find('d', begin);
  if (begin == std::string::npos || end == std::string::npos) refuse();
  before_ = pattern.substr(0, begin);
  after_ = pattern.substr(end + 1);
  const std::string width = pattern.substr(begin + 1, end - begin - 1);
  if (after_.find('%') != std::string::npos) refuse();
  if (width.empty()) return;
  if (width.size() != 2 || width[0] != '0' || width[1] < '1' || width[1] > '9') refuse();
  digits_ = width[1] - '0';
}

std::string FrameNames::name(int frame) const { return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_); }

}  // namespace airlight::cli
