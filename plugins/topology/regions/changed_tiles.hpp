#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stope::topology {

/// Which parts of a grid differ, in squares of a few cells: quick to ask, never too few.
class ChangedTiles {
 public:
  ChangedTiles() = default;
  ChangedTiles(std::int32_t width, std::int32_t height)
      : columns_(width / kSide + 1),
        rows_(height / kSide + 1),
        tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

  /// All cells within `reach` of a cell, as a square.
  void add(std::int32_t column, std::int32_t row, std::int32_t reach = 0) {
    visit(column, row, reach, [](std::uint8_t& tile) {
      tile = 1;
      return false;
    });
  }
  bool touch(std::int32_t column, std::int32_t row, std::int32_t reach) {
    return visit(column, row, reach, [](std::uint8_t& tile) { return tile != 0; });
  }
  bool any() const {
    return std::any_of(tiles_.begin(), tiles_.end(), [](std::uint8_t tile) { return tile != 0; });
  }

 private:
  static constexpr std::int32_t kSide = 8;

  template <class Stop>
  bool visit(std::int32_t column, std::int32_t row, std::int32_t reach, Stop&& stop) {
    const std::int32_t left = std::max(column - reach, 0) / kSide;
    const std::int32_t right = std::min((column + reach) / kSide, columns_ - 1);
    const std::int32_t bottom = std::max(row - reach, 0) / kSide;
    const std::int32_t top = std::min((row + reach) / kSide, rows_ - 1);
    for (std::int32_t y = bottom; y <= top; ++y)
      for (std::int32_t x = left; x <= right; ++x)
        if (stop(tiles_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(x)]))
          return true;
    return false;
  }

  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> tiles_;
};

}  // namespace stope::topology
