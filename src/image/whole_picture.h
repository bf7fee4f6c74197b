// Formats that are written whole, by OpenImageIO, which lives in a module of its own that is loaded when first needed:
// on Debian it brings 250 shared libraries along, whose loading takes a third of a second of processor time in every
// command.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/picture_file.h"

namespace airlight {

struct WholePicture {
  std::string format;  ///< OpenImageIO's name: "png", "hdr"
  int width = 0, height = 0;
  std::span<const std::uint8_t> bytes;  ///< RGB, or empty
  std::span<const float> floats;        ///< RGB, where there are no bytes
  Metadata metadata;
  int channels = 3;  ///< 4: the bytes are RGBA; colours are written as they are
};

/// The bytes of the file.
using EncodePicture = std::vector<unsigned char>(const WholePicture& picture);
inline constexpr char encode_picture_symbol[] = "airlight_encode_picture";

/// White words drawn into 8-bit RGB, from a baseline's left end. @throws WorkError where there is no font.
using DrawText = void(std::span<std::uint8_t> rgb, int width, int height, int x, int y, int size,
                      const std::string& text);
inline constexpr char draw_text_symbol[] = "airlight_draw_text";

/// How far words reach to the right of their start [pixels].
using TextWidth = int(int size, const std::string& text);
inline constexpr char text_width_symbol[] = "airlight_text_width";

/// The module's functions. @throws WorkError where the module cannot be loaded.
EncodePicture& encode_picture();
DrawText& draw_text();
TextWidth& text_width();

}  // namespace airlight
