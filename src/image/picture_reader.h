// Pictures of other programs: any channels by their names, and what the header says of the camera. OpenImageIO reads them, in its
// module (whole_picture.h).
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace airlight {

struct InputChannel {
  std::string name;  ///< as in the file: "ViewLayer.Depth.Z"; where that is another part's too, "part.name"
  int part = 0, index = 0;
  bool half = false;  ///< 16-bit floats, of 11 bits precision
};

/// Row vectors times matrix, four rows after each other, as OpenEXR keeps them.
using Matrix44 = std::array<double, 16>;

struct InputPicture {
  std::string path;
  int width = 0, height = 0;  ///< of the display window, which all parts share
  std::vector<InputChannel> channels = {};
  std::optional<Matrix44> world_to_camera = {}, world_to_ndc = {};  ///< OpenEXR's standard attributes
  std::optional<std::array<double, 8>> chromaticities = {};         ///< of red, green, blue and white: x and y

  /// @throws InputError naming the file, the option and the channels that there are.
  const InputChannel& channel(const std::string& name, const std::string& option) const;
  bool has(const std::string& name) const;
};

/// Reads the header. @throws InputError for a file that is not there, no picture, empty, or of deep pixels.
InputPicture open_picture(const std::string& path);

/// One plane a channel, rows from the top of the display window, 32-bit floats.
/// @param outside  for each channel, what stands where the file has no pixel (its data window may be smaller)
/// @throws InputError for a damaged file.
std::vector<std::vector<float>> read_planes(const InputPicture& picture, std::span<const InputChannel* const> channels,
                                            std::span<const float> outside);

/// A picture as colours alone, whatever its channels are called.
struct ColourPicture {
  int width = 0, height = 0;
  std::vector<float>
      rgba;  ///< linear, rows from the top; alpha as in the file, not multiplied with; 1 where there is none
  bool encoded = false;  ///< the file holds whole numbers, as a display takes them
};

/// Photographs, painted tables: whole numbers are taken as sRGB, floats as linear.
/// @throws InputError for a file that is not there, no picture, damaged, or of deep pixels.
ColourPicture read_colours(const std::string& path);

// The module's functions.
using OpenPicture = InputPicture(const std::string& path);
using ReadPlanes = std::vector<std::vector<float>>(const InputPicture& picture,
                                                   std::span<const InputChannel* const> channels,
                                                   std::span<const float> outside);
using ReadColours = ColourPicture(const std::string& path);  // as in the file, not yet linear
inline constexpr char read_colours_symbol[] = "airlight_read_colours";
inline constexpr char open_picture_symbol[] = "airlight_open_picture", read_planes_symbol[] = "airlight_read_planes";

}  // namespace airlight
