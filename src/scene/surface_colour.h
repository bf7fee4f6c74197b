// What the ground reflects: an image laid over the land, or rock, grass, snow and water by height and slope.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "scene/terrain.h"

namespace airlight {

struct SurfaceSettings {
  std::string image;          ///< of one band or of red, green and blue; empty: by height and slope everywhere
  bool image_linear = false;  ///< values are reflectance; else sRGB-encoded. Integers of 8 and 16 bits mean 0 .. 1
  double image_scale = 1;     ///< of reflectance: photographs are often brighter than the ground was

  double snow_line = 2800;                       ///< above it level ground is white [m]; slopes hold less snow
  double grass_line = 1900;                      ///< above it grass thins out [m]
  double water_level = -1e9;                     ///< level ground up to here is water [m]
  double steepest_grass = 0.65;                  ///< slopes beyond are bare rock [rad]
  double steepest_snow = 0.85;                   ///< [rad]
  double variety = 0.5;                          ///< of patches in colour and limits, 0 .. 1
  std::array<double, 3> rock{0.17, 0.15, 0.13};  ///< linear sRGB reflectance; chosen, not measured
  std::array<double, 3> snow{0.85, 0.87,
                             0.89};  ///< settled snow; fresh snow reflects more than 0.95 (Wiscombe & Warren 1980)
  std::array<double, 3> water{0.02, 0.03, 0.04};  ///< seen from above; no mirror
  std::optional<std::array<double, 3>> grass;     ///< none: the measured spectrum grass_albedo.csv
};

/// Albedo of the ground at given wavelengths. const use is thread-safe.
class SurfaceColour {
 public:
  /// @throws InputError naming the file and what is wrong with it.
  SurfaceColour(SurfaceSettings settings, std::shared_ptr<const Land> land, std::span<const double> wavelengths);
  ~SurfaceColour();
  SurfaceColour(SurfaceColour&&) noexcept;
  SurfaceColour& operator=(SurfaceColour&&) noexcept;

  static constexpr int lanes = 16;
  /// @param hits         1 to `lanes` of them
  /// @param pixel_angle  what is smaller on the ground than a pixel is averaged [rad]
  /// @param albedo       hits x wavelengths, in [0, 1]
  void albedo(std::span<const TerrainHit* const> hits, double pixel_angle, std::span<double> albedo) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
