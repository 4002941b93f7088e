#pragma once

#include "plugins/topology/regions/grow_regions.hpp"
#include "plugins/topology/regions/moved_cells.hpp"

namespace stope::topology {

/// Makes regions that have grown from the points of an earlier ground those that grow from the
/// points of this one, as grow_regions would. `changed` has all squares in which growth sees
/// another ground or other points, and gets those with cells that another region or none has grown
/// into now. What has moved is noted, but in cells that are open now. The rule is the earlier one.
/// Gives the number of regions that are as they were. Cost: a look at every point, and the growth
/// of the other regions.
std::size_t regrow_regions(const Ground& ground,
                           const std::vector<std::vector<GrowthPoint>>& groups,
                           const GrowthRule& rule, const Checkpoint& checkpoint,
                           GrownRegions& grown, ChangedSquares& changed, MovedCells& moved);

}  // namespace stope::topology
