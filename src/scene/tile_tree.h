// Which squares of the land are drawn how finely for an eye: a quadtree whose leaves become tiles of the mesh.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/terrain.h"

namespace airlight {

/// A leaf: tile_cells x tile_cells cells.
struct Tile {
  int level;
  std::int32_t x, y;  ///< of its south-west corner, in units of the lattice
};

/// Corners of cells of all levels lie on one integer lattice, so that two tiles mean the same point by the same numbers.
class TileTree {
 public:
  static constexpr int tile_cells = 16;

  /// A coarser tree, and for each part of its leaves (`parts` x `parts` a leaf, from the south-west, east fastest) how much greater
  /// than a pixel cells may be there: 1 for ground seen face to face, more for what is foreshortened, 0 for what is hidden.
  struct Draft {
    static constexpr int parts = 4;
    const TileTree* tree;
    std::vector<float> stretch;

    /// Index of the part around the lattice square whose south-west corner is given; -1 outside of everything.
    int part_at(std::int32_t x, std::int32_t y) const;
  };
  /// @param draft  null: all may be seen, face to face
  TileTree(const Land& land, const LevelOfDetail& detail, const Draft* draft = nullptr);

  const std::vector<Tile>& leaves() const { return leaves_; }
  double half_side() const {
    return half_side_;
  }                                          ///< of the square that all leaves cover [m]; at least the land's extent
  double pixels() const { return pixels_; }  ///< side of a seen triangle that `most_cells` allowed [pixels]

  double cell(int level) const { return unit_ * span(level); }  ///< side of a cell [m]
  static std::int32_t span(int level) {
    return 1 << (finest_level - level);
  }  ///< side of a cell in units of the lattice
  double metres(std::int32_t lattice) const { return unit_ * lattice - half_side_; }
  std::int32_t lattice(double metres) const { return std::int32_t(std::floor((metres + half_side_) / unit_)); }
  bool on_border(std::int32_t x, std::int32_t y) const;

  /// Index of the leaf around the lattice square whose south-west corner is given; -1 outside of everything.
  int leaf_at(std::int32_t x, std::int32_t y) const;
  /// Its level; `finest_level` outside of everything.
  int level_at(std::int32_t x, std::int32_t y) const;
  /// Level of the coarsest leaf that touches a lattice point.
  int coarsest_at(std::int32_t x, std::int32_t y) const;

 private:
  static constexpr int finest_level = 20;
  struct Node {
    std::int32_t children = -1;  ///< index of the first of four; -1: a leaf
    std::int32_t leaf = -1;      ///< its index
  };
  void grow(const Land& land, const LevelOfDetail& detail, const Draft* draft);
  double stretch(const Draft& draft, const Tile& tile) const;

  int roots_ = 4;  ///< trees a side
  double half_side_ = 0, unit_ = 0, pixels_ = 1;
  std::vector<Node> nodes_;
  std::vector<Tile> leaves_;
};

}  // namespace airlight
