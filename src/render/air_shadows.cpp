#include "render/air_shadows.h"

#include <algorithm>

namespace airlight {

namespace {

/// The smallest rectangle [first, end) of a map's cells that holds all that is looked at; at least 2 x 2, so that there is something to
/// interpolate.
struct Rectangle {
  int first_x, end_x, first_y, end_y;

  explicit Rectangle(const ShadowMap& map) : first_x(map.cells - 2), end_x(2), first_y(map.cells - 2), end_y(2) {
    for (int y = 0; y < map.cells; ++y) {
      const float* row = &map.lit[std::size_t(y) * std::size_t(map.cells)];
      const auto holds = [](float lit) { return lit != ShadowMap::not_looked_at; };
      const float* first = std::find_if(row, row + map.cells, holds);
      if (first == row + map.cells) continue;
      int end = map.cells;
      while (!holds(row[end - 1])) --end;
      first_x = std::min(first_x, int(first - row)), end_x = std::max(end_x, end);
      first_y = std::min(first_y, y), end_y = std::max(end_y, y + 1);
    }
  }
  int width() const { return end_x - first_x; }
  int height() const { return end_y - first_y; }
};

}  // namespace

AirShadows air_shadows(const ShadowMap& map, const PlacedCamera& camera, int steps) {
  const Rectangle part(map);
  AirShadows shadows;
  shadows.width = part.width();
  shadows.height = part.height();
  shadows.steps = steps;
  shadows.highest = *std::ranges::max_element(map.lit);
  std::vector<float> edges;
  edges.reserve(2 * std::size_t(shadows.width) * std::size_t(shadows.height));
  for (int y = part.first_y; y < part.end_y; ++y) {
    for (int x = part.first_x; x < part.end_x; ++x) {
      const std::size_t k = std::size_t(y) * std::size_t(map.cells) + std::size_t(x);
      edges.insert(edges.end(), {map.dark[k], map.lit[k]});
    }
  }
  shadows.edges = std::make_shared<const std::vector<float>>(std::move(edges));
  const std::array<double, 2> origin = map.texel(camera.eye);
  for (std::size_t i = 0; i < 3; ++i) {
    const Direction axis = camera.to_scene({double(i == 0), double(i == 1), double(i == 2)});
    shadows.across[i] = (axis[0] * map.along[0] + axis[1] * map.along[1]) / (map.spacing * part.width());
    shadows.along[i] = (axis[0] * map.across[0] + axis[1] * map.across[1]) / (map.spacing * part.height());
  }
  shadows.across[3] = (origin[0] - part.first_x + 0.5) / part.width();
  shadows.along[3] = (origin[1] - part.first_y + 0.5) / part.height();
  return shadows;
}

}  // namespace airlight
