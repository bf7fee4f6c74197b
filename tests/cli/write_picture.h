// Makes pictures as other programs do.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace airlight {

struct PictureToWrite {
  int width = 0, height = 0;
  std::map<std::string, std::vector<float>> channels;
  std::optional<std::array<float, 16>> world_to_ndc = {}, world_to_camera = {};
  bool half = false;
};

/// An .exr of these channels. @throws std::runtime_error where it cannot be written.
void write_picture(const std::string& path, const PictureToWrite& picture);

}  // namespace airlight
