#pragma once

#include <cstdint>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::fusion {

/// What becomes of a cell: by its prior value times 256, plus its live value.
using CellTable = std::vector<std::uint8_t>;

/// A table of all pairs of values, from a function of both.
template <class Rule>
CellTable make_table(const Rule& rule) {
  CellTable table;
  table.reserve(65536);
  for (int prior = 0; prior < 256; ++prior) {
    for (int live = 0; live < 256; ++live)
      table.push_back(rule(static_cast<std::uint8_t>(prior), static_cast<std::uint8_t>(live)));
  }
  return table;
}

/// Lays both grids over each other and joins them cell by cell. The result has the prior grid's
/// resolution, yaw and lattice, and spans both. A live grid on another lattice is looked up at the
/// cells' centres; a finer one gives the highest known value of several places in the cell, so that
/// thin obstacles are not lost. In parallel; O(cells of the result).
OccupancyGrid fuse(const OccupancyGrid& prior, const OccupancyGrid& live, const CellTable& table);

}  // namespace stope::fusion
