#pragma once

#include "plugins/topology/regions/grow_regions.hpp"
#include "plugins/topology/regions/moved_cells.hpp"

namespace stope::topology {

/// Secondary growth: regions take the open cells around them, all at one pace, up to `reach` steps
/// (8-connected) from where they are. A cell that several reach at once goes to the one that comes
/// from the cell of the lowest index. Cells that are taken stay open to growth.
void absorb_rest(const Ground& ground, GrownRegions& grown, std::int32_t reach,
                 const Checkpoint& checkpoint);

/// The same after a change: `changed` are all squares with cells that are another region's or
/// nobody's by growth now. What has moved is noted. Cost: these squares, and the pieces of what is
/// left over by growth that touch them.
void absorb_again(const Ground& ground, GrownRegions& grown, std::int32_t reach,
                  const ChangedSquares& changed, MovedCells& moved, const Checkpoint& checkpoint);

}  // namespace stope::topology
