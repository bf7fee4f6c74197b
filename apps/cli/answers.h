// What the sky is asked on the command line, and who answers: the one place that turns atmosphere and model names into
// answers.
#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "airlight/sky.h"

namespace airlight::cli {

/// A quantity by its outside name. Photometric ones are the eye's weight on a spectral one.
struct Asked {
  std::string_view name, unit;
  Quantity spectral;  ///< what is asked of the sky
  bool photometric;   ///< one number: 683 lm/W times the integral over the luminous efficiency
  bool with_sun;      ///< the direct sun on a horizontal plane is added
  bool along_view;    ///< needs the view
};
/// radiance, path_radiance, transmittance, sun_irradiance, sky_irradiance, luminance, sun_illuminance, sky_illuminance,
/// global_illuminance
std::span<const Asked> all_asked();
/// @throws InputError with "did you mean".
const Asked& asked(std::string_view name);

/// A question that can be answered together with others that differ only in their rays.
struct Topic {
  std::string atmosphere, model;
  const Asked* asked = nullptr;
  std::vector<double> wavelengths;  ///< [nm]; empty: photometric_wavelengths()
  int max_order = 0;                ///< 0: all
  auto operator<=>(const Topic&) const = default;
};

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
