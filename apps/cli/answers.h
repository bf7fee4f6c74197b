// What the sky is asked on the command line, and who answers: the one place that turns atmosphere and model names into
// answers.
#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "airlight/sky.h"
#include "question.h"

namespace airlight::cli {

/// Atmospheres and models by name, made when first asked for.
class Skies {
 public:
  Skies(std::shared_ptr<Engine> engine, AirOverrides overrides)
      : engine_(std::move(engine)), overrides_(std::move(overrides)) {}

  /// @throws InputError for unknown names, files that cannot be read, or overrides that do not apply.
  const Sky& sky(const std::string& atmosphere, const std::string& model);

 private:
  std::shared_ptr<Engine> engine_;
  AirOverrides overrides_;
  std::map<std::pair<std::string, std::string>, Sky> made_;
};

/// Answers for N rays: N x W values, ray slowest; W is 1 for photometric questions.
/// @throws InputError naming the value that is out of range; WorkError.
std::vector<double> answer(const Sky& sky, const Asked& asked, std::span<const Ray> rays,
                           std::span<const double> wavelengths, int max_order = 0);

}  // namespace airlight::cli
