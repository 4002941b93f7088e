#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// Squares of a padded grid's cells, and which of them have been named.
class TileSet {
 public:
  static constexpr std::int32_t kSide = 32;

  TileSet(std::int32_t width, std::int32_t height)
      : stride_(width + 2),
        rows_(height + 2),
        across_((stride_ + kSide - 1) / kSide),
        named_(static_cast<std::size_t>(across_) *
                   static_cast<std::size_t>((rows_ + kSide - 1) / kSide),
               0) {}

  /// How many tiles there are.
  std::size_t size() const { return named_.size(); }
  std::int32_t tile_of(CellIndex cell) const {
    return cell / stride_ / kSide * across_ + cell % stride_ / kSide;
  }
  bool has(std::int32_t tile) const { return named_[static_cast<std::size_t>(tile)] != 0; }
  /// Those named, in the order they were.
  const std::vector<std::int32_t>& list() const { return list_; }

  void add(std::int32_t tile) {
    if (has(tile)) return;
    named_[static_cast<std::size_t>(tile)] = 1;
    list_.push_back(tile);
  }
  /// All tiles with cells from (left, bottom) to (right, top), both included, as far as they exist;
  /// the margin is column and row -1.
  void add(std::int32_t left, std::int32_t bottom, std::int32_t right, std::int32_t top) {
    left = std::max(left + 1, 0), bottom = std::max(bottom + 1, 0);
    right = std::min(right + 1, stride_ - 1), top = std::min(top + 1, rows_ - 1);
    for (std::int32_t y = bottom / kSide; y <= top / kSide && bottom <= top; ++y)
      for (std::int32_t x = left / kSide; x <= right / kSide && left <= right; ++x)
        add(y * across_ + x);
  }
  /// Whether any of those has been named.
  bool has_any(std::int32_t left, std::int32_t bottom, std::int32_t right, std::int32_t top) const {
    left = std::max(left + 1, 0), bottom = std::max(bottom + 1, 0);
    right = std::min(right + 1, stride_ - 1), top = std::min(top + 1, rows_ - 1);
    for (std::int32_t y = bottom / kSide; y <= top / kSide && bottom <= top; ++y)
      for (std::int32_t x = left / kSide; x <= right / kSide && left <= right; ++x)
        if (has(y * across_ + x)) return true;
    return false;
  }
  void add_all() {
    for (std::size_t tile = 0; tile < named_.size(); ++tile) add(static_cast<std::int32_t>(tile));
  }
  void clear() {
    for (const std::int32_t tile : list_) named_[static_cast<std::size_t>(tile)] = 0;
    list_.clear();
  }

  /// Calls visit(first cell, count) for each row of a tile.
  template <class Visit>
  void for_each_row(std::int32_t tile, Visit visit) const {
    const std::int32_t left = tile % across_ * kSide, bottom = tile / across_ * kSide;
    const std::int32_t count = std::min(kSide, stride_ - left);
    for (std::int32_t row = bottom; row < std::min(bottom + kSide, rows_); ++row)
      visit(row * stride_ + left, count);
  }

 private:
  std::int32_t stride_, rows_, across_;
  std::vector<std::uint8_t> named_;
  std::vector<std::int32_t> list_;
};

}  // namespace stope::topology
