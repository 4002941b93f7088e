// Problem: along one row of cells, which of some obstacle cells, at most one a column, is nearest.
// Idea (Felzenszwalb and Huttenlocher 2012; Meijster, Roerdink and Hesselink 2000): the squared
// distance to an obstacle cell is a parabola over the row, and the nearest ones are the lower
// envelope of these. Obstacle cells are added from west to east; each takes off those before it
// that it and their predecessor are never above. That question needs products only: where pieces
// begin is divided out once, for the pieces that are left.
// Cost: amortised a few products an obstacle cell, one division a piece.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stope::topology {

/// The lower envelope of the distances to obstacle cells along a row. The nearest obstacle cell of
/// a place on the row is the one of the least column among those equally near, and so a function of
/// the obstacle cells alone: parts of a row can be computed apart.
class RowEnvelope {
 public:
  /// For at most `columns` obstacle cells a row.
  explicit RowEnvelope(std::int32_t columns)
      : column_(static_cast<std::size_t>(columns)),
        site_row_(static_cast<std::size_t>(columns)),
        level_(static_cast<std::size_t>(columns)) {}

  void start(std::int32_t row) {
    row_ = row;
    count_ = 0;
  }

  /// Adds an obstacle cell east of those added before.
  void add(std::int32_t column, std::int32_t site_row) {
    const std::int64_t rows = site_row - row_;
    const std::int64_t level = static_cast<std::int64_t>(column) * column + rows * rows;
    std::size_t count = count_;
    while (count > 1 && is_covered(count - 1, column, level)) --count;
    column_[count] = column;
    site_row_[count] = site_row;
    level_[count] = level;
    count_ = count + 1;
  }

  /// Of the obstacle cells that are nearest to some real point of the row, from west to east.
  std::size_t count() const { return count_; }
  std::int32_t column(std::size_t piece) const { return column_[piece]; }
  std::int32_t site_row(std::size_t piece) const { return site_row_[piece]; }

  /// Calls write(begin, end, column, site_row) for each obstacle cell that is nearest to the cells
  /// of columns from `begin` to before `end`, within `from` to before `to`, from east to west.
  template <class Write>
  void for_each_piece(std::int32_t from, std::int32_t to, Write write) const {
    std::int32_t end = to;
    for (std::size_t piece = count_; piece-- > 0 && end > from;) {
      const std::int32_t begin = piece == 0 ? from : std::clamp(begin_of(piece), from, end);
      if (begin == end) continue;
      write(begin, end, column_[piece], site_row_[piece]);
      end = begin;
    }
  }

 private:
  /// Whether a piece is nowhere lower than its predecessor and a parabola further east.
  bool is_covered(std::size_t piece, std::int32_t column, std::int64_t level) const {
    const std::int64_t before = column_[piece] - column_[piece - 1],
                       after = column - column_[piece];
    return (level_[piece] - level_[piece - 1]) * after >= (level - level_[piece]) * before;
  }

  /// The first column, 0 or more, where a piece is lower than its predecessor.
  std::int32_t begin_of(std::size_t piece) const {
    const std::int64_t rise = level_[piece] - level_[piece - 1];
    if (rise < 0) return 0;
    const std::int64_t twice = 2 * (static_cast<std::int64_t>(column_[piece]) - column_[piece - 1]);
    // Division of 32 bits is several times faster on many machines, and mostly enough.
    if (((rise | twice) >> 32) == 0)
      return 1 + static_cast<std::int32_t>(static_cast<std::uint32_t>(rise) /
                                           static_cast<std::uint32_t>(twice));
    return static_cast<std::int32_t>(std::min<std::int64_t>(rise / twice, INT32_MAX - 1)) + 1;
  }

  std::vector<std::int32_t> column_, site_row_;
  std::vector<std::int64_t> level_;  ///< squared distance at column 0
  std::size_t count_ = 0;
  std::int32_t row_ = 0;
};

}  // namespace stope::topology
