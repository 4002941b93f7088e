#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/free_space.hpp"

namespace stope::topology {

/// Cells in a row, from column `begin` to before `end`.
struct RowSpan {
  std::int32_t row = 0, begin = 0, end = 0;
  bool operator==(const RowSpan&) const = default;
};

/// A rectangle of cells.
struct CellWindow {
  std::int32_t column = 0, row = 0, width = 0, height = 0;
};

/// For every cell the rows to the nearest obstacle below and above it in its column, 0 in
/// obstacles: what the distance transform of a row is made of, kept so that it can be brought up to
/// date. 4 bytes a cell.
class ColumnReach {
 public:
  /// Whether a grid is low enough for 16 bits.
  static bool fits(const FreeSpace& space) { return space.height() < UINT16_MAX; }
  explicit ColumnReach(const FreeSpace& space, const Checkpoint& checkpoint = never_stop);

  /// Obstacles have changed within the window and nowhere else. Returns for each row with cells
  /// whose reach is another now one span that holds them all, from the lowest row up.
  std::vector<RowSpan> update(const FreeSpace& space, const CellWindow& changed);

  /// The row of the nearest obstacle in the cell's column, the lower one if two are equally near.
  std::int32_t nearest_row(CellIndex cell, std::int32_t row) const {
    const std::int32_t down = down_[cell], up = up_[cell];
    return down <= up ? row - down : row + up;
  }

 private:
  PaddedGrid<std::uint16_t> down_, up_;
};

}  // namespace stope::topology
