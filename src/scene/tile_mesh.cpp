#include "scene/tile_mesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace airlight {
namespace {

using Vertex = std::array<float, 3>;
constexpr int cells = TileTree::tile_cells;

class Builder {
 public:
  Builder(const Land& land, const TileTree& tree, const Position& centre) : land_(land), tree_(tree), centre_(centre) {
    // Chords of the mesh's outer border lie under the plain's sphere by this; lifted, they leave no slit.
    border_lift_ = tree.cell(0) * tree.cell(0) / (8 * land.frame().radius());
  }

  void build(const Tile& tile, Vertex* vertices, std::array<float, 3>* normals) const {
    // With one more vertex all around, whose heights the slopes at the edge need.
    const std::int32_t step = TileTree::span(tile.level);
    std::array<double, 2> places[side * side];
    double altitudes[side * side];
    for (int k = 0; k < side * side; ++k) {
      places[k] = {tree_.metres(tile.x + (k % side - 1) * step), tree_.metres(tile.y + (k / side - 1) * step)};
    }
    land_.altitudes(places, tree_.cell(tile.level), altitudes);
    Position own[side][side];
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const int k = j * side + i;
        own[j][i] = placed(tile.x + (i - 1) * step, tile.y + (j - 1) * step, altitudes[k]);
        vertices[k] = rounded(own[j][i]);
      }
    }
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        *normals++ = rounded(normal(own[j + 1][i], own[j + 1][i + 2], own[j][i + 1], own[j + 2][i + 1]));
      }
    }
    meet_neighbours(tile, vertices);
    add_flange(own, vertices);
  }

 private:
  static constexpr int side = cells + 3;

  Position placed(std::int32_t x, std::int32_t y, double altitude) const {
    if (tree_.on_border(x, y)) altitude += border_lift_;
    const Position p = land_.frame().position({tree_.metres(x), tree_.metres(y), altitude});
    return {p[0] - centre_[0], p[1] - centre_[1], p[2] - centre_[2]};
  }

  static Vertex rounded(const Position& p) { return {float(p[0]), float(p[1]), float(p[2])}; }

  static std::array<double, 3> normal(const Position& west, const Position& east, const Position& south,
                                      const Position& north) {
    const double ex = east[0] - west[0], ey = east[1] - west[1], ez = east[2] - west[2];
    const double nx = north[0] - south[0], ny = north[1] - south[1], nz = north[2] - south[2];
    const std::array<double, 3> n{ey * nz - ez * ny, ez * nx - ex * nz, ex * ny - ey * nx};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
  }

  /// Altitudes at lattice points of coarser tiles. Land is asked for many places at once, so each edge is walked twice: the first
  /// time only notes what it needs.
  struct Coarse {
    std::map<std::tuple<int, std::int32_t, std::int32_t>, double> altitudes;  // by level, x and y

    double altitude(int level, std::int32_t x, std::int32_t y) { return altitudes[{level, x, y}]; }
  };

  void find(Coarse& coarse) const {
    std::vector<std::array<double, 2>> places;
    std::vector<double> altitudes;
    for (auto begin = coarse.altitudes.begin(), end = begin; begin != coarse.altitudes.end(); begin = end) {
      const int level = std::get<0>(begin->first);
      places.clear();
      for (; end != coarse.altitudes.end() && std::get<0>(end->first) == level; ++end)
        places.push_back({tree_.metres(std::get<1>(end->first)), tree_.metres(std::get<2>(end->first))});
      altitudes.resize(places.size());
      land_.altitudes(places, tree_.cell(level), altitudes);
      std::size_t i = 0;
      for (auto place = begin; place != end; ++place) place->second = altitudes[i++];
    }
  }

  /// The vertex as the coarsest tile there has it. All tiles that touch it come to the same bits.
  Vertex shared(std::int32_t x, std::int32_t y, Coarse& coarse) const {
    const int level = tree_.coarsest_at(x, y);
    const std::int32_t step = TileTree::span(level), dx = x % step, dy = y % step;
    if (dx == 0 && dy == 0) return rounded(placed(x, y, coarse.altitude(level, x, y)));
    // On an edge of the coarse tile, between two of its vertices.
    const Vertex a = dx ? shared(x - dx, y, coarse) : shared(x, y - dy, coarse),
                 b = dx ? shared(x - dx + step, y, coarse) : shared(x, y - dy + step, coarse);
    const float t = float(dx ? dx : dy) / float(step);
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  }

  void meet_neighbours(const Tile& tile, Vertex* vertices) const {
    const std::int32_t step = TileTree::span(tile.level), width = cells * step;
    // A neighbour across an edge is either one coarser leaf or none coarser.
    const auto coarser = [&](std::int32_t x, std::int32_t y) { return tree_.level_at(x, y) < tile.level; };
    const bool west = coarser(tile.x - 1, tile.y), east = coarser(tile.x + width, tile.y);
    const bool south = coarser(tile.x, tile.y - 1), north = coarser(tile.x, tile.y + width);
    const bool south_west = west || south || coarser(tile.x - 1, tile.y - 1);
    const bool south_east = east || south || coarser(tile.x + width, tile.y - 1);
    const bool north_west = west || north || coarser(tile.x - 1, tile.y + width);
    const bool north_east = east || north || coarser(tile.x + width, tile.y + width);
    Coarse coarse;
    const auto put = [&](int i, int j) {
      vertices[(j + 1) * side + i + 1] = shared(tile.x + i * step, tile.y + j * step, coarse);
    };
    for (int walk = 0; walk < 2; ++walk) {
      if (walk == 1) find(coarse);
      for (int k = 1; k < cells; ++k) {
        if (west) put(0, k);
        if (east) put(cells, k);
        if (south) put(k, 0);
        if (north) put(k, cells);
      }
      if (south_west) put(0, 0);
      if (south_east) put(cells, 0);
      if (north_west) put(0, cells);
      if (north_east) put(cells, cells);
    }
  }

  /// From each vertex of the edge a hundredth of a cell outward and a fifth of one down.
  void add_flange(const Position (&own)[side][side], Vertex* vertices) const {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const int ei = std::clamp(i, 1, side - 2), ej = std::clamp(j, 1, side - 2);
        if (ei == i && ej == j) continue;
        const Position &out = own[j][i], &edge = own[ej][ei];
        const double dx = out[0] - edge[0], dy = out[1] - edge[1], dz = out[2] - edge[2];
        const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const Direction up = land_.frame().up({edge[0] + centre_[0], edge[1] + centre_[1], edge[2] + centre_[2]});
        const Vertex& from = vertices[ej * side + ei];
        const double d[3] = {dx, dy, dz};
        for (std::size_t k = 0; k < 3; ++k) {
          vertices[j * side + i][k] = float(double(from[k]) + 0.01 * d[k] - 0.2 * length * up[k]);
        }
      }
    }
  }

  const Land& land_;
  const TileTree& tree_;
  Position centre_;
  double border_lift_;
};

}  // namespace

TileMesh::TileMesh(const Land& land, const TileTree& tree, const Position& centre) {
  const auto& leaves = tree.leaves();
  constexpr std::size_t grid = grid_side * grid_side, plane = normal_side * normal_side;
  vertex_count_ = leaves.size() * grid;
  normal_count_ = leaves.size() * plane;
  vertices_ = std::make_unique_for_overwrite<std::array<float, 3>[]>(vertex_count_ + 1);
  normals_ = std::make_unique_for_overwrite<std::array<float, 3>[]>(normal_count_);
  vertices_[vertex_count_] = {};
  const Builder builder(land, tree, centre);
  tbb::parallel_for(std::size_t(0), leaves.size(),
                    [&](std::size_t i) { builder.build(leaves[i], &vertices_[i * grid], &normals_[i * plane]); });
}

std::array<float, 3> TileMesh::normal(std::size_t tile, double x, double y) const {
  x = std::clamp(x, 0.0, double(cells)), y = std::clamp(y, 0.0, double(cells));
  const int i = std::min(int(x), cells - 1), j = std::min(int(y), cells - 1);
  const float fx = float(x - i), fy = float(y - j);
  const std::array<float, 3>* n = &normals_[tile * normal_side * normal_side + std::size_t(j * normal_side + i)];
  std::array<float, 3> sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum[k] = (n[0][k] * (1 - fx) + n[1][k] * fx) * (1 - fy) +
             (n[normal_side][k] * (1 - fx) + n[normal_side + 1][k] * fx) * fy;
  const float scale = 1 / std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  return {sum[0] * scale, sum[1] * scale, sum[2] * scale};
}

}  // namespace airlight
