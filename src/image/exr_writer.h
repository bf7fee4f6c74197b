// Scanline OpenEXR files, zip-compressed on all cores.
#pragma once
#include <openexr.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/output_file.h"
#include "image/picture_file.h"

namespace airlight {

struct ExrChannel {
  std::string name;
  bool half = true;  ///< else 32-bit float
};
/// The first value of a channel's row, and from one pixel to the next.
struct ExrPlane {
  const float* values;
  std::size_t stride;
};

/// Writes one picture of any channels, strip by strip.
///
/// The OpenEXR library writes the header and the order of the file; blocks of 16 rows are compressed here, with
/// libdeflate (as OpenEXR itself does from version 3.2 on): the same bytes after unpacking, in less than half of zlib's
/// time.
class ExrWriter {
 public:
  /// @param threads  0: all cores
  /// @throws WorkError for an attribute that cannot be written or a disk that is full.
  ExrWriter(OutputFile& file, int width, int height, std::vector<ExrChannel> channels, const Metadata& metadata,
            int threads);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  /// The next row: one plane a channel, in the order of the channels given; within half's range in half channels.
  void row(std::span<const ExrPlane> planes);
  void finish();  ///< after the last row

 private:
  struct Block {
    int first_row = 0, rows = 0;
    std::unique_ptr<std::byte[]> raw, packed;  // as in the file, before and after compression; room for 16 rows
    std::size_t raw_size = 0, packed_size = 0;
  };
  void write_header(const Metadata& metadata);
  void flush();
  void check(exr_result_t result);

  OutputFile& file_;
  const int width_, height_, threads_;
  const std::vector<ExrChannel> channels_;
  std::vector<std::size_t> order_;  // of the channels in the file: by name
  std::size_t row_size_ = 0;        // [bytes]
  int rows_ = 0;
  std::vector<Block> blocks_;
  std::size_t filled_ = 0;  // blocks that hold rows, the last one perhaps not all of its own
  exr_context_t context_ = nullptr;
  std::string message_;            // what the library said last
  std::exception_ptr disk_error_;  // what writing threw: no exception may cross the library's C code
};

}  // namespace airlight
