#pragma once

#include <cstdint>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/padded_grid.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::topology {

/// What is known of a cell, as bits. A corner of cells has the place of the cell at its lower left.
enum CellBits : std::uint8_t {
  kObstacle = 1,
  kOnOutline = 2,      ///< an obstacle with a free 4-neighbour
  kDividedEast = 4,    ///< a dividing line runs between this cell and its eastern neighbour
  kDividedNorth = 8,   ///< … and its northern neighbour
  kCorner = 16,        ///< a dividing line passes the cell's upper right corner
  kEndsHere = 32,      ///< … and a node must be made of it
  kTracedEast = 64,    ///< kDividedEast has become part of a line
  kTracedNorth = 128,  ///< kDividedNorth has become part of a line
};

/// Which cells of a grid count as obstacles.
struct OccupancyRule {
  double occupied_threshold = 0.5;  ///< least probability of an obstacle
  bool unknown_is_obstacle = true;
};

/// The least cell value that is an obstacle; 255 if none is.
std::uint8_t least_occupied(const OccupancyRule& rule);

/// CellBits of every cell. The margin is an obstacle: nobody knows what lies beyond the map.
using FreeSpace = PaddedGrid<std::uint8_t>;

/// Splits a grid into free cells and obstacles. Throws Error if its numbers contradict each other,
/// if it has more than 2^31 cells, or if no cell is free.
FreeSpace make_free_space(const OccupancyGrid& grid, const OccupancyRule& rule,
                          const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
