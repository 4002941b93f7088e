#pragma once

#include <vector>

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// Where two regions touch.
struct Border {
  std::int32_t first = 0, second = 0;         ///< regions, the lower first
  std::int64_t steps = 0;                     ///< pairs of neighbouring cells across it
  CellIndex first_door = 0, second_door = 0;  ///< the pair with the most clearance
  std::int32_t squared = 0;                   ///< squared clearance there, the smaller of the two
};

/// The borders of all regions, in increasing order. Only free cells touch, 8-connected.
std::vector<Border> find_borders(const Ground& ground, const RegionCells& regions,
                                 const Checkpoint& checkpoint);

}  // namespace stope::topology
