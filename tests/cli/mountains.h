// A small scene of mountains made of noise.
#pragma once
#include <string>

namespace airlight {

/// @param eye  further keys of its camera, whose azimuth is 30 and field of view 60 degrees
inline std::string mountains(const std::string& eye) {
  return R"(
air = "earth"
[camera]
width = 64
height = 36
azimuth = 30
field_of_view = 60
)" + eye +
         R"(
[sun]
elevation = 12
azimuth = 80
[relief]
seed = 3
)";
}

}  // namespace airlight
