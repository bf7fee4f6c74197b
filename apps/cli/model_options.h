// --preset and --set: the parameters of a model on the command line.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/model_info.h"
#include "airlight/sky.h"
#include "command_line.h"

namespace airlight::cli {

/// "0.3", "0.1,0.2,0.3", "true" or a word.
ParameterValue parse_parameter(std::string_view text);
/// The same, back.
std::string parameter_text(const ParameterValue& value);

/// On standard error: what a model has to say of its parameters.
void tell_warnings(const std::vector<std::string>& warnings);

struct ModelOptions {
  std::string preset;
  std::vector<std::string> set;  ///< NAME=VALUE

  void add_to(const Verb& verb);
  /// @throws InputError for text that is no NAME=VALUE; names and ranges are Sky's to check
  Parameters parameters() const;
  /// The elevation of the Sun [degrees] that the preset was made for.
  std::optional<double> sun_elevation(std::string_view model) const;
};

/// How a published system shows its pictures: exposure [EV] and tone curve of its own. None for other models.
struct OwnDisplay {
  std::string exposure, tone;
};
std::optional<OwnDisplay> own_display(std::string_view model, const Parameters& given);

}  // namespace airlight::cli
