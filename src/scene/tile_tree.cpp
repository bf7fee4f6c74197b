#include "scene/tile_tree.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

/// The side of a cell that a square of the land deserves [m].
class Wanted {
 public:
  Wanted(const Land& land, const LevelOfDetail& detail) : land_(land), detail_(detail) {}

  /// @param stretch  see TileTree::Draft
  double cell(double east, double north, double half_width, double pixels, double stretch) const {
    const LocalFrame& frame = land_.frame();
    const Position middle = frame.position({east, north, land_.altitude(east, north, 2 * half_width)});
    const Position d{middle[0] - detail_.eye[0], middle[1] - detail_.eye[1], middle[2] - detail_.eye[2]};
    const double reach = std::sqrt(2.0) * half_width;
    const double far = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double near = std::max(far - reach, 0.5);
    // What only throws shadows is as fine as its middle asks for: its nearest corner would make a large square many small ones.
    const double pixel = detail_.pixel_angle * (stretch > 0 && seen(d, far, 1.2 * reach)
                                                    ? near * pixels * stretch
                                                    : std::max(near, 0.7 * far) * (pixels + detail_.unseen_pixels));
    const double finest = land_.finest_cell(east, north, half_width);
    if (std::isfinite(finest)) {
      // The curve between a file's values is drawn too where it would show as facets, down to an eighth of its cells.
      const double facet = facet_pixels * near * detail_.pixel_angle;
      return std::max(pixel, std::clamp(facet, finest / 8, finest));
    }
    // On the plain only the planet's curve shows: the chord across a cell stays within a quarter of a pixel, or a thousand
    // millionth of the radius, of its arc.
    const double radius = land_.frame().radius();
    return std::max(pixel, std::sqrt(4 * radius * std::max(0.25 * near * detail_.pixel_angle, 1e-9 * radius)));
  }

 private:
  bool seen(const Position& d, double far, double reach) const {
    if (far <= reach) return true;
    const double along = (d[0] * detail_.axis[0] + d[1] * detail_.axis[1] + d[2] * detail_.axis[2]) / far;
    return std::acos(std::clamp(along, -1.0, 1.0)) - std::asin(reach / far) <= detail_.half_angle;
  }
  static constexpr double facet_pixels = 16;
  const Land& land_;
  const LevelOfDetail& detail_;
};

}  // namespace

TileTree::TileTree(const Land& land, const LevelOfDetail& detail, const Draft* draft) : pixels_(detail.pixels) {
  // Cells of some level are as wide as the finest file's pixels.
  const double finest = land.finest_cell(0, 0, land.extent());
  double root_cell = land.extent() / (2 * tile_cells);
  if (std::isfinite(finest)) root_cell = finest * std::exp2(std::max(0.0, std::floor(std::log2(root_cell / finest))));
  roots_ = 2 * int(std::ceil(land.extent() / (tile_cells * root_cell)));
  half_side_ = 0.5 * roots_ * tile_cells * root_cell;
  unit_ = root_cell / span(0);
  for (;; pixels_ *= 1.3) {
    grow(land, detail, draft);
    if (!leaves_.empty()) break;
  }
}

void TileTree::grow(const Land& land, const LevelOfDetail& detail, const Draft* draft) {
  const Wanted wanted(land, detail);
  const std::size_t most_leaves = std::max<std::size_t>(detail.most_cells / (tile_cells * tile_cells), 1);
  nodes_.assign(std::size_t(roots_) * std::size_t(roots_), {});
  leaves_.clear();
  struct Open {
    std::int32_t node;
    Tile tile;
  };
  std::vector<Open> open;
  for (int j = 0; j < roots_; ++j) {
    for (int i = 0; i < roots_; ++i) {
      open.push_back({j * roots_ + i, {0, i * tile_cells * span(0), j * tile_cells * span(0)}});
    }
  }
  const std::size_t fewest = open.size();
  while (!open.empty()) {
    const auto [node, tile] = open.back();
    open.pop_back();
    const std::int32_t half = tile_cells * span(tile.level) / 2;
    const double stretched = draft ? stretch(*draft, tile) : 1;
    const double cell_wanted =
        wanted.cell(metres(tile.x + half), metres(tile.y + half), unit_ * half, pixels_, stretched);
    if (tile.level < finest_level - 1 && cell(tile.level) > cell_wanted * 1.001) {
      const auto first = std::int32_t(nodes_.size());
      nodes_[std::size_t(node)].children = first;
      nodes_.resize(nodes_.size() + 4);
      for (int k = 0; k < 4; ++k)
        open.push_back({first + k, {tile.level + 1, tile.x + (k & 1) * half, tile.y + (k >> 1) * half}});
      if (leaves_.size() + open.size() > std::max(most_leaves, fewest)) {
        leaves_.clear();  // too many: the caller asks for less
        return;
      }
    } else {
      nodes_[std::size_t(node)].leaf = std::int32_t(leaves_.size());
      leaves_.push_back(tile);
    }
  }
}

bool TileTree::on_border(std::int32_t x, std::int32_t y) const {
  const std::int32_t end = roots_ * tile_cells * span(0);
  return x == 0 || y == 0 || x == end || y == end;
}

int TileTree::leaf_at(std::int32_t x, std::int32_t y) const {
  const std::int32_t side = tile_cells * span(0), end = roots_ * side;
  if (x < 0 || y < 0 || x >= end || y >= end) return -1;
  std::int32_t node = (y / side) * roots_ + x / side;
  for (std::int32_t half = side / 2; nodes_[std::size_t(node)].children >= 0; half /= 2) {
    node = nodes_[std::size_t(node)].children + (x & half ? 1 : 0) + (y & half ? 2 : 0);
  }
  return nodes_[std::size_t(node)].leaf;
}

int TileTree::level_at(std::int32_t x, std::int32_t y) const {
  const int leaf = leaf_at(x, y);
  return leaf < 0 ? finest_level : leaves_[std::size_t(leaf)].level;
}

int TileTree::Draft::part_at(std::int32_t x, std::int32_t y) const {
  const int leaf = tree->leaf_at(x, y);
  if (leaf < 0) return -1;
  const Tile& tile = tree->leaves_[std::size_t(leaf)];
  const std::int32_t width = tile_cells * span(tile.level) / parts;
  return (leaf * parts + (y - tile.y) / width) * parts + (x - tile.x) / width;
}

double TileTree::stretch(const Draft& draft, const Tile& tile) const {
  const std::int32_t width = tile_cells * span(tile.level), half = width / 2;
  const int leaf = draft.tree->leaf_at(tile.x + half, tile.y + half);
  const Tile& coarse = draft.tree->leaves_[std::size_t(leaf)];
  // A tile that is greater than the draft's has parts of which some may be seen: it is the smaller ones' turn.
  if (coarse.level > tile.level) return 1;
  // Of all parts that it lies over, the one that is seen best.
  const std::int32_t part = tile_cells * span(coarse.level) / Draft::parts;
  float best = 0;
  for (std::int32_t y = tile.y; y < tile.y + width; y += part) {
    for (std::int32_t x = tile.x; x < tile.x + width; x += part) {
      const float stretch = draft.stretch[std::size_t(draft.part_at(x, y))];
      if (stretch > 0) best = best > 0 ? std::min(best, stretch) : stretch;
    }
  }
  return double(best);
}

int TileTree::coarsest_at(std::int32_t x, std::int32_t y) const {
  return std::min({level_at(x, y), level_at(x - 1, y), level_at(x, y - 1), level_at(x - 1, y - 1)});
}

}  // namespace airlight
