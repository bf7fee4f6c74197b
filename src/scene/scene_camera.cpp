#include "scene/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

using std::numbers::pi;

GroundPoint ground_at(const Spot& spot, const Land& land) {
  if (const auto* place = std::get_if<Place>(&spot)) return land.ground_at(*place);
  const auto& p = std::get<std::array<double, 2>>(spot);
  return {p[0], p[1], land.altitude(p[0], p[1])};
}

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::string metres(double value) { return number_text(std::round(value * 10) / 10); }

}  // namespace

Direction PlacedCamera::to_scene(const Direction& d) const {
  Direction result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = d[0] * axes.east[k] + d[1] * axes.north[k] + d[2] * axes.up[k];
  return result;
}
Direction PlacedCamera::from_scene(const Direction& d) const {
  return {dot(d, axes.east), dot(d, axes.north), dot(d, axes.up)};
}

LevelOfDetail PlacedCamera::detail() const {
  LevelOfDetail detail;
  detail.eye = eye;
  const double c = std::cos(camera.elevation);
  detail.axis = to_scene({c * std::sin(camera.azimuth), c * std::cos(camera.azimuth), std::sin(camera.elevation)});
  switch (camera.projection) {
    case Projection::equirectangular:
      detail.pixel_angle = 2 * pi / camera.width;
      break;
    case Projection::fisheye:
      detail.pixel_angle = camera.field_of_view / camera.width;
      detail.half_angle = std::min(0.5 * camera.field_of_view, pi);
      break;
    case Projection::cube:
      detail.pixel_angle = 0.5 * pi / camera.width;
      break;
    case Projection::perspective: {
      // Pixels are finest at the corners; those in the middle set the scale.
      const double half_width = std::tan(0.5 * camera.field_of_view), aspect = double(camera.height) / camera.width;
      detail.pixel_angle = 2 * half_width / camera.width;
      detail.half_angle = std::atan(half_width * std::sqrt(1 + aspect * aspect));
      break;
    }
  }
  return detail;
}

PlacedCamera place_camera(const SceneCamera& scene, const Land& land) {
  const LocalFrame& frame = land.frame();
  PlacedCamera placed{scene.camera, {}, {}};
  GroundPoint g = ground_at(scene.spot, land);
  const double ground = g.altitude;
  g.altitude = scene.altitude.value_or(ground + scene.height_above_ground);
  // The triangles may stand a little higher than the land between their corners.
  constexpr double clearance = 0.1;
  if (g.altitude < ground + clearance) {
    throw InputError(scene.key + " = " + metres(g.altitude) + ": inside the ground, which is at " + metres(ground) +
                     " m there; expected at least " + metres(ground + clearance) + " m (or give height_above_ground)");
  }
  placed.eye = frame.position(g);
  placed.axes = frame.axes(placed.eye);
  placed.camera.altitude = g.altitude;
  if (scene.target) {
    GroundPoint target = ground_at(*scene.target, land);
    if (scene.target_altitude) target.altitude = *scene.target_altitude;
    const Position p = frame.position(target);
    const Direction d = placed.from_scene({p[0] - placed.eye[0], p[1] - placed.eye[1], p[2] - placed.eye[2]});
    const double flat = std::hypot(d[0], d[1]);
    if (flat > 0) placed.camera.azimuth = std::atan2(d[0], d[1]);
    placed.camera.elevation = std::atan2(d[2], flat);
  }
  return placed;
}

}  // namespace airlight
