#include "scene/raster_pyramid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "airlight/error.h"
#include "scene/catmull_rom.h"

namespace airlight {
namespace {

constexpr int apron = 2;         // a Catmull-Rom stencil of any place in a block stays in the block
constexpr int block_side = 256;  // of levels finer than what is held as a whole
constexpr int largest_held = 2048;

/// Values of part of a level, with an apron all around.
struct Block {
  int width = 0, height = 0;
  std::vector<float> values;
  std::size_t stride() const { return std::size_t(width + 2 * apron); }
  float& at(int x, int y) { return values[std::size_t(y + apron) * stride() + std::size_t(x + apron)]; }
  float at(int x, int y) const { return values[std::size_t(y + apron) * stride() + std::size_t(x + apron)]; }
};

Block make_block(int width, int height) {
  Block block{width, height, {}};
  block.values.resize(block.stride() * std::size_t(height + 2 * apron));
  return block;
}

/// Fills the apron with the nearest values.
void extend(Block& block) {
  for (int y = -apron; y < block.height + apron; ++y) {
    for (int x = -apron; x < block.width + apron; ++x) {
      block.at(x, y) = block.at(std::clamp(x, 0, block.width - 1), std::clamp(y, 0, block.height - 1));
    }
  }
}

/// Mean of the (up to four) values that are there; NaN: none.
Block halved(const Block& fine) {
  Block coarse = make_block(std::max(1, fine.width / 2), std::max(1, fine.height / 2));
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      float sum = 0;
      int count = 0;
      for (int k = 0; k < 4; ++k) {
        const float value = fine.at(std::min(2 * x + k % 2, fine.width - 1), std::min(2 * y + k / 2, fine.height - 1));
        if (!std::isnan(value)) sum += value, ++count;
      }
      coarse.at(x, y) = count > 0 ? sum / static_cast<float>(count) : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return coarse;
}

double bilinear(const Block& block, double x, double y) {
  x = std::clamp(x - 0.5, 0.0, block.width - 1.0);
  y = std::clamp(y - 0.5, 0.0, block.height - 1.0);
  const int i = int(x), j = int(y);
  const double fx = x - i, fy = y - j;
  const double top = block.at(i, j) * (1 - fx) + block.at(i + 1, j) * fx;
  const double bottom = block.at(i, j + 1) * (1 - fx) + block.at(i + 1, j + 1) * fx;
  return top * (1 - fy) + bottom * fy;
}

/// Chamfer distances [pixels] of the places marked 0 to the nearest one marked 1.
void chamfer(std::vector<float>& distance, int width, int height) {
  const auto at = [&](int x, int y) -> float& {
    return distance[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  };
  const auto pass = [&](int x, int y, int step) {
    float& d = at(x, y);
    const float diagonal = std::sqrt(2.0f);
    const int before = y - step;
    if (x - step >= 0 && x - step < width) d = std::min(d, at(x - step, y) + 1);
    if (before < 0 || before >= height) return;
    d = std::min(d, at(x, before) + 1);
    if (x > 0) d = std::min(d, at(x - 1, before) + diagonal);
    if (x + 1 < width) d = std::min(d, at(x + 1, before) + diagonal);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pass(x, y, 1);
  for (int y = height - 1; y >= 0; --y)
    for (int x = width - 1; x >= 0; --x) pass(x, y, -1);
}

}  // namespace

struct RasterPyramid::Impl {
  struct Level {
    int width, height, side;  ///< in values; side of its blocks
    int across, down;         ///< blocks
    std::unique_ptr<std::atomic<const Block*>[]> blocks;
    ~Level() {
      for (int i = 0; blocks && i < across * down; ++i) delete blocks[std::size_t(i)].load();
    }
    Level(int w, int h, int s) : width(w), height(h), side(s), across((w + s - 1) / s), down((h + s - 1) / s) {
      blocks = std::make_unique<std::atomic<const Block*>[]>(std::size_t(across) * std::size_t(down));
    }
    Level(Level&&) = default;
  };

  std::shared_ptr<const RasterFile> file;
  int band;
  float lowest, highest;
  std::vector<Level> levels;
  int held = 0;                ///< the finest level held as a whole
  std::vector<float> outline;  ///< signed distance at level `held` [its pixels]; empty: the outline is the border
  double border_mean = 0, peak = 0;
  mutable std::mutex reading;

  const Block& whole(int level) const { return *levels[std::size_t(level)].blocks[0].load(); }

  /// Averages pixels of the file into a block, its apron included; NaN: missing.
  Block read(int level, int x0, int y0, int width, int height) const {
    const Level& l = levels[std::size_t(level)];
    Block block = make_block(width, height);
    const int left = std::max(0, x0 - apron), right = std::min(l.width, x0 + width + apron);
    const int top = std::max(0, y0 - apron), bottom = std::min(l.height, y0 + height + apron);
    std::vector<float> window(std::size_t(right - left) * std::size_t(bottom - top));
    // A side of less than 2^level pixels is one value all the same.
    const int columns = std::min((right - left) << level, file->width());
    const int rows = std::min((bottom - top) << level, file->height());
    file->read(band, left << level, top << level, columns, rows, right - left, bottom - top, window.data());
    for (int y = -apron; y < height + apron; ++y) {
      for (int x = -apron; x < width + apron; ++x) {
        const int wx = std::clamp(x0 + x, left, right - 1) - left, wy = std::clamp(y0 + y, top, bottom - 1) - top;
        const float value = window[std::size_t(wy) * std::size_t(right - left) + std::size_t(wx)];
        block.at(x, y) = value >= lowest && value <= highest ? value : std::numeric_limits<float>::quiet_NaN();
      }
    }
    return block;
  }

  const Block& block(int level, int bx, int by) const {
    const Level& l = levels[std::size_t(level)];
    std::atomic<const Block*>& place = l.blocks[std::size_t(by) * std::size_t(l.across) + std::size_t(bx)];
    if (const Block* found = place.load(std::memory_order_acquire)) return *found;
    const std::lock_guard lock(reading);
    if (const Block* found = place.load(std::memory_order_acquire)) return *found;
    const int x0 = bx * l.side, y0 = by * l.side;
    auto fresh =
        std::make_unique<Block>(read(level, x0, y0, std::min(l.side, l.width - x0), std::min(l.side, l.height - y0)));
    const double scale = 1.0 / (1 << (held - level));
    for (int y = -apron; y < fresh->height + apron; ++y) {
      for (int x = -apron; x < fresh->width + apron; ++x) {
        float& value = fresh->at(x, y);
        if (std::isnan(value)) {
          value = static_cast<float>(bilinear(whole(held), (x0 + x + 0.5) * scale, (y0 + y + 0.5) * scale));
        }
      }
    }
    place.store(fresh.get(), std::memory_order_release);
    return *fresh.release();
  }

  void put_whole(int level, Block block) {
    extend(block);
    levels[std::size_t(level)].blocks[0].store(new Block(std::move(block)));
  }

  /// Missing values from coarser levels, which have fewer of them; the coarsest, of one value, has none.
  void fill_and_halve(Block base) {
    std::vector<Block> blocks;
    blocks.push_back(std::move(base));
    while (blocks.back().width > 1 || blocks.back().height > 1) blocks.push_back(halved(blocks.back()));
    for (std::size_t k = blocks.size() - 1; k-- > 0;) {
      extend(blocks[k + 1]);
      for (int y = 0; y < blocks[k].height; ++y) {
        for (int x = 0; x < blocks[k].width; ++x) {
          float& value = blocks[k].at(x, y);
          if (std::isnan(value)) value = static_cast<float>(bilinear(blocks[k + 1], (x + 0.5) / 2, (y + 0.5) / 2));
        }
      }
    }
    for (std::size_t k = 0; k < blocks.size(); ++k) put_whole(held + int(k), std::move(blocks[k]));
  }

  /// Marks what is missing and reaches the border, and measures distances to it.
  void find_outline(const Block& base) {
    const int w = base.width, h = base.height;
    const auto index = [&](int x, int y) { return std::size_t(y) * std::size_t(w) + std::size_t(x); };
    std::vector<char> outside(std::size_t(w) * std::size_t(h), 0);
    std::vector<std::pair<int, int>> open;
    const auto visit = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= w || y >= h || outside[index(x, y)] || !std::isnan(base.at(x, y))) return;
      outside[index(x, y)] = 1;
      open.push_back({x, y});
    };
    for (int x = 0; x < w; ++x) visit(x, 0), visit(x, h - 1);
    for (int y = 0; y < h; ++y) visit(0, y), visit(w - 1, y);
    const bool irregular = !open.empty();
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
    }
    const auto is_outside = [&](int x, int y) { return x < 0 || y < 0 || x >= w || y >= h || outside[index(x, y)]; };
    double sum = 0;
    int count = 0;
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        if (is_outside(x, y) || std::isnan(base.at(x, y))) continue;
        if (!(is_outside(x - 1, y) || is_outside(x + 1, y) || is_outside(x, y - 1) || is_outside(x, y + 1))) continue;
        sum += base.at(x, y), ++count;
      }
    }
    border_mean = count > 0 ? sum / count : 0;
    if (!irregular) return;
    constexpr float far = 1e9f;
    std::vector<float> to_outside(outside.size()), to_inside(outside.size());
    for (std::size_t i = 0; i < outside.size(); ++i) {
      to_outside[i] = outside[i] ? 0 : far;
      to_inside[i] = outside[i] ? far : 0;
    }
    chamfer(to_outside, w, h);
    chamfer(to_inside, w, h);
    outline.resize(outside.size());
    // The outline runs half a pixel from the centres on both its sides.
    for (std::size_t i = 0; i < outside.size(); ++i) {
      outline[i] = outside[i] ? 0.5f - to_inside[i] : to_outside[i] - 0.5f;
    }
  }
};

RasterPyramid::RasterPyramid(std::shared_ptr<const RasterFile> file, int band, float lowest, float highest)
    : impl_(std::make_unique<Impl>()) {
  Impl& m = *impl_;
  m.file = std::move(file);
  m.band = band;
  m.lowest = lowest;
  m.highest = highest;
  const int width = m.file->width(), height = m.file->height();
  while ((std::max(width, height) >> m.held) > largest_held) ++m.held;
  for (int level = 0, w = width, h = height;; ++level) {
    m.levels.emplace_back(w, h, level < m.held ? block_side : std::max(w, h));
    if (level >= m.held && w == 1 && h == 1) break;
    w = std::max(1, w / 2), h = std::max(1, h / 2);
  }
  const auto& held = m.levels[std::size_t(m.held)];
  Block base = m.read(m.held, 0, 0, held.width, held.height);
  m.peak = -std::numeric_limits<double>::infinity();
  for (int y = 0; y < base.height; ++y) {
    for (int x = 0; x < base.width; ++x) {
      if (!std::isnan(base.at(x, y))) m.peak = std::max(m.peak, double(base.at(x, y)));
    }
  }
  if (!std::isfinite(m.peak)) throw InputError(m.file->path() + ": every value is missing");
  m.find_outline(base);
  m.fill_and_halve(std::move(base));
}
RasterPyramid::~RasterPyramid() = default;
RasterPyramid::RasterPyramid(RasterPyramid&&) noexcept = default;
RasterPyramid& RasterPyramid::operator=(RasterPyramid&&) noexcept = default;

double RasterPyramid::at(double column, double row, double cell) const {
  const Impl& m = *impl_;
  // Halfway between two levels the finer one is taken a little longer: sharp ridges before perfect smoothness.
  const int level = cell > 1 ? std::min(int(std::log2(cell) + 0.3), int(m.levels.size()) - 1) : 0;
  const auto& l = m.levels[std::size_t(level)];
  const double scale = 1.0 / (1 << level);
  const double x = std::clamp(column * scale - 0.5, 0.0, l.width - 1.0);
  const double y = std::clamp(row * scale - 0.5, 0.0, l.height - 1.0);
  const int i = int(x), j = int(y);
  const int bx = i / l.side, by = j / l.side;
  const Block& block = m.block(level, bx, by);
  const auto wx = catmull_rom(x - i), wy = catmull_rom(y - j);
  const float* values = &block.values[std::size_t(j - by * l.side + apron - 1) * block.stride() +
                                      std::size_t(i - bx * l.side + apron - 1)];
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k, values += block.stride()) {
    sum += wy[k] * (wx[0] * values[0] + wx[1] * values[1] + wx[2] * values[2] + wx[3] * values[3]);
  }
  return sum;
}

double RasterPyramid::inside(double column, double row) const {
  const Impl& m = *impl_;
  const double width = m.file->width(), height = m.file->height();
  const double dx = std::min(column, width - column), dy = std::min(row, height - row);
  const double border = dx < 0 && dy < 0 ? -std::sqrt(dx * dx + dy * dy) : std::min(dx, dy);
  if (m.outline.empty()) return border;
  const auto& held = m.levels[std::size_t(m.held)];
  const double scale = 1.0 / (1 << m.held);
  const double x = std::clamp(column * scale - 0.5, 0.0, held.width - 1.0);
  const double y = std::clamp(row * scale - 0.5, 0.0, held.height - 1.0);
  const int i = int(x), j = int(y);
  const std::size_t right = i + 1 < held.width ? 1 : 0, below = j + 1 < held.height ? std::size_t(held.width) : 0;
  const float* d = &m.outline[std::size_t(j) * std::size_t(held.width) + std::size_t(i)];
  const double fx = x - i, fy = y - j;
  const double top = d[0] * (1 - fx) + d[right] * fx, bottom = d[below] * (1 - fx) + d[below + right] * fx;
  return std::min(border, (top * (1 - fy) + bottom * fy) / scale);
}

double RasterPyramid::border_mean() const { return impl_->border_mean; }
double RasterPyramid::highest() const { return impl_->peak; }

}  // namespace airlight
