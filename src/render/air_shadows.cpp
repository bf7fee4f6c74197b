#include "render/air_shadows.h"

#include <algorithm>

namespace airlight {

AirShadows air_shadows(const ShadowMap& map, const PlacedCamera& camera, int steps) {
  AirShadows shadows;
  shadows.width = shadows.height = map.cells;
  shadows.steps = steps;
  shadows.highest = *std::ranges::max_element(map.lit);
  std::vector<float> edges;
  edges.reserve(2 * map.lit.size());
  for (std::size_t i = 0; i < map.lit.size(); ++i) edges.insert(edges.end(), {map.dark[i], map.lit[i]});
  shadows.edges = std::make_shared<const std::vector<float>>(std::move(edges));
  const double size = map.spacing * map.cells;
  const std::array<double, 2> origin = map.texel(camera.eye);
  for (std::size_t i = 0; i < 3; ++i) {
    const Direction axis = camera.to_scene({double(i == 0), double(i == 1), double(i == 2)});
    shadows.across[i] = (axis[0] * map.along[0] + axis[1] * map.along[1]) / size;
    shadows.along[i] = (axis[0] * map.across[0] + axis[1] * map.across[1]) / size;
  }
  shadows.across[3] = (origin[0] + 0.5) / map.cells;
  shadows.along[3] = (origin[1] + 0.5) / map.cells;
  return shadows;
}

}  // namespace airlight
