#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// Regions of less than `least_area` cells join the neighbour they are most open to, the smallest
/// first; one to which there is a way, of a squared clearance of `least_squared` or more, if there
/// is. Notes the names of those that no way joins. `contacts` are those of all tiles.
void join_small(RegionSet& set, const TileParts& tiles, const std::vector<Contact>& contacts,
                double least_area, std::int32_t least_squared);

/// The same regions with other numbers: `now` has, by number, the one that each is a part of.
void renumber(RegionSet& set, const std::vector<std::int32_t>& now);

}  // namespace stope::topology
