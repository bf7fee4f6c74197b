#include "render/terrain_surface.h"

#include <algorithm>

#include "airlight/error.h"

namespace airlight {

using reference::along;

TerrainSurface::TerrainSurface(std::shared_ptr<const Terrain> terrain, std::vector<double> albedo)
    : terrain_(std::move(terrain)), albedo_(std::move(albedo)) {
  for (std::size_t w = 0; w < albedo_.size(); ++w)
    if (!(albedo_[w] >= 0 && albedo_[w] <= 1))
      throw InputError("terrain surface: albedo[" + std::to_string(w) + "] is " + std::to_string(albedo_[w]) +
                       "; legal: 0 .. 1");
}

/// The planet's centre lies one radius below the scene's origin.
Position TerrainSurface::in_scene(const reference::Vector& position) const {
  return {position[0], position[1], position[2] - terrain_->land().frame().radius()};
}

std::optional<reference::Surface::Hit> TerrainSurface::hit(const reference::Place& from, double farthest) const {
  const SceneRay ray{in_scene(from.position), from.direction};
  TerrainHit met;
  terrain_->hits({&ray, 1}, {&met, 1});
  if (!met.hit() || met.distance > farthest) return std::nullopt;
  const reference::Vector normal =
      reference::unit({double(met.normal[0]), double(met.normal[1]), double(met.normal[2])});
  // Off the triangle by what Embree's floats do not tell apart there.
  const double lift = 1e-3 + 1e-6 * reference::length(met.position);
  const reference::Vector position = along(along(from.position, met.distance, from.direction), lift, normal);
  return Hit{met.distance, position, normal};
}

bool TerrainSurface::hides(const reference::Place& from) const {
  // A point that is lit from where it looks: every part of it faces the light.
  const auto& d = from.direction;
  const SunQuestion point{in_scene(from.position), {float(d[0]), float(d[1]), float(d[2])}};
  float visible = 0;
  terrain_->sun_visibility({&point, 1}, d, 0, {&visible, 1});
  return visible < 0.5f;
}

void TerrainSurface::albedo(const reference::Vector&, std::span<double> albedo) const {
  std::copy(albedo_.begin(), albedo_.end(), albedo.begin());
}

}  // namespace airlight
