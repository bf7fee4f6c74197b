// Which frames of a sequence, and what their files are called.
#pragma once
#include <string>

namespace airlight::cli {

struct FrameRange {
  int first = 0, last = 0;  ///< both are made
  int total = 0;            ///< frames of the whole sequence; 0: not said
  int count() const { return last - first + 1; }
};

/// "240": frames 0 to 239; "100:199": these; "100:199/240": these of 240. @throws InputError.
FrameRange parse_frames(const std::string& text);

/// Names with the frame's number in them: "frames_%04d.exr".
class FrameNames {
 public:
  /// @throws InputError unless there is one place for a number, %d or %04d, and no other %.
  explicit FrameNames(const std::string& pattern);
  std::string name(int frame) const;
  const std::string& pattern() const { return pattern_; }

 private:
  std::string pattern_, before_, after_;
  int digits_ = 1;
};

}  // namespace airlight::cli
