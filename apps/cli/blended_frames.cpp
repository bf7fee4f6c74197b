#include "blended_frames.h"

#include <fmt/core.h>

#include <algorithm>

#include "airlight/error.h"
#include "model/model.h"

namespace airlight::cli {

std::optional<Gathering> gathering_of(const Scene& scene) {
  const Model& model = find_model(scene.picture.model);
  if (!model.gathering) return {};
  const auto given = scene.parameters.find(model.name);
  return model.gathering(model_parameters(model, given == scene.parameters.end() ? Parameters{} : given->second,
                                          std::string(model.name) + "."));
}

void number_frame(Scene& scene, int number, const Animation& animation, double frames_per_second) {
  const auto gathering = gathering_of(scene);
  if (!gathering) return;
  Parameters& own = scene.parameters[scene.picture.model];
  // Where key frames move the clouds, those of the run-in still go on from frame to frame.
  const bool moved = animation.animates(scene.picture.model + ".time");
  own["frame"] = std::vector<double>{double(moved ? std::min(number, 0) : number)};
  own.try_emplace("frame_rate", std::vector<double>{frames_per_second});
  if (gathering->weight > 0) own["frames"] = std::vector<double>{1};
}

void accumulate(Scene& scene, int frames) {
  if (!model_info(scene.picture.model).gathers)
    throw InputError(fmt::format("--accumulate = {}: model {} draws each picture in one frame; expected jetlag", frames,
                                 scene.picture.model));
  Parameters& own = scene.parameters[scene.picture.model];
  own["frames"] = std::vector<double>{double(frames)};
  own["blend"] = std::vector<double>{0};
  own["still"] = std::vector<double>{1};
}

const std::vector<float>& BlendedFrames::frame(int number, const Gathering& how, const Draw& draw) {
  const int first = first_for(number);
  if (first != number) blend_.emplace(how);
  for (last_ = first;; ++last_) {
    const std::vector<float> alone = draw(last_);
    blend_->add(alone);
    picture_.resize(alone.size());
    if (last_ == number) break;
  }
  blend_->read(picture_);
  return picture_;
}

}  // namespace airlight::cli
