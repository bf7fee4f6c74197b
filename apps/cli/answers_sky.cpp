// The models of the sky: everything goes to airlight::Sky, many rays at once.
#include "answers.h"
#include "options.h"

namespace airlight::cli {
namespace {

class SkyAnswerer : public Answerer {
 public:
  SkyAnswerer(std::string model, Workshop workshop) : model_(std::move(model)), workshop_(std::move(workshop)) {}

  bool has(const Asked& asked) const override { return !asked.name.empty(); }

  std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays) override {
    const Sky& sky = above(topic.atmosphere);
    return as_asked(topic, rays, [&](Quantity quantity, std::span<const double> wavelengths) {
      // Red, green and blue that stand for no wavelengths are asked for by none.
      std::vector<double> values(rays.size() * (wavelengths.empty() ? 3 : wavelengths.size()));
      sky.evaluate(quantity, rays, wavelengths, values, topic.max_order);
      return values;
    });
  }

  std::string engine() const override { return describe(*workshop_.engine); }

 private:
  const Sky& above(const std::string& atmosphere) {
    if (const auto found = skies_.find(atmosphere); found != skies_.end()) return found->second;
    // A batch may name any number of files; a few kept are enough, since equal lines are answered together.
    if (skies_.size() >= 64) skies_.clear();
    const Parameters own = model_ == workshop_.model ? workshop_.parameters : Parameters{};
    return skies_.emplace(atmosphere, Sky(workshop_.atmosphere(atmosphere), model_, workshop_.engine, own))
        .first->second;
  }

  std::string model_;
  Workshop workshop_;
  std::map<std::string, Sky> skies_;
};

}  // namespace

std::unique_ptr<Answerer> make_sky_answerer(const std::string& model, const Workshop& workshop) {
  return std::make_unique<SkyAnswerer>(model, workshop);
}

}  // namespace airlight::cli
