#include "image/exr_writer.h"

#include <libdeflate.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "airlight/error.h"
#include "image/half_float.h"

namespace airlight {
namespace {

constexpr int rows_per_block = 16;    // of ZIP compression, fixed by the format
constexpr std::size_t batch = 32;     // blocks compressed at a time: work for many cores, 13 MB at width 4096 in half
constexpr int compression_level = 4;  // OpenEXR's default

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;

/// The format's preparation for zip: even bytes first, then odd ones (the slowly changing high bytes come together),
/// then each byte's difference to the one before, plus 128.
void reorder_and_predict(std::span<const std::byte> raw, std::span<std::uint8_t> sorted, std::span<std::uint8_t> out) {
  const std::size_t pairs = raw.size() / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    sorted[i] = std::uint8_t(raw[2 * i]);
    sorted[pairs + i] = std::uint8_t(raw[2 * i + 1]);
  }
  out[0] = sorted[0];
  for (std::size_t i = 1; i < sorted.size(); ++i) out[i] = std::uint8_t(sorted[i] - sorted[i - 1] + 128);
}

/// One channel of a row: plain loops over arrays, which compilers turn into SIMD.
std::byte* put_halves(const ExrPlane& plane, std::size_t width, std::byte* out) {
  for (std::size_t x = 0; x < width; ++x) {
    const std::uint16_t bits = half_bits(plane.values[x * plane.stride]);
    std::memcpy(out + 2 * x, &bits, 2);
  }
  return out + 2 * width;
}
std::byte* put_floats(const ExrPlane& plane, std::size_t width, std::byte* out) {
  for (std::size_t x = 0; x < width; ++x) std::memcpy(out + 4 * x, plane.values + x * plane.stride, 4);
  return out + 4 * width;
}

}  // namespace

ExrWriter::ExrWriter(OutputFile& file, int width, int height, std::vector<ExrChannel> channels,
                     const Metadata& metadata, int threads)
    : file_(file), width_(width), height_(height), threads_(threads), channels_(std::move(channels)), blocks_(batch) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    order_.push_back(i);
    row_size_ += std::size_t(width) * (channels_[i].half ? 2 : 4);
  }
  std::ranges::sort(order_, {}, [this](std::size_t i) -> const std::string& { return channels_[i].name; });
  exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
  init.user_data = this;
  init.error_handler_fn = [](exr_const_context_t context, exr_result_t, const char* message) {
    void* self = nullptr;
    if (exr_get_user_data(context, &self) == EXR_ERR_SUCCESS && self) static_cast<ExrWriter*>(self)->message_ = message;
  };
  init.write_fn = [](exr_const_context_t, void* user, const void* bytes, std::uint64_t size, std::uint64_t offset,
                     exr_stream_error_func_ptr_t) -> std::int64_t {
    auto* self = static_cast<ExrWriter*>(user);
    try {
      self->file_.write_at(offset, {static_cast<const char*>(bytes), size});
      return std::int64_t(size);
    } catch (...) {
      self->disk_error_ = std::current_exception();
      return -1;
    }
  };
  try {
    check(exr_start_write(&context_, file_.target().c_str(), EXR_WRITE_FILE_DIRECTLY, &init));
    write_header(metadata);
  } catch (...) {
    exr_finish(&context_);
    throw;
  }
}

ExrWriter::~ExrWriter() {
  if (context_) exr_finish(&context_);
}

void ExrWriter::check(exr_result_t result) {
  if (disk_error_) std::rethrow_exception(std::exchange(disk_error_, nullptr));
  if (result != EXR_ERR_SUCCESS)
    throw WorkError("writing '" + file_.target() +
                    "' failed: " + (message_.empty() ? exr_get_default_error_message(result) : message_));
}

void ExrWriter::write_header(const Metadata& metadata) {
  int part = 0;
  check(exr_set_longname_support(context_, 1));  // attribute names of up to 255 characters
  check(exr_add_part(context_, "sky", EXR_STORAGE_SCANLINE, &part));
  check(exr_initialize_required_attr_simple(context_, part, width_, height_, EXR_COMPRESSION_ZIP));
  bool any_half = false;
  for (const std::size_t i : order_) {
    const ExrChannel& channel = channels_[i];
    any_half |= channel.half;
    check(exr_add_channel(context_, part, channel.name.c_str(), channel.half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT,
                          EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
  }
  // Colour: sRGB's primaries and white (IEC 61966-2-1), linear; (1, 1, 1) is a white of 1 cd/m^2.
  const exr_attr_chromaticities_t srgb = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  check(exr_attr_set_chromaticities(context_, part, "chromaticities", &srgb));
  check(exr_attr_set_float(context_, part, "whiteLuminance", 1.0f));
  check(exr_attr_set_string(context_, part, "oiio:ColorSpace", "Linear"));
  if (any_half) check(exr_attr_set_string(context_, part, "HalfClamp", "values above 65504 cd/m2 are clamped"));
  for (const auto& [name, value] : metadata)
    if (const auto* text = std::get_if<std::string>(&value))
      check(exr_attr_set_string(context_, part, name.c_str(), text->c_str()));
    else
      check(exr_attr_set_float(context_, part, name.c_str(), float(std::get<double>(value))));
  check(exr_write_header(context_));
}

void ExrWriter::row(std::span<const ExrPlane> planes) {
  if (rows_ % rows_per_block == 0) {
    Block& next = blocks_[filled_++];
    next.first_row = rows_;
    next.rows = std::min(rows_per_block, height_ - rows_);
    next.raw_size = std::size_t(next.rows) * row_size_;
    if (!next.raw) {
      // Not a vector: it would touch (and the system provide) all the room, of which compression needs little.
      next.raw = std::make_unique_for_overwrite<std::byte[]>(rows_per_block * row_size_);
      next.packed = std::make_unique_for_overwrite<std::byte[]>(rows_per_block * row_size_);
    }
  }
  Block& block = blocks_[filled_ - 1];
  std::byte* out = block.raw.get() + std::size_t(rows_ - block.first_row) * row_size_;
  // A row lies in the file channel by channel, in alphabetical order. The processor is little-endian, as the format is.
  for (const std::size_t i : order_)
    out = channels_[i].half ? put_halves(planes[i], std::size_t(width_), out)
                            : put_floats(planes[i], std::size_t(width_), out);
  ++rows_;
  if (rows_ == block.first_row + block.rows && (filled_ == batch || rows_ == height_)) flush();
}

void ExrWriter::flush() {
  struct Scratch {
    Compressor compressor{libdeflate_alloc_compressor(compression_level), &libdeflate_free_compressor};
    std::vector<std::uint8_t> sorted, predicted;
  };
  tbb::enumerable_thread_specific<Scratch> scratch;
  const auto compress = [&](std::size_t i) {
    Block& block = blocks_[i];
    Scratch& own = scratch.local();
    own.sorted.resize(block.raw_size);
    own.predicted.resize(block.raw_size);
    reorder_and_predict({block.raw.get(), block.raw_size}, own.sorted, own.predicted);
    // Room for less than the raw size: where zip gains nothing it returns 0 and the block is stored as it is.
    block.packed_size = libdeflate_zlib_compress(own.compressor.get(), own.predicted.data(), own.predicted.size(),
                                                 block.packed.get(), block.raw_size - 1);
  };
  tbb::task_arena arena(threads_ > 0 ? threads_ : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, filled_, compress); });
  for (std::size_t i = 0; i < filled_; ++i) {
    const Block& block = blocks_[i];
    const bool stored = block.packed_size == 0;
    const std::byte* bytes = stored ? block.raw.get() : block.packed.get();
    check(exr_write_scanline_chunk(context_, 0, block.first_row, bytes, stored ? block.raw_size : block.packed_size));
  }
  filled_ = 0;
}

void ExrWriter::finish() {
  const exr_result_t result = exr_finish(&context_);
  context_ = nullptr;
  check(result);
}

}  // namespace airlight
