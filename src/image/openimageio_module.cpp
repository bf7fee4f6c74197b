// The module that holds OpenImageIO; see whole_picture.h.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include "airlight/error.h"
#include "image/whole_picture.h"

namespace airlight {
namespace {

std::string as_text(const std::variant<std::string, double>& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return OIIO::Strutil::fmt::format("{:.9g}", std::get<double>(value));
}

/// Radiance headers hold comments only; OpenImageIO writes none. Lines stay below the 128 bytes that its reader takes
/// at once.
void insert_comments(std::vector<unsigned char>& file, const Metadata& metadata) {
  std::string comments;
  for (const auto& [name, value] : metadata) {
    std::string line = name + ": " + as_text(value);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, ' ');
    for (std::size_t at = 0; at < line.size(); at += 100)
      comments += (at ? "#   " : "# ") + line.substr(at, 100) + "\n";
  }
  const auto first_line = std::find(file.begin(), file.end(), '\n');
  if (first_line != file.end()) file.insert(first_line + 1, comments.begin(), comments.end());
}

}  // namespace

extern "C" std::vector<unsigned char> airlight_encode_picture(const WholePicture& picture) {
  const bool floats = picture.bytes.empty();
  const OIIO::TypeDesc type = floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, type);
  if (picture.channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);  // else colours are divided by alpha
  spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
  if (picture.format == "png") {
    for (const auto& [name, value] : picture.metadata) spec.attribute(name, as_text(value));
    // PNG_FILTER_NONE: differences of dithered neighbours are noise. 15 % smaller than libpng's own choice, in 0.4 of its time.
    spec.attribute("png:filter", 8);
  }

  OIIO::Filesystem::IOVecOutput memory;
  OIIO::Filesystem::IOProxy* proxy = &memory;
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  const std::string name = "picture." + picture.format;
  const auto out = OIIO::ImageOutput::create(name);
  if (!out) throw WorkError("OpenImageIO cannot write " + picture.format + ": " + OIIO::geterror());
  const void* pixels = floats ? static_cast<const void*>(picture.floats.data()) : picture.bytes.data();
  if (!out->open(name, spec) || !out->write_image(type, pixels) || !out->close())
    throw WorkError("OpenImageIO cannot write " + picture.format + ": " + out->geterror());
  std::vector<unsigned char> file = std::move(memory.buffer());
  if (picture.format == "hdr") insert_comments(file, picture.metadata);
  return file;
}

namespace {

/// Where Debian's package fonts-dejavu-core puts it; elsewhere OpenImageIO searches for the name.
std::string font() {
  const std::string debian = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  return OIIO::Filesystem::exists(debian) ? debian : "DejaVuSans";
}

}  // namespace

extern "C" int airlight_text_width(int size, const std::string& text) {
  const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, size, font());
  return box.defined() ? box.xend : 0;
}

extern "C" void airlight_draw_text(std::span<std::uint8_t> rgb, int width, int height, int x, int y, int size,
                                   const std::string& text) {
  OIIO::ImageBuf picture(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), rgb.data());
  constexpr float white[] = {0.95f, 0.95f, 0.95f};
  if (!OIIO::ImageBufAlgo::render_text(picture, x, y, text, size, font(), white))
    throw WorkError("cannot draw words (the font DejaVu Sans is in the package fonts-dejavu-core): " +
                    picture.geterror());
}

}  // namespace airlight
