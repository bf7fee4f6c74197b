// Frames of systems that blend each with those before it.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "scenefile/animation.h"
#include "sky/frame_blend.h"

namespace airlight::cli {

/// How pictures of this scene gather frames; none: its model draws each in one.
std::optional<Gathering> gathering_of(const Scene& scene);

/// Makes a scene the one frame of that number: random numbers of its own, clouds drifting on unless key frames move them.
void number_frame(Scene& scene, int number, const Animation& animation, double frames_per_second);

/// @throws InputError where the scene's model draws each picture in one frame
void accumulate(Scene& scene, int frames);

class BlendedFrames {
 public:
  /// Frames that are made before the first one, which then differs by no more than what is left of their beginning: at the
  /// published weight of 0.3, 0.7^32 = 1e-5. So a part of a sequence can be made alone.
  static constexpr int run_in = 32;

  /// Linear RGBA of one frame alone.
  using Draw = std::function<std::vector<float>(int number)>;

  /// A frame's picture, made from the last one's if that is the one before, else with a run-in.
  const std::vector<float>& frame(int number, const Gathering& how, const Draw& draw);
  /// The first frame that is drawn when this one is asked for.
  int first_for(int number) const { return blend_ && last_ == number - 1 ? number : number - run_in; }

 private:
  std::optional<FrameBlend> blend_;
  int last_ = 0;
  std::vector<float> picture_;
};

}  // namespace airlight::cli
