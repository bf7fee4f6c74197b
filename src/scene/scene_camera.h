// A camera that stands on the land or above it.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>

#include "airlight/camera.h"
#include "scene/land.h"
#include "scene/terrain.h"

namespace airlight {

/// Where something is: latitude and longitude, or distances east and north of the scene's origin along the sphere [m].
using Spot = std::variant<std::array<double, 2>, Place>;

/// What a scene says of its camera.
struct SceneCamera {
  Camera camera;  ///< projection, picture, and where it looks unless `target` says so; its altitude is not used
  Spot spot = std::array<double, 2>{};
  std::optional<double> altitude;         ///< above the sphere [m]
  double height_above_ground = 2;         ///< [m] where there is no altitude
  std::optional<Spot> target;             ///< what it looks at
  std::optional<double> target_altitude;  ///< [m]; none: the ground there
  std::string key = "camera.altitude";    ///< how a complaint about the altitude begins: file, line, key
};

/// The same, put into the scene.
struct PlacedCamera {
  Camera camera;  ///< altitude and directions set; directions are in the eye's own frame
  Position eye{};
  LocalFrame::Axes axes{};  ///< of the eye's frame, in the scene's

  /// From the eye's frame to the scene's and back.
  Direction to_scene(const Direction& d) const;
  Direction from_scene(const Direction& d) const;
  /// What the triangles for this camera should be: everything but the wanted size.
  LevelOfDetail detail() const;
};

/// @throws InputError for a camera inside the ground: one that is to stand above it gives height_above_ground.
PlacedCamera place_camera(const SceneCamera& camera, const Land& land);

}  // namespace airlight
