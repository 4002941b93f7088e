#pragma once

#include "plugins/topology/regions/ground.hpp"
#include "plugins/topology/regions/region_grower.hpp"
#include "stope/random.hpp"

namespace stope::topology {

/// Sections 2.1 and 2.2 of Wang et al. to the letter: growth points drawn at random from `points`
/// until `coverage` of the free cells are in a region, then each region grown a second time around
/// its centre, up to `second_radius` cells. Regions are counted from 1; obstacles can be in them.
RegionCells grow_as_printed(const Ground& ground, std::vector<CellIndex> points,
                            const GrowthRule& rule, double coverage, double second_radius,
                            Random random, const Checkpoint& checkpoint, std::int32_t& count);

}  // namespace stope::topology
