#pragma once

#include <cstdint>

#include "stope/payloads/grid_frame.hpp"

namespace stope::planner {

/// A rectangle of a grid's cells, which numbers them row by row.
struct CellBox {
  std::int32_t left = 0, bottom = 0, width = 0, height = 0;

  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  bool contains(Cell cell) const {
    return cell.column >= left && cell.row >= bottom && cell.column < left + width &&
           cell.row < bottom + height;
  }
  std::uint32_t place(Cell cell) const {
    return static_cast<std::uint32_t>(cell.row - bottom) * static_cast<std::uint32_t>(width) +
           static_cast<std::uint32_t>(cell.column - left);
  }
  Cell cell(std::uint32_t place) const {
    const auto columns = static_cast<std::uint32_t>(width);
    return {left + static_cast<std::int32_t>(place % columns),
            bottom + static_cast<std::int32_t>(place / columns)};
  }
};

}  // namespace stope::planner
