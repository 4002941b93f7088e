#pragma once

#include <algorithm>
#include <cstdlib>

#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// Notes for the cells of a row from column `begin` to before `end` that of all obstacle cells the
/// one at `column` and `site_row` is nearest: each gets the edge of the side it sees.
inline void write_edges(const Outlines& outlines, EdgeGrid& edges, std::int32_t row,
                        std::int32_t begin, std::int32_t end, std::int32_t column,
                        std::int32_t site_row) {
  const std::int32_t rows = std::abs(row - site_row);
  const auto& sides =
      outlines.sides[static_cast<std::size_t>(edges[edges.index(column, site_row)])];
  // An obstacle is seen from the side of the larger difference; that side is free, or what lies
  // there would be nearer.
  const std::int32_t west = std::clamp(column - rows, begin, end);
  const std::int32_t east = std::clamp(column + rows + 1, west, end);
  std::int32_t* cells = edges.padded_row(row) + 1;
  std::fill(cells + begin, cells + west, sides[kWest]);
  std::fill(cells + west, cells + east, sides[site_row < row ? kNorth : kSouth]);
  std::fill(cells + east, cells + end, sides[kEast]);
}

}  // namespace stope::topology
