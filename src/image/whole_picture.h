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
};

/// The bytes of the file.
using EncodePicture = std::vector<unsigned char>(const WholePicture& picture);
inline constexpr char encode_picture_symbol[] = "airlight_encode_picture";

/// The module's function. @throws WorkError where the module cannot be loaded.
EncodePicture& encode_picture();

}  // namespace airlight
