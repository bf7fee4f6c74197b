#include "sky/frame_blend.h"

#include <algorithm>
#include <cmath>

namespace airlight {

void FrameBlend::add(std::span<const float> frame) {
  ++frames_;
  mixed_.resize(frame.size());
  // The first frame is all there is, whatever its weight.
  const float weight = frames_ == 1 ? 1.0f : how_.weight > 0 ? float(how_.weight) : 1.0f / float(frames_);
  const bool roots = encoded();
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const float value = roots ? std::sqrt(std::max(frame[i], 0.0f)) : frame[i];
    mixed_[i] += weight * (value - mixed_[i]);
  }
}

void FrameBlend::read(std::span<float> out) const {
  const bool roots = encoded();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = roots ? mixed_[i] * mixed_[i] : mixed_[i];
}

}  // namespace airlight
