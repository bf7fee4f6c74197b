#include "image/picture_file.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "airlight/error.h"
#include "image/exr_writer.h"
#include "image/half_float.h"
#include "image/output_file.h"
#include "image/tone.h"
#include "image/whole_picture.h"

namespace airlight {
namespace {

enum class Kind { exr, hdr, png };

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// None: the name does not say, and is no device or pipe.
std::optional<Kind> kind_of(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == ".exr") return Kind::exr;
  if (ending == ".hdr") return Kind::hdr;
  if (ending == ".png") return Kind::png;
  if (OutputFile::is_direct(path)) return Kind::exr;
  return {};
}

Kind kind_of(const OutputFile& file) {
  if (const auto kind = kind_of(file.target())) return *kind;
  throw InputError("cannot write '" + file.target() + "': the ending '" + ending_of(file.target()) +
                   "' is not one of .exr, .hdr, .png");
}

/// Components that a format can hold [cd/m^2].
struct Range {
  float low, high;
};
Range range_of(Kind kind, const PictureFormat& format) {
  if (kind == Kind::hdr) return {0, 1e38f};  // RGBE's exponent ends at 2^127
  if (kind == Kind::exr && format.half) return {-largest_half, largest_half};
  return {-FLT_MAX, FLT_MAX};
}

std::string counted(long n, const char* what) { return std::to_string(n) + (n == 1 ? " pixel " : " pixels ") + what; }

}  // namespace

bool PictureFile::has_layers(const std::string& path) { return kind_of(path) == Kind::exr; }

struct PictureFile::Impl {
  Impl(const std::string& path, int w, int h, const PictureFormat& f, const Metadata& m)
      : file(path), kind(kind_of(file)), range(range_of(kind, f)), width(w), height(h), format(f), metadata(m) {
    if (kind == Kind::exr) {
      std::vector<ExrChannel> channels;
      for (const char* colour : {"R", "G", "B"}) channels.push_back({colour, format.half});
      for (const std::string& layer : format.layers) channels.push_back({layer, false});
      exr = std::make_unique<ExrWriter>(file, width, height, std::move(channels), metadata, format.compression_threads);
    } else {
      encode_picture();  // a missing module should be told before hours of rendering
      rgb.reserve(3 * std::size_t(width) * std::size_t(height));
    }
  }

  /// The row itself, or where it holds what the format cannot, a mended copy.
  std::span<const float> mended(std::span<const float> row) {
    bool good = true;  // the usual case: a loop that is SIMD
    for (const float v : row) good &= v >= range.low && v <= range.high;
    if (good) return row;
    scratch.assign(row.begin(), row.end());
    for (std::size_t i = 0; i < scratch.size(); i += 4) {
      bool broken = false, above = false, below = false;
      for (std::size_t c = i; c < i + 3; ++c) {
        float& v = scratch[c];
        broken |= !std::isfinite(v);
        if (!std::isfinite(v)) v = 0;
        above |= v > range.high;
        below |= v < range.low;
        v = std::clamp(v, range.low, range.high);
      }
      not_finite += broken;
      too_bright += above;
      too_low += below;
    }
    return scratch;
  }

  void finish_png() {
    const bool automatic = !format.exposure_ev;
    const double ev = automatic ? automatic_exposure(rgb) : *format.exposure_ev;
    std::vector<std::uint8_t> bytes(rgb.size());
    const std::size_t row = 3 * std::size_t(width);
    tbb::task_arena arena(format.compression_threads > 0 ? format.compression_threads : tbb::task_arena::automatic);
    arena.execute([&] {
      tbb::parallel_for(0, height, [&](int y) {
        const std::size_t at = row * std::size_t(y);
        encode_row(std::span(rgb).subspan(at, row), y, ev, format.tone_curve, std::span(bytes).subspan(at, row));
      });
    });
    char text[32];
    std::snprintf(text, sizeof text, "%+.2f", ev);
    exposure = std::string("exposure: EV ") + text + (automatic ? ", automatic" : "");
    metadata.emplace_back("ExposureEV", std::string(text) + (automatic ? " (automatic)" : ""));
    metadata.emplace_back("ToneCurve", std::string(tone_curves[std::size_t(format.tone_curve)]));
    write_whole(
        {.format = "png", .width = width, .height = height, .bytes = bytes, .floats = {}, .metadata = metadata});
  }

  void write_whole(const WholePicture& picture) {
    const std::vector<unsigned char> bytes = encode_picture()(picture);
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  OutputFile file;
  const Kind kind;
  const Range range;
  const int width, height;
  const PictureFormat format;
  Metadata metadata;
  std::unique_ptr<ExrWriter> exr;
  std::vector<float> rgb, scratch;  // rgb: the whole picture, where the format needs it
  int rows = 0;
  long not_finite = 0, too_bright = 0, too_low = 0;
  std::string exposure;
};

PictureFile::PictureFile(const std::string& path, int width, int height, const PictureFormat& format,
                         const Metadata& metadata) {
  if (width < 1 || height < 1 || width > 1 << 20 || height > 1 << 20)
    throw InputError("cannot write '" + path + "': size " + std::to_string(width) + " x " + std::to_string(height) +
                     " is outside 1..1048576");
  impl_ = std::make_unique<Impl>(path, width, height, format, metadata);
}

PictureFile::~PictureFile() = default;

void PictureFile::write_rows(int begin, int end, std::span<const float> rgba, std::span<const LayerRows> layers) {
  Impl& own = *impl_;
  const std::size_t row = 4 * std::size_t(own.width);
  if (begin != own.rows || end < begin || end > own.height || rgba.size() != std::size_t(end - begin) * row ||
      layers.size() != own.format.layers.size())
    throw std::logic_error(
        "PictureFile::write_rows: rows must come in order, each of `width` RGBA pixels, with all layers");
  std::vector<ExrPlane> planes(3 + layers.size());
  for (; own.rows < end; ++own.rows, rgba = rgba.subspan(row)) {
    const std::span<const float> pixels = own.mended(rgba.first(row));
    if (own.exr) {
      for (std::size_t c = 0; c < 3; ++c) planes[c] = {pixels.data() + c, 4};
      for (std::size_t i = 0; i < layers.size(); ++i)
        planes[3 + i] = {layers[i].values + std::size_t(own.rows - begin) * std::size_t(own.width) * layers[i].stride,
                         layers[i].stride};
      own.exr->row(planes);
    } else
      for (std::size_t i = 0; i < row; i += 4) own.rgb.insert(own.rgb.end(), {pixels[i], pixels[i + 1], pixels[i + 2]});
  }
}

void PictureFile::finish() {
  Impl& own = *impl_;
  if (own.rows != own.height) throw std::logic_error("PictureFile::finish: rows are missing");
  if (own.kind == Kind::exr)
    own.exr->finish();
  else if (own.kind == Kind::hdr)
    own.write_whole({.format = "hdr",
                     .width = own.width,
                     .height = own.height,
                     .bytes = {},
                     .floats = own.rgb,
                     .metadata = own.metadata});
  else
    own.finish_png();
  own.file.commit();
}

std::vector<std::string> PictureFile::notes() const {
  const Impl& own = *impl_;
  std::vector<std::string> notes;
  if (!own.exposure.empty()) notes.push_back(own.exposure);
  if (own.too_bright && own.kind == Kind::exr)
    notes.push_back(counted(own.too_bright, "above half float's range were clamped to 65504 cd/m2"));
  if (own.too_low && own.kind == Kind::hdr)
    notes.push_back(counted(own.too_low, "outside the gamut lost their negative part, which .hdr cannot hold"));
  if (own.not_finite)
    notes.push_back(counted(own.not_finite, "with NaN or infinity were written as 0: please report this"));
  return notes;
}

}  // namespace airlight
