#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// Gives a value to the cells from `begin` to before `end`. Cells before them, as far as `floor`,
/// lose theirs: so whole vectors can be stored, and rows are filled from east to west.
inline void fill_westwards(std::int32_t* cells, std::int32_t floor, std::int32_t begin,
                           std::int32_t end, std::int32_t value) {
  constexpr std::int32_t kLanes = 4;
  if (begin - floor < kLanes) {
    std::fill(cells + begin, cells + end, value);
    return;
  }
  const std::array<std::int32_t, kLanes> lanes{value, value, value, value};
  while (end > begin) {
    end -= kLanes;
    std::memcpy(cells + end, lanes.data(), sizeof lanes);
  }
}

/// Notes for the cells of a row from column `begin` to before `end` that of all obstacle cells the
/// one at `column` and `site_row` is nearest: each gets the edge of the side it sees. Cells before
/// them, as far as `floor`, lose what they had.
inline void write_edges(const Outlines& outlines, EdgeGrid& edges, std::int32_t row,
                        std::int32_t floor, std::int32_t begin, std::int32_t end,
                        std::int32_t column, std::int32_t site_row) {
  const std::int32_t rows = std::abs(row - site_row);
  const auto& sides =
      outlines.sides[static_cast<std::size_t>(edges[edges.index(column, site_row)])];
  const OutlineEdge facing = sides[site_row < row ? kNorth : kSouth];
  std::int32_t* cells = edges.padded_row(row) + 1;
  // An obstacle is seen from the side of the larger difference; that side is free, or what lies
  // there would be nearer.
  const std::int32_t west = column - rows, east = column + rows + 1;
  if (west <= begin && end <= east) {
    fill_westwards(cells, floor, begin, end, facing);
    return;
  }
  const std::int32_t middle = std::clamp(west, begin, end), last = std::clamp(east, middle, end);
  fill_westwards(cells, floor, last, end, sides[kEast]);
  fill_westwards(cells, floor, middle, last, facing);
  fill_westwards(cells, floor, begin, middle, sides[kWest]);
}

}  // namespace stope::topology
