// Reads back what the command wrote.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace airlight {

struct Picture {
  int width = 0, height = 0;
  std::vector<float> rgb;
  std::string header;                                ///< metadata as text
  std::map<std::string, std::vector<float>> layers;  ///< further channels by name

  float luminance(int x, int y) const {
    const float* pixel = &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    return 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
  }
};

/// @throws std::runtime_error where it cannot be read.
Picture read_picture(const std::string& path);

}  // namespace airlight
