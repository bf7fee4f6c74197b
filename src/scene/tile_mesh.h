// Vertices and normals of all tiles, without cracks between tiles of different finesse.
#pragma once
#include <array>
#include <memory>
#include <span>

#include "scene/tile_tree.h"

namespace airlight {

/// Each tile is a grid of grid_side x grid_side vertices: its cells, and one cell more all around that leans out and down
/// under the neighbours (a flange), so that no ray slips between two tiles whose edges differ by a rounding.
class TileMesh {
 public:
  static constexpr int grid_side = TileTree::tile_cells + 3, normal_side = TileTree::tile_cells + 1;

  /// @param centre  that vertices are relative to: floats are fine near it
  TileMesh(const Land& land, const TileTree& tree, const Position& centre);

  /// Grids one after the other, x fastest; and one more, as Embree reads 16 bytes of the last.
  std::span<const std::array<float, 3>> vertices() const { return {vertices_.get(), vertex_count_ + 1}; }

  /// Smooth normal in a tile, at coordinates in cells.
  std::array<float, 3> normal(std::size_t tile, double x, double y) const;

  std::size_t bytes() const { return (vertex_count_ + normal_count_) * sizeof vertices_[0]; }

 private:
  // Not vectors: they would touch it all before it is built.
  std::size_t vertex_count_, normal_count_;
  std::unique_ptr<std::array<float, 3>[]> vertices_, normals_;
};

}  // namespace airlight
