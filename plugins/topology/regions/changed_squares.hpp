#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// The squares of a tile that have cells of some kind, as bits, row after row from the lowest.
using TileSquares = std::uint16_t;

/// Which parts of a grid differ, in squares of a few cells, sixteen to a tile: quick to ask, never
/// too few.
class ChangedSquares {
 public:
  static constexpr std::int32_t kSide = 8;
  static constexpr std::int32_t kAcross = TileSet::kSide / kSide;  ///< squares across a tile
  static_assert(kAcross * kSide == TileSet::kSide && kAcross * kAcross == 16);

  ChangedSquares(std::int32_t width, std::int32_t height)
      : stride_(width + 2),
        rows_(height + 2),
        across_((stride_ + TileSet::kSide - 1) / TileSet::kSide),
        squares_(TileSet(width, height).size(), 0) {}

  /// A cell, of the margin at most.
  void add(std::int32_t column, std::int32_t row) {
    const std::int32_t x = (column + 1) / kSide, y = (row + 1) / kSide;
    add_squares(y / kAcross * across_ + x / kAcross,
                static_cast<TileSquares>(1U << (y % kAcross * kAcross + x % kAcross)));
  }
  /// A cell and all within `reach` of it, as a square, as far as they exist.
  void add(std::int32_t column, std::int32_t row, std::int32_t reach) {
    add_box(column - reach, row - reach, column + reach, row + reach);
  }
  bool touch(std::int32_t column, std::int32_t row, std::int32_t reach) const {
    return visit(column - reach, row - reach, column + reach, row + reach,
                 [&](std::int32_t tile, TileSquares squares) {
                   return (squares_[static_cast<std::size_t>(tile)] & squares) != 0;
                 });
  }
  bool any() const { return !list_.empty(); }
  TileSquares of(std::int32_t tile) const { return squares_[static_cast<std::size_t>(tile)]; }
  /// Tiles that have any, in the order they were named.
  const std::vector<std::int32_t>& tiles() const { return list_; }

  /// Calls visit(left, bottom) with the first column and row of each, which may be the margin's -1.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const std::int32_t tile : list_)
      for (std::int32_t k = 0; k < kAcross * kAcross; ++k)
        if (of(tile) >> k & 1)
          visit(tile % across_ * TileSet::kSide + k % kAcross * kSide - 1,
                tile / across_ * TileSet::kSide + k / kAcross * kSide - 1);
  }

  /// These and all squares with cells within `reach` of them.
  ChangedSquares widened(std::int32_t reach) const {
    ChangedSquares wide = *this;
    for_each([&](std::int32_t left, std::int32_t bottom) {
      wide.add_box(left - reach, bottom - reach, left + kSide - 1 + reach,
                   bottom + kSide - 1 + reach);
    });
    return wide;
  }

 private:
  void add_box(std::int32_t left, std::int32_t bottom, std::int32_t right, std::int32_t top) {
    visit(left, bottom, right, top, [&](std::int32_t tile, TileSquares squares) {
      add_squares(tile, squares);
      return false;
    });
  }
  void add_squares(std::int32_t tile, TileSquares squares) {
    TileSquares& own = squares_[static_cast<std::size_t>(tile)];
    if (own == 0) list_.push_back(tile);
    own |= squares;
  }

  /// Calls on_tile(tile, squares) for the tiles of a box until one gives true.
  template <class OnTile>
  bool visit(std::int32_t left, std::int32_t bottom, std::int32_t right, std::int32_t top,
             OnTile on_tile) const {
    left = std::max(left + 1, 0) / kSide, right = std::min(right + 1, stride_ - 1) / kSide;
    bottom = std::max(bottom + 1, 0) / kSide, top = std::min(top + 1, rows_ - 1) / kSide;
    for (std::int32_t y = bottom / kAcross; y <= top / kAcross; ++y) {
      const unsigned rows = bits(bottom - y * kAcross, top - y * kAcross, kAcross);
      for (std::int32_t x = left / kAcross; x <= right / kAcross; ++x) {
        const unsigned one_row = bits(left - x * kAcross, right - x * kAcross, 1);
        if (on_tile(y * across_ + x, static_cast<TileSquares>(one_row * 0x1111U & rows)))
          return true;
      }
    }
    return false;
  }
  /// Groups of `width` bits from `first` to `last`, as far as a tile has them.
  static unsigned bits(std::int32_t first, std::int32_t last, std::int32_t width) {
    const std::int32_t begin = std::max(first, 0) * width;
    const std::int32_t end = (std::min(last, kAcross - 1) + 1) * width;
    return (1U << end) - (1U << begin);
  }

  std::int32_t stride_, rows_, across_;
  std::vector<TileSquares> squares_;
  std::vector<std::int32_t> list_;
};

}  // namespace stope::topology
