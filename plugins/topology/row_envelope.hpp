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
  /// An obstacle cell that is nearest to some real point of the row.
  struct Piece {
    std::int64_t level = 0;  ///< squared distance at column 0
    std::int64_t rise = 0;   ///< … above its predecessor's
    std::int32_t column = 0, site_row = 0;
    std::int32_t apart = 0;  ///< columns from its predecessor
  };

  /// For at most `columns` obstacle cells a row.
  explicit RowEnvelope(std::int32_t columns) : pieces_(static_cast<std::size_t>(columns) + 1) {}

  /// The first obstacle cell of a row, the westernmost.
  void start(std::int32_t row, std::int32_t column, std::int32_t site_row) {
    row_ = row;
    last_ = pieces_.data();
    // Nothing is before it: so it is never covered, and begins where the row does.
    *last_ = {level_of(column, site_row), -1, column, site_row, 0};
  }

  /// Adds an obstacle cell east of those added before.
  void add(std::int32_t column, std::int32_t site_row) {
    const std::int64_t level = level_of(column, site_row);
    Piece* last = last_;
    std::int64_t rise = level - last->level;
    std::int64_t apart = column - last->column;
    // Nowhere lower than both its predecessor and the parabola further east.
    while (last->rise * apart >= rise * last->apart) {
      --last;
      rise = level - last->level;
      apart = column - last->column;
    }
    *++last = {level, rise, column, site_row, static_cast<std::int32_t>(apart)};
    last_ = last;
  }

  /// The obstacle cells that are left, from west to east.
  const Piece* begin() const { return pieces_.data(); }
  const Piece* end() const { return last_ + 1; }

  /// Calls write(begin, end, column, site_row) for each obstacle cell that is nearest to the cells
  /// of columns from `begin` to before `end`, within `from` to before `to`, from east to west.
  template <class Write>
  void for_each_piece(std::int32_t from, std::int32_t to, Write write) const {
    std::int32_t end = to;
    for (const Piece* piece = last_; end > from; --piece) {
      const std::int32_t begin = std::clamp(begin_of(*piece), from, end);
      if (begin == end) continue;
      write(begin, end, piece->column, piece->site_row);
      end = begin;
    }
  }

 private:
  std::int64_t level_of(std::int32_t column, std::int32_t site_row) const {
    const std::int64_t rows = site_row - row_;
    return static_cast<std::int64_t>(column) * column + rows * rows;
  }

  /// The first column, 0 or more, where a piece is lower than its predecessor.
  static std::int32_t begin_of(const Piece& piece) {
    if (piece.rise < 0) return 0;
    const std::int64_t twice = 2 * static_cast<std::int64_t>(piece.apart);
    // Division of 32 bits is several times faster on many machines, and mostly enough.
    if (((piece.rise | twice) >> 32) == 0)
      return 1 + static_cast<std::int32_t>(static_cast<std::uint32_t>(piece.rise) /
                                           static_cast<std::uint32_t>(twice));
    return static_cast<std::int32_t>(std::min<std::int64_t>(piece.rise / twice, INT32_MAX - 1)) + 1;
  }

  std::vector<Piece> pieces_;
  Piece* last_ = nullptr;
  std::int32_t row_ = 0;
};

}  // namespace stope::topology
