// Land as random walks see it: the reference's solid surface, on Embree's triangles.
#pragma once
#include <functional>
#include <memory>

#include "reference/surface.h"
#include "scene/terrain.h"

namespace airlight {

/// Land of one albedo for each wavelength. The scene's origin is where a Ray's observer stands; triangles are those of
/// the terrain's level of detail.
class TerrainSurface : public reference::Surface {
 public:
  /// @param albedo  for each of the walks' wavelengths, in [0, 1]
  TerrainSurface(std::shared_ptr<const Terrain> terrain, std::vector<double> albedo);

  std::optional<Hit> hit(const reference::Place& from, double farthest) const override;
  bool hides(const reference::Place& from) const override;
  void albedo(const reference::Vector& position, std::span<double> albedo) const override;

 private:
  Position in_scene(const reference::Vector& position) const;

  std::shared_ptr<const Terrain> terrain_;
  std::vector<double> albedo_;
};

}  // namespace airlight
