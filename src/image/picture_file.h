// Pictures on disk: linear EXR and HDR in absolute units, tone-mapped PNG. Written to a temporary name, renamed when
// whole.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace airlight {

/// What is said about a picture in its header, in order: name and text or number.
using Metadata = std::vector<std::pair<std::string, std::variant<std::string, double>>>;

enum class ToneCurve {
  filmic,
  reinhard,
  clip,         ///< none: what is above display white is white
  codeflow,     ///< of codeflow.org's program, with its own encoding
  square_root,  ///< the encoding itself, of the Jetlag intro
  exponential,  ///< 1 - exp(-light), as on Rama's page
};
inline constexpr std::array<std::string_view, 6> tone_curves{"filmic",   "reinhard", "clip",
                                                             "codeflow", "sqrt",     "exponential"};  ///< their names

struct PictureFormat {
  bool half = true;                        ///< EXR: half floats (clamped at 65504, said in the metadata), else 32-bit
  std::optional<double> exposure_ev = {};  ///< PNG: linear picture times 2^EV (EV 0: 1 cd/m2 -> 1); none: automatic
  ToneCurve tone_curve = ToneCurve::filmic;
  int compression_threads = 0;           ///< 0: all cores
  std::vector<std::string> layers = {};  ///< EXR: further channels, always 32-bit, by their names in the file
};

/// A further channel's values in the rows at hand: the first, and from one pixel to the next.
struct LayerRows {
  const float* values;
  std::size_t stride;
};

/// Takes a picture row by row: linear sRGB [cd/m^2].
class PictureFile {
 public:
  /// @param path  .exr, .hdr or .png; an existing regular file is replaced only by finish(). A device or pipe is written
  ///              directly, as EXR where its name does not say.
  /// @throws InputError for an unknown ending or a folder that cannot be written, before anything is written.
  PictureFile(const std::string& path, int width, int height, const PictureFormat& format, const Metadata& metadata);
  ~PictureFile();  ///< not finished: the temporary file is removed

  /// A file of that name is EXR, and takes layers.
  static bool has_layers(const std::string& path);

  /// Rows [begin, end), consecutive from 0; RGBA, alpha is not written.
  /// @param layers  one for each of the format's; formats other than EXR pass over them
  void write_rows(int begin, int end, std::span<const float> rgba, std::span<const LayerRows> layers = {});

  /// Completes and renames. @throws WorkError when the disk is full or closing fails; nothing is left behind.
  void finish();

  /// Things worth telling the person who asked: "3 pixels above half float's range were clamped"; empty: nothing.
  std::vector<std::string> notes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
