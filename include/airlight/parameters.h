#pragma once
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace airlight {

/// A painted table. The core library reads no files; its name is told where parameters are listed.
struct ParameterPicture {
  std::string name;
  int width = 0, height = 0;
  std::vector<float> rgba;  ///< linear, rows from the top
};

/// A number (one), a colour or vector (several), a word, or a picture.
using ParameterValue = std::variant<std::vector<double>, std::string, std::shared_ptr<const ParameterPicture>>;
/// Values by name, as a person gives them: those that are not named keep their defaults.
using Parameters = std::map<std::string, ParameterValue, std::less<>>;

/// What may be said under a name, and in which range.
struct ParameterInfo {
  enum class Kind {
    number,
    whole,   ///< a number without a fraction
    flag,    ///< 0 or 1
    colour,  ///< red, green, blue; one number stands for a grey
    vector,  ///< `size` numbers
    list,    ///< one number or more, up to `size`
    word,    ///< one of `words`
    picture  ///< a ParameterPicture; a name [file] is one that is still to be read
  };
  std::string_view name;
  Kind kind = Kind::number;
  std::string_view unit = "1", text = "";
  double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();  ///< of each number
  std::size_t size = 3;
  std::vector<std::string_view> words = {};
  std::optional<ParameterValue> otherwise = {};  ///< when it is not given
  bool optional = false;                         ///< without `otherwise`: may be left out, and then there is none
};

/// Values that belong together, under a name.
struct Preset {
  std::string_view name, text;
  Parameters values;
  std::optional<double> sun_elevation = {};  ///< [degrees] that it was made for
};

}  // namespace airlight
