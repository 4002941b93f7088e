#pragma once

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// Secondary growth: regions take the free cells around them, all at one pace, up to `reach` steps
/// (8-connected) from where they are. A cell that several reach at once goes to the one that came
/// by the cell of lower index. Cost: linear in the cells.
void absorb_rest(const Ground& ground, RegionCells& regions, std::int32_t reach,
                 const Checkpoint& checkpoint);

}  // namespace stope::topology
