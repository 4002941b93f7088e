#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/region_memo.hpp"

namespace stope::topology {

/// The separate doors between regions, in the order of find_borders and of one pair the clearest
/// first, which is the pair's border. Cells are closed squares, and a door is a connected piece of
/// what two regions have in common: edges and corners of their free cells. Those with a squared
/// clearance of less than `least` are left out, but never a pair's clearest. Doors of two regions
/// that are the `same` as in the memo's map are that map's.
std::vector<Door> find_doors(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                             const RegionSet& set, const std::vector<Contact>& contacts,
                             std::int32_t least, const SameRegions& same, const RegionMemo& memo,
                             const Checkpoint& checkpoint);

/// The borders as doors, one for each two regions, by the same rule.
std::vector<Door> doors_at_borders(const std::vector<Border>& borders, const SameRegions& same,
                                   const RegionMemo& memo);

}  // namespace stope::topology
