// The files that one picture goes to.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/picture_file.h"

namespace airlight::cli {

/// How -o's files are made. @throws InputError for an exposure or tone curve that is none.
PictureFormat picture_format(const std::string& exposure, const std::string& tone, bool full_float);

class PictureOutputs {
 public:
  /// @throws InputError where a file is named twice, and all that PictureFile refuses.
  PictureOutputs(const std::vector<std::string>& paths, int width, int height, const PictureFormat& format,
                 const Metadata& metadata);

  void write(int begin, int end, std::span<const float> rgba, std::span<const LayerRows> layers = {});
  void finish();

  std::string names() const;  ///< "a.exr, a.png"
  void tell_notes() const;    ///< what the files have to say, on standard error

 private:
  std::vector<std::string> paths_;
  std::vector<std::unique_ptr<PictureFile>> files_;
};

/// The place of a word in a list of words. @throws InputError with "did you mean".
std::size_t choose(std::string_view option, std::string_view text, const std::vector<std::string_view>& names);

}  // namespace airlight::cli
