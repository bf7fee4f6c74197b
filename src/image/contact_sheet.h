// Pictures of one size side by side, each with words below it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/picture_file.h"

namespace airlight {

/// 8-bit sRGB, three bytes a pixel.
struct BytePicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

struct LabelledPicture {
  BytePicture picture;
  std::vector<std::string> lines;
};

/// Row after row of `columns` pictures, at the top left of cells wide enough to read what stands below: longer lines are wrapped.
/// @throws WorkError where no font can be found.
BytePicture contact_sheet(std::span<const LabelledPicture> pictures, int columns);

/// Appears when it is whole. @throws InputError, WorkError as OutputFile does.
void write_png(const std::string& path, const BytePicture& picture, const Metadata& metadata);

}  // namespace airlight
