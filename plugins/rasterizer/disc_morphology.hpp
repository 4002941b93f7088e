#pragma once

#include <cstdint>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::rasterizer {

/// A mask over a grid: row-major, 1 set, 0 not.
struct Mask {
  std::int32_t width = 0, height = 0;
  std::vector<std::uint8_t> cells;
};

/// The cells of a grid that hold exactly `value`.
Mask cells_equal(const OccupancyGrid& grid, std::uint8_t value);

/// Sets every cell whose centre lies within `radius` cells of a set cell's centre. Exact. O(cells).
Mask dilate(const Mask& mask, double radius);

/// Closes gaps: dilates, then takes back what only the dilation reached. Set cells stay set; beyond
/// the grid's edge everything counts as set while taking back, so nothing is lost there. O(cells).
Mask close(const Mask& mask, double radius);

}  // namespace stope::rasterizer
