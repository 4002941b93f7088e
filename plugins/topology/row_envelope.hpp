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

  /// Memory for the envelope of a row of at most `columns` obstacle cells.
  static std::vector<Piece> memory_for(std::int32_t columns) {
    return std::vector<Piece>(static_cast<std::size_t>(columns) + 1);
  }

  /// Of a row, in memory that outlives it, with the first obstacle cell, the westernmost.
  RowEnvelope(std::vector<Piece>& memory, std::int32_t row, std::int32_t column,
              std::int32_t site_row)
      : first_(memory.data()), end_(first_), row_(row) {
    // Nothing is before it: so it is never covered, and begins where the row does.
    last_ = {level_of(column, site_row), -1, column, site_row, 0};
  }

  /// Adds an obstacle cell east of those added before.
  void add(std::int32_t column, std::int32_t site_row) {
    const std::int64_t level = level_of(column, site_row);
    std::int64_t rise = level - last_.level;
    std::int64_t apart = column - last_.column;
    // Nowhere lower than both its predecessor and the parabola further east.
    while (last_.rise * apart >= rise * last_.apart) {
      last_ = *--end_;
      rise = level - last_.level;
      apart = column - last_.column;
    }
    *end_++ = last_;
    last_ = {level, rise, column, site_row, static_cast<std::int32_t>(apart)};
  }

  /// The obstacle cells that are left, from west to east, when all have been added.
  const Piece* begin() const { return first_; }
  const Piece* end() {
    *end_ = last_;
    return end_ + 1;
  }
  /// Calls write(begin, end, column, site_row) for each obstacle cell that is nearest to the cells
  /// of columns from `begin` to before `end`, within `from` to before `to`, from east to west.
  template <class Write>
  void for_each_piece(std::int32_t from, std::int32_t to, Write write) {
    std::int32_t end = to;
    for (const Piece* piece = this->end() - 1; end > from; --piece) {
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

  Piece* first_;
  Piece* end_;  ///< of the pieces before the last one, which is kept in registers
  Piece last_;
  std::int32_t row_;
};

}  // namespace stope::topology
