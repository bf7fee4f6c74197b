// Named values, checked against what may be said: the parameters of models and the inputs of adapters.
#pragma once
#include <span>

#include "airlight/parameters.h"

namespace airlight {

/// Values that were checked: each of its kind and in its range.
class Values {
 public:
  Values() = default;
  explicit Values(Parameters values) : values_(std::move(values)) {}

  bool has(std::string_view name) const { return values_.contains(name); }
  double number(std::string_view name) const { return numbers(name).front(); }  ///< also whole numbers and flags
  bool flag(std::string_view name) const { return number(name) != 0; }
  const std::vector<double>& numbers(std::string_view name) const;  ///< three for a colour, grey or not
  const std::string& word(std::string_view name) const;
  /// @throws InputError where it is a name alone, which nobody has read
  const ParameterPicture& picture(std::string_view name) const;
  const Parameters& all() const { return values_; }

 private:
  Parameters values_;
};

/// @param where  begins the names in messages, "inputs." or ""
/// @throws InputError naming key, value and legal range; "did you mean" for unknown keys and words; missing keys.
Values check_parameters(std::span<const ParameterInfo> keys, const Parameters& given, std::string_view where);

/// One value alone, at its name.
ParameterValue check_parameter(const ParameterInfo& key, const ParameterValue& value, std::string_view where);

}  // namespace airlight
