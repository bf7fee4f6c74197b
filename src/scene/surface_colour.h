// What the ground reflects: an image laid over the land, or rock, grass, snow and water by height and slope.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "airlight/spectrum.h"
#include "scene/terrain.h"

namespace airlight {

struct SurfaceSettings {
  std::string image;  ///< of three bands; empty: by height and slope
  bool image_linear =
      false;  ///< values are linear reflectance; else sRGB-encoded (8 and 16 bit integers are scaled to 0..1)
  double image_scale = 1;  ///< of reflectance; bright photographs are brighter than ground

  double snow_line = 2800;                             ///< [m] above which level ground is white; slopes hold less
  double tree_line = 1900;                             ///< [m] above which grass thins out
  double water_level = -1e9;                           ///< [m] up to which level ground is water
  double steepest_grass = 0.65, steepest_snow = 0.85;  ///< [rad] slopes beyond are bare rock
  double variety = 0.5;                                ///< of patches in colour and limits, 0: none, 1: strong
};

/// Albedo of the ground at given wavelengths. const use is thread-safe.
class SurfaceColour {
 public:
  /// @throws InputError naming the file and what is wrong with it.
  SurfaceColour(SurfaceSettings settings, std::shared_ptr<const Land> land, std::span<const double> wavelengths);
  ~SurfaceColour();
  SurfaceColour(SurfaceColour&&) noexcept;
  SurfaceColour& operator=(SurfaceColour&&) noexcept;

  /// @param footprint  width of the ground that the pixel covers [m]: what is smaller is averaged
  /// @param albedo     one value a wavelength, in [0, 1]
  void albedo(const TerrainHit& hit, double footprint, std::span<float> albedo) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
