#include "image/contact_sheet.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

#include "image/output_file.h"
#include "image/whole_picture.h"

namespace airlight {
namespace {

constexpr int text_size = 15, line_height = 20, margin = 8;  // [pixels]
constexpr int least_width = 300;  // of a cell: a small picture's words take two or three lines
constexpr std::uint8_t background = 28;

/// Lines of whole words, none wider than a cell unless one word is.
std::vector<std::string> wrapped(const std::vector<std::string>& lines, int width) {
  std::vector<std::string> all;
  for (const std::string& line : lines) {
    all.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (!all.back().empty() && text_width()(text_size, all.back() + ' ' + word) > width) all.emplace_back();
      all.back() += (all.back().empty() ? "" : " ") + word;
    }
  }
  return all;
}

}  // namespace

BytePicture contact_sheet(std::span<const LabelledPicture> pictures, int columns) {
  int width = least_width, height = 0;
  for (const LabelledPicture& p : pictures)
    width = std::max(width, p.picture.width), height = std::max(height, p.picture.height);
  std::vector<std::vector<std::string>> words;
  std::size_t lines = 0;
  for (const LabelledPicture& p : pictures) {
    words.push_back(wrapped(p.lines, width));
    lines = std::max(lines, words.back().size());
  }
  const int rows = (int(pictures.size()) + columns - 1) / columns;
  const int across = width + margin, down = height + int(lines) * line_height + 2 * margin;
  BytePicture sheet{columns * across + margin, rows * down + margin, {}};
  sheet.rgb.assign(3 * std::size_t(sheet.width) * std::size_t(sheet.height), background);
  for (std::size_t n = 0; n < pictures.size(); ++n) {
    const BytePicture& picture = pictures[n].picture;
    const int left = margin + int(n) % columns * across, top = margin + int(n) / columns * down;
    for (int y = 0; y < picture.height; ++y) {
      const std::size_t to = std::size_t(top + y) * std::size_t(sheet.width) + std::size_t(left);
      std::copy_n(&picture.rgb[3 * std::size_t(y) * std::size_t(picture.width)], 3 * picture.width, &sheet.rgb[3 * to]);
    }
    for (std::size_t line = 0; line < words[n].size(); ++line) {
      const int baseline = top + height + int(line + 1) * line_height;
      draw_text()(sheet.rgb, sheet.width, sheet.height, left, baseline, text_size, words[n][line]);
    }
  }
  return sheet;
}

void write_png(const std::string& path, const BytePicture& picture, const Metadata& metadata) {
  OutputFile file(path);
  const auto bytes = encode_picture()({"png", picture.width, picture.height, picture.rgb, {}, metadata});
  file.write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  file.commit();
}

}  // namespace airlight
