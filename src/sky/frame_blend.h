// Frames of one picture, mixed as they come.
#pragma once
#include <span>
#include <vector>

#include "model/model.h"

namespace airlight {

class FrameBlend {
 public:
  explicit FrameBlend(const Gathering& how) : how_(how) {}

  int frames() const { return frames_; }  ///< that were added
  /// @param frame  values in linear light, as many each time
  void add(std::span<const float> frame);
  /// What the frames so far make, in linear light. @param out  as many values as a frame has
  void read(std::span<float> out) const;

 private:
  Gathering how_;
  int frames_ = 0;
  std::vector<float> mixed_;  ///< as it is blended

  bool encoded() const { return how_.weight > 0 && how_.encoded; }
};

}  // namespace airlight
