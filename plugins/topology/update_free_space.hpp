#pragma once

#include <vector>

#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/free_space.hpp"

namespace stope::topology {

/// Finds the cells that become obstacles or free when the grid has changed within `window` (which
/// lies on it) and nowhere else. `space` is free space as it was, without the obstacles smaller
/// than `least_area` cells: one that grows becomes an obstacle with all its cells, one that is
/// eaten away may become free with all that are left, also outside of the window. `scratch` has the
/// size of the grid, is zero and is left so. Cost: linear in the window and least_area.
std::vector<CellIndex> find_flipped_cells(const OccupancyGrid& grid, const OccupancyRule& rule,
                                          double least_area, const CellWindow& window,
                                          const FreeSpace& space,
                                          PaddedGrid<std::uint8_t>& scratch);

}  // namespace stope::topology
